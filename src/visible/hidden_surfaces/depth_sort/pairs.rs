//! The tests of a pair of faces that need their corners alone.

use crate::{
    geometry::Window,
    shade::Shading,
    view::{DepthWidth, Position, ScreenPrecision, ScreenVertex},
    visible::{edge::row_after, face_table::FaceTable},
};

/// Whether a face is in front of another one in pixels that both cover.
#[derive(Debug, Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Relation {
    /// In none of them, or there are none.
    Behind,
    /// In some of them, perhaps in all.
    InFront,
    /// In some of them, and in others not.
    Penetrates,
}

/// On which side of a plane all corners of a face are, so far from it that stored depths say the same.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) enum Side {
    Behind,
    InFront,
    Neither,
}

impl Side {
    /// The side of the face that has the plane, where both faces cover a pixel.
    pub(super) fn opposite(self) -> Self {
        match self {
            Self::Behind => Self::InFront,
            Self::InFront => Self::Behind,
            Self::Neither => Self::Neither,
        }
    }
}

/// The corners of a face, and the least and the greatest of their coordinates.
pub(super) struct Extents<'t, S: ScreenPrecision, D: DepthWidth> {
    pub(super) node: u16,
    pub(super) corners: [&'t ScreenVertex<S, D>; 3],
}

impl<'t, S: ScreenPrecision, D: DepthWidth> Extents<'t, S, D> {
    /// The face of a node.
    #[inline]
    pub(super) fn of<H: Shading>(faces: &'t impl FaceTable<S, D, H>, node: u16) -> Option<Self> {
        let (corners, _) = faces.face(node)?;
        Some(Self { node, corners })
    }

    /// The depth of the farthest corner, in units.
    #[inline]
    pub(super) fn farthest(&self) -> i32 {
        let [a, b, c] = self.corners;
        a.z.units().min(b.z.units()).min(c.z.units())
    }

    /// The depth of the nearest corner, in units.
    #[inline]
    pub(super) fn nearest(&self) -> i32 {
        let [a, b, c] = self.corners;
        a.z.units().max(b.z.units()).max(c.z.units())
    }

    /// The first row that the face can cover, and the one after the last.
    #[inline]
    pub(super) fn rows(&self) -> [i32; 2] {
        let [a, b, c] = self.corners;
        range::<S>(a.y_units(), b.y_units(), c.y_units())
    }

    /// The first column that the face can cover, and the one after the last.
    #[inline]
    pub(super) fn columns(&self) -> [i32; 2] {
        let [a, b, c] = self.corners;
        range::<S>(a.x_units(), b.x_units(), c.x_units())
    }

    /// Whether the face can cover pixels of a window.
    pub(super) fn meets(&self, window: &Window) -> bool {
        meet(self.rows(), [window.top, window.bottom]) && meet(self.columns(), [window.left, window.right])
    }

    /// The pixels that the face can cover.
    #[inline]
    pub(super) fn pixels(&self) -> PixelExtents {
        PixelExtents {
            rows: self.rows(),
            columns: self.columns(),
        }
    }
}

/// The rows and columns that a face can cover, to be compared with those of many others.
#[derive(Debug, Copy, Clone)]
pub(super) struct PixelExtents {
    rows: [i32; 2],
    columns: [i32; 2],
}

impl PixelExtents {
    /// Test A: whether the face can cover a row that another face covers, and a column.
    #[inline]
    pub(super) fn meet<S: ScreenPrecision, D: DepthWidth>(&self, other: &Extents<'_, S, D>) -> bool {
        meet(self.rows, other.rows()) && meet(self.columns, other.columns())
    }
}

/// The pixels between the least and the greatest of three coordinates.
#[inline]
fn range<S: ScreenPrecision>(a: i32, b: i32, c: i32) -> [i32; 2] {
    [row_after::<S>(a.min(b).min(c)), row_after::<S>(a.max(b).max(c))]
}

/// Whether two ranges have a number in common.
#[inline]
fn meet([start, end]: [i32; 2], [other_start, other_end]: [i32; 2]) -> bool {
    start.max(other_start) < end.min(other_end)
}

/// Whether of two faces that are as near in a pixel the first one is seen.
pub(super) fn comes_first<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    face: &Extents<'_, S, D>,
    other: &Extents<'_, S, D>,
) -> bool {
    // What is mixed with what is behind it is itself behind an opaque face that is as near.
    let in_layers = |face: &Extents<'_, S, D>| (faces.is_translucent(face.node), faces.order(face.node));
    let (order, of_other) = (in_layers(face), in_layers(other));
    // Parts of a face that the window's planes cut come in the order of the table.
    let in_table = |face: &Extents<'_, S, D>| (face.rows(), face.node);
    order < of_other || (order == of_other && in_table(face) < in_table(other))
}

