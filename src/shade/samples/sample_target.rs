//! The entry point for multisampling: a target that keeps several samples of each pixel.

use crate::{
    coverage::SamplePattern,
    surface::{Span, Target},
};

/// A target with samples of their own colours in each pixel.
///
/// [`Band::multisample`](crate::band::Band::multisample) makes one of a band, and [`painted`](Target::painted) one of that
/// which takes a paint. What [`Target`] draws takes all samples of a pixel.
pub trait SampleTarget: Target {
    /// The pattern that says where in a pixel its samples are.
    type Pattern: SamplePattern;

    /// Gives the samples of a mask in each visible pixel of a span the same colour; the colour of a pixel is found once.
    ///
    /// Bit `n` of the mask is sample `n` of the pattern.
    ///
    /// # Errors
    /// The target's own error.
    fn fill_samples(&mut self, span: Span, mask: u32, raw: Self::Raw) -> Result<(), Self::Error>;

    /// Gives the samples of a mask in each visible pixel of a span that pixel's colour. `colors` has those of all pixels of
    /// the span from left to right; a pixel without one stays as it is.
    ///
    /// # Errors
    /// The target's own error.
    fn set_samples<I>(&mut self, span: Span, mask: u32, colors: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Self::Color>;
}
