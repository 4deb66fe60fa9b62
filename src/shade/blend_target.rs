//! The door for antialiased drawing: a target that can be read back.

use crate::{
    coverage::Share,
    target::{Span, Target},
};

/// A target that mixes what is drawn with what is there already.
///
/// [`Band`](crate::band::Band) is one, and [`InLinearLight`](crate::band::InLinearLight) makes it mix light. What is handed
/// over is drawn at once over all that was drawn before it, as all targets do: painter's order. A display that cannot be
/// read back is none.
pub trait BlendTarget: Target {
    /// Draws a colour over the pixels of a span, each to the same share: 0 draws nothing and 255 is a fill.
    ///
    /// As for [`fill_span`](Target::fill_span), the span is inside the window; where it is not, some pixels may be drawn or
    /// none, and nothing panics.
    ///
    /// # Errors
    /// The target's own.
    fn blend_span(&mut self, span: Span, color: Self::Color, share: Share) -> Result<(), Self::Error>;
}