/// How far two stored depths can be moved towards each other by rounding, in 1/256 unit, with 32 bits: each plane is wrong by
/// half as much as the viewport has columns and rows.
fn error_32(viewport: &Window) -> i64 {
    i64::from(viewport.width()) + i64::from(viewport.height()) + 16
}

/// How many units nearer than the nearest corner of a face the farthest one of another face has to be for that face to be
/// nowhere farther; with one unit less it could be. With 16 bits no stored depth is outside of those of the corners.
#[inline]
pub(super) fn depth_margin<D: DepthWidth>(viewport: &Window) -> i32 {
    if D::FRACTION_BITS == 16 {
        0
    } else {
        (error_32(viewport) >> D::FRACTION_BITS) as i32 + 1
    }
}

/// How far from a plane, times twice the area of its face, a corner has to be for the stored depths to be in the same order, or
/// the same; and for them to be different.
fn plane_margins<D: DepthWidth>(area: i64, viewport: &Window) -> [i64; 2] {
    if D::FRACTION_BITS == 16 {
        // Each plane is wrong by 1/6 unit at most, and then rounded to a unit.
        let half = (area + 1) >> 1;
        [half, half + area]
    } else {
        let steps = (area >> D::FRACTION_BITS) + 1;
        let even = steps * error_32(viewport);
        [even, even + steps]
    }
}

/// Tests B and C: on which side of the plane of a face the corners of another face are. `is_first` says that this one is seen
/// where both are as near.
pub(super) fn side_of_plane<S: ScreenPrecision, D: DepthWidth>(
    corners: [&ScreenVertex<S, D>; 3],
    [a, b, c]: [&ScreenVertex<S, D>; 3],
    is_first: bool,
    viewport: &Window,
) -> Side {
    // With 1/256 pixel and depths of 24 bits, numbers fit where differences of positions are below 1,024 pixels; else they
    // do in the whole domain: below 2^22 times 2^39, or 2^15 times 2^40.
    let limit = if S::FRACTION_BITS > 4 && D::FRACTION_BITS < 16 {
        1 << 18
    } else {
        i32::MAX
    };
    let is_large = |difference: Position| difference.x.abs() >= limit || difference.y.abs() >= limit;
    let origin = a.position();
    let (right, left) = (b.position().minus(origin), c.position().minus(origin));
    if is_large(right) || is_large(left) {
        return Side::Neither;
    }
    let difference = |a: i32, b: i32, c: i32, d: i32| i64::from(a) * i64::from(b) - i64::from(c) * i64::from(d);
    let (z1, z2) = (b.z.units() - a.z.units(), c.z.units() - a.z.units());
    let area = difference(right.x, left.y, left.x, right.y);
    let (per_x, per_y) = (difference(z1, left.y, z2, right.y), difference(right.x, z2, left.x, z1));
    let [even, strict] = plane_margins::<D>(area, viewport);
    let (in_front, behind) = if is_first { (even, strict) } else { (strict, even) };
    let mut side = Side::Neither;
    for corner in corners {
        let position = corner.position().minus(origin);
        if is_large(position) {
            return Side::Neither;
        }
        let depth = i64::from(corner.z.units() - a.z.units()) * area;
        let nearer = depth - per_x * i64::from(position.x) - per_y * i64::from(position.y);
        let this = if nearer >= in_front {
            Side::InFront
        } else if nearer <= -behind {
            Side::Behind
        } else {
            return Side::Neither;
        };
        if side != Side::Neither && side != this {
            return Side::Neither;
        }
        side = this;
    }
    side
}

/// Test D: whether an edge of one of two faces has the other one on its outer side, so that they have no pixel in common. A
/// pixel centre on such an edge is covered by one of them at most: by the top-left rule it belongs to the side on which it
/// would be if it were moved a little to the right, and less down.
pub(super) fn are_apart<S: ScreenPrecision, D: DepthWidth>(
    one: [&ScreenVertex<S, D>; 3],
    other: [&ScreenVertex<S, D>; 3],
) -> bool {
    has_outside(one, other) || has_outside(other, one)
}

/// Whether an edge of a face, whose corners run clockwise, has all corners of another face on its outer side.
fn has_outside<S: ScreenPrecision, D: DepthWidth>(
    [a, b, c]: [&ScreenVertex<S, D>; 3],
    other: [&ScreenVertex<S, D>; 3],
) -> bool {
    [(a, b), (b, c), (c, a)].into_iter().any(|(start, end)| {
        let size = end.position().minus(start.position());
        other.into_iter().all(|corner| {
            let from_start = corner.position().minus(start.position());
            i64::from(size.x) * i64::from(from_start.y) <= i64::from(size.y) * i64::from(from_start.x)
        })
    })
}
