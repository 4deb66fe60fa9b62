//! Antialiasing: how much of a pixel a shape covers.
//!
//! A tier is one file with the signature of [`Coverage`]. There is one so far, [`CentreSample`]: a pixel is covered or
//! it is not.

mod centre_sample;

pub use centre_sample::CentreSample;

use heapless::VecView;

use crate::{
    geometry::Window,
    scan::{ActiveEdge, Edge, scanline_polygon::FillRule},
    target::Span,
};

/// How much of a pixel is covered: 0 is nothing, 255 all of it.
pub type Share = u8;

/// A tier of antialiasing: from the edges of a polygon to the share of each pixel.
pub trait Coverage {
    /// Hands over the visible pixels that have a share, in spans of the same share: rows top to bottom, left to right in
    /// each, each pixel at most once.
    ///
    /// The edges are a sorted edge table; the active table has room for all that cross one row.
    ///
    /// # Errors
    /// The first of `emit`.
    fn cover<E>(
        &self,
        edges: &[Edge],
        active: &mut VecView<ActiveEdge>,
        fill_rule: FillRule,
        window: &Window,
        emit: impl FnMut(Span, Share) -> Result<(), E>,
    ) -> Result<(), E>;
}
