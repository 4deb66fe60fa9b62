//! The entry point for antialiased drawing: a target that can be read back.

use crate::{
    coverage::Coverage,
    surface::{Clipped, Span, Target},
};

/// A target that mixes what is drawn with what is there already.
///
/// [`Band`](crate::band::Band) is one, and [`InLinearLight`](crate::band::InLinearLight) makes it mix light. What is handed
/// over is drawn at once over all that was drawn before it, as all targets do: painter's order. A display that cannot be
/// read back is none.
pub trait BlendTarget: Target {
    /// Draws a colour over the visible pixels of a span, each to the same alpha: 0 draws nothing and 255 is a fill.
    ///
    /// # Errors
    /// The target's own.
    fn blend_span(&mut self, span: Span, color: Self::Color, alpha: Coverage) -> Result<(), Self::Error>;

    #[doc(hidden)]
    fn blend_clipped_span(
        &mut self,
        Clipped(span): Clipped<Span>,
        color: Self::Color,
        alpha: Coverage,
    ) -> Result<(), Self::Error> {
        self.blend_span(span, color, alpha)
    }
}
