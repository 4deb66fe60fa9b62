//! Colour of a fragment.
//!
//! A shader is one file with the signature of [`Shade`]; the row loop of the depth row is generic over it, so that each
//! shader gets its own loop and carries only what it interpolates. There is one so far, [`Flat`].

mod flat;

pub use flat::Flat;

/// The colours of a face along a span, from left to right.
pub trait Shade<W> {
    /// The word of the fragment at the current pixel.
    fn word(&self) -> W;

    /// Moves on to the next pixel of the row, whether the last fragment was visible or not.
    fn step_right(&mut self);
}
