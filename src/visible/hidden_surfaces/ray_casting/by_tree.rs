//! Ray casting through a tree of boxes: for each pixel a ray, down to the faces that it may meet.
//!
//! A ray remembers the nearest depth that it has met, and looks into no box that is farther away.
//!
//! Guarantees: the picture of the depth row. Cost: building the tree for each window that is drawn, n log n; a walk down the tree
//! for each pixel, with a test of the sides of each face that it comes to and the plane of each that covers the pixel.
//!
//! Source: Appel 1968, "Some techniques for shading machine renderings of solids"; Rubin and Whitted 1980, "A 3-dimensional
//! representation for fast rendering of complex scenes".

use crate::{
    geometry::{TooSmall, Window},
    shade::Shading,
    surface::Span,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::{FaceTable, NONE, covers},
        hidden_surfaces::{
            placed::{nearer_of, paint_row_reporting},
            ray_casting::box_tree::BoxTree,
        },
        painter::Painter,
        visibility::{Method, NewMethod},
        work::Work,
    },
};

/// Ray casting through a tree of boxes ([`Visibility`](crate::visible::Visibility)), for at most so many faces that begin above the lower side of the window.
///
/// Take it for huge scenes that are seen through few pixels. For one pixel, as where a finger touches the panel,
/// [`Prepared::face_at`](crate::scene::Prepared::face_at) needs no tree.
///
/// RAM: 14 bytes a face, and 4.
///
/// Source: Appel 1968; Rubin and Whitted 1980.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RayCasting<const FACES: usize> {
    tree: BoxTree<FACES>,
    faces_tested: u32,
}

impl<const FACES: usize> RayCasting<FACES> {
    /// A tree without faces.
    pub const fn new() -> Self {
        Self {
            tree: BoxTree::new(),
            faces_tested: 0,
        }
    }

    /// How often a ray was tested to meet a face since the method was made, modulo 2^32.
    pub const fn faces_tested(&self) -> u32 {
        self.faces_tested
    }

    /// The face that the ray through a pixel of a row meets first, of so many faces, or [`NONE`]. `at` are the first column of
    /// the row and the row; the column counts from there.
    fn cast<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        count: usize,
        (at, column): ([i32; 2], i32),
        painter: &mut impl Painter<S, H>,
    ) -> u16 {
        let [first_column, row] = at;
        let pixel = [first_column + column, row];
        let (_, node) = self.tree.fold(
            (count, pixel),
            (D::FARTHEST, NONE),
            |(depth, _)| depth.units(),
            |seen, node| {
                self.faces_tested = self.faces_tested.wrapping_add(1);
                painter.report(|| Work::Tested {
                    face: faces.order(node).into(),
                    span: Span::new(row, first_column + column, first_column + column + 1),
                });
                if covers(faces, node, first_column + column, row) {
                    nearer_of(faces, node, (at, column), seen)
                } else {
                    seen
                }
            },
        );
        node
    }
}

impl<const FACES: usize> Default for RayCasting<FACES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<D: DepthWidth, const FACES: usize> NewMethod<D> for RayCasting<FACES> {
    const NEW: Self = Self::new();
}

impl<D: DepthWidth, const FACES: usize> Method<D> for RayCasting<FACES> {
    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        let count = self.tree.build(faces, window, painter)?;
        for row in window.top..window.bottom {
            let at = [window.left, row];
            paint_row_reporting(painter, faces, at, 0..window.width() as i32, |painter, column| {
                self.cast(faces, count, (at, column), painter)
            });
        }
        Ok(())
    }
}
