//! The entry point for antialiased drawing: a target that can be read back.

use crate::{
    coverage::Coverage,
    surface::{Span, Target},
};

/// The part of a [`BlendTarget`] that only zrow's own shapes call, and that only its own targets have: it seals that trait.
pub trait BatchBlend: Target {
    /// Draws a colour over a span that lies inside the target's window or is empty.
    ///
    /// # Errors
    /// The target's own error.
    fn blend_clipped_span(&mut self, span: Span, color: Self::Color, alpha: Coverage) -> Result<(), Self::Error>;
}

/// A target that mixes what is drawn with what is there already.
///
/// [`Band`](crate::band::Band) is one, and [`InLinearLight`](crate::band::InLinearLight) makes it mix light. What is handed
/// over is drawn at once over all that was drawn before it, as all targets do: painter's order. A display that cannot be
/// read back is none.
pub trait BlendTarget: BatchBlend {
    /// Draws a colour over the visible pixels of a span, each to the same alpha: 0 draws nothing and 255 is a fill.
    ///
    /// # Errors
    /// The target's own error.
    fn blend_span(&mut self, span: Span, color: Self::Color, alpha: Coverage) -> Result<(), Self::Error> {
        let visible = span.clipped_to(&self.window());
        self.blend_clipped_span(visible, color, alpha)
    }
}
