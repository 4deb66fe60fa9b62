//! Colour of a fragment, and of the pixels of a 2D shape.
//!
//! A shader is one file that implements the crate's own trait `Shade`; the row loop of the depth row is generic over it, so that each
//! shader gets its own loop and carries only what it interpolates. There is one so far, flat shading: one colour a face.
//!
//! A paint is one file with the signature of [`Paint`]: [`Pattern`], [`LinearGradient`], [`RadialGradient`].
//! [`Target::painted`](crate::band::Target::painted) makes a target on which any shape is drawn in one.
//!
//! [`ChannelColor`] mixes a colour with what is below it; [`BlendTarget`] is the entry point of what is drawn so.
//!
//! A [`SampleFilter`] weighs the samples of supersampling, and a [`SampleTarget`] takes those of multisampling.

mod blend;
mod blend_target;
mod channel_color;
mod flat;
pub(crate) mod layout;
mod ordered_threshold;
mod paint;
pub(crate) mod samples;
mod span_blender;

pub use crate::surface::Paint;
pub(crate) use blend::{Encoded, Gamma, TransferFunction};
pub(crate) use blend_target::BatchBlend;
pub use blend_target::BlendTarget;
pub use channel_color::ChannelColor;
pub(crate) use channel_color::blend_words;
pub(crate) use flat::Flat;
pub use paint::{LinearGradient, Pattern, RadialGradient, Ramp};
pub use samples::{ConeFilter, SampleFilter, SampleTarget};
pub(crate) use samples::{SampleSum, SampleWeights};
pub(crate) use span_blender::SpanBlender;

/// The colours of a face along a span, from left to right.
pub(crate) trait Shade<W> {
    /// The word of the fragment at the current pixel.
    fn word(&self) -> W;

    /// Moves on to the next pixel of the row, whether the last fragment was visible or not.
    fn step_right(&mut self);
}
