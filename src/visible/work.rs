//! The work that a method of visibility does to find its picture.

use crate::{geometry::Window, surface::Span};

/// One step of the work that a method of visibility does, which
/// [`Prepared::draw_by_with`](crate::scene::Prepared::draw_by_with) reports.
///
/// Columns and rows are those of the picture. A `face` is an index in the order of models and faces, as
/// [`Prepared::face_at`](crate::scene::Prepared::face_at) has it.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Work {
    /// Pixels of a row are painted in one face: the interval of a scan line, a row of a Warnock window, a run of pixels of a buffer.
    /// [`DepthSort`](crate::visible::DepthSort) paints from back to front, and later spans lie over earlier ones; every other
    /// method paints a pixel at most once.
    Painted {
        /// The face.
        face: usize,
        /// The pixels.
        span: Span,
    },
    /// A face is tested in pixels of a row: whether it is nearer than what is there, by
    /// [`DepthBuffer`](crate::visible::DepthBuffer), or first of all whether it covers the pixel, by
    /// [`OneDepth`](crate::visible::OneDepth) and [`RayCasting`](crate::visible::RayCasting).
    Tested {
        /// The face.
        face: usize,
        /// The pixels.
        span: Span,
    },
    /// A rectangle of pixels is looked at as a whole: a window of [`Warnock`](crate::visible::Warnock), which is divided if it
    /// has several faces and more than one pixel; a tile of [`TileBins`](crate::visible::TileBins); the box of a node in the tree of
    /// [`RayCasting`](crate::visible::RayCasting).
    Area {
        /// The pixels.
        window: Window,
        /// How many faces are in the list of the window or the tile, or below the node. Of a window whose list has no room for
        /// them, 65,535.
        faces: usize,
    },
    /// [`DepthSort`](crate::visible::DepthSort) splits a face, or a part of one, by the plane of another.
    Split {
        /// The face that is split.
        face: usize,
        /// The face whose plane splits it.
        by: usize,
    },
}
