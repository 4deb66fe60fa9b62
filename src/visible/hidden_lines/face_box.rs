//! The faces that may hide something, from the nearest one on, each with the pixels that it may cover.

use core::cmp::Reverse;

use crate::{
    geometry::TooSmall,
    scan::polygon::edge_table::shell_sort,
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::line_table::{LinePoint, LineTable},
};

/// The index of a face in its table, its nearest depth, and the pixels that it lies in. 16 bytes.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct FaceBox {
    /// The greatest depth of the corners, in units.
    pub(super) nearest: i32,
    pub(super) index: u16,
    pixels: PixelBox,
}

/// A rectangle of pixels, its sides included.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct PixelBox {
    left: i16,
    top: i16,
    right: i16,
    bottom: i16,
}

impl FaceBox {
    /// The entry of a new table: all bits are zero.
    pub(super) const EMPTY: Self = Self {
        nearest: 0,
        index: 0,
        pixels: PixelBox {
            left: 0,
            top: 0,
            right: 0,
            bottom: 0,
        },
    };

    /// Whether some pixels are among those of the face.
    #[inline]
    pub(super) const fn meets(&self, pixels: &PixelBox) -> bool {
        self.pixels.left <= pixels.right
            && self.pixels.right >= pixels.left
            && self.pixels.top <= pixels.bottom
            && self.pixels.bottom >= pixels.top
    }

    /// Whether the face has pixels with another one in common.
    pub(super) const fn meets_face(&self, other: &Self) -> bool {
        self.meets(&other.pixels)
    }
}

impl PixelBox {
    /// The pixels around points.
    pub(super) fn around<S: ScreenPrecision>(points: &[LinePoint]) -> Self {
        // The domain of either precision is less than 2^13 pixels to each side.
        let least = |of: fn(&LinePoint) -> i32| (points.iter().map(of).min().unwrap_or(0) >> S::FRACTION_BITS) as i16;
        let most = |of: fn(&LinePoint) -> i32| (points.iter().map(of).max().unwrap_or(0) >> S::FRACTION_BITS) as i16;
        Self {
            left: least(|point| point.x),
            top: least(|point| point.y),
            right: most(|point| point.x),
            bottom: most(|point| point.y),
        }
    }
}

/// Fills a list with the faces of a table that are seen, the nearest ones first.
///
/// # Errors
/// [`TooSmall::Faces`] with the number of faces, where the list has less room.
pub(super) fn list_faces<'l, S, D, T>(list: &'l mut [FaceBox], table: &T) -> Result<&'l [FaceBox], TooSmall>
where
    S: ScreenPrecision,
    D: DepthWidth,
    T: LineTable<S, D>,
{
    let needed = table.faces().filter(|face| face.is_seen).count();
    let Some(list) = list.get_mut(..needed) else {
        return Err(TooSmall::Faces(needed));
    };
    for (entry, face) in list.iter_mut().zip(table.faces().filter(|face| face.is_seen)) {
        let [a, b, c] = face.corners.map(|corner| corner.depth);
        *entry = FaceBox {
            nearest: a.max(b).max(c),
            // A table has at most 65,535 indices.
            index: face.index as u16,
            pixels: PixelBox::around::<S>(&face.corners),
        };
    }
    shell_sort(list, |face| Reverse(face.nearest));
    Ok(list)
}
