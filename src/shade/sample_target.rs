//! The door for multisampling: a target that keeps several samples of each pixel.

use crate::{
    coverage::SamplePattern,
    target::{Span, Target},
};

/// A target with samples of their own colours in each pixel.
///
/// [`Multisampled`](crate::band::Multisampled) is one, and [`Painted`](crate::draw::Painted) makes it take a paint. What
/// [`Target`] draws takes all samples of a pixel.
pub trait SampleTarget: Target {
    /// Where the samples are.
    type Pattern: SamplePattern;

    /// Gives the samples of a mask in each pixel of a span the same colour; the colour of a pixel is found once.
    ///
    /// Bit `n` of the mask is sample `n` of the pattern. As for [`fill_span`](Target::fill_span), the span is inside the
    /// window; where it is not, some pixels may be drawn or none, and nothing panics.
    ///
    /// # Errors
    /// The target's own.
    fn fill_samples(&mut self, span: Span, mask: u32, ink: Self::Ink) -> Result<(), Self::Error>;

    /// The same with a colour for each pixel, left to right.
    ///
    /// # Errors
    /// The target's own.
    fn set_samples<I>(&mut self, span: Span, mask: u32, colors: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Self::Color>;
}
