//! What a style makes of a shape for antialiasing: the outline of its fill, and over it the outline of its stroke.

use core::fmt;

use embedded_graphics::pixelcolor::PixelColor;

use crate::{
    draw::{FillRule, PrimitiveStyle, SubOutline},
    geometry::{InputError, Window},
};

/// An outline in one colour, to be blended over what lies below it.
#[derive(Copy, Clone)]
pub struct Layer<'o, C> {
    /// The outline, in 1/256 pixel.
    pub outline: &'o dyn SubOutline,
    /// The rule by which its inside is filled.
    pub fill_rule: FillRule,
    /// The colour of the inside.
    pub color: C,
}

impl<C: fmt::Debug> fmt::Debug for Layer<'_, C> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Layer")
            .field("fill_rule", &self.fill_rule)
            .field("color", &self.color)
            .finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl<C> defmt::Format for Layer<'_, C> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Layer, {}", self.fill_rule);
    }
}

impl<'o, C> Layer<'o, C> {
    /// The inside of an outline by the nonzero rule.
    pub(crate) const fn new(outline: &'o dyn SubOutline, color: C) -> Self {
        Self {
            outline,
            fill_rule: FillRule::NonZero,
            color,
        }
    }
}

/// A function that takes the layers of a shape, from the lowest one on.
pub type LayerSink<'s, C> = dyn FnMut(&Layer<'_, C>) -> Result<(), InputError> + 's;

/// A shape whose fill and stroke have outlines: it can be drawn antialiased in a [`PrimitiveStyle`].
///
/// Where both are drawn, the fill reaches to the middle of the stroke, so that nothing of what lies below shows between
/// them.
pub trait OutlinedShape {
    /// Calls `layer` with the outline of the fill and then with that of the stroke, if they are not empty and have a
    /// colour.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where an outline leaves the domain of [`Sub8`](crate::geometry::Sub8). The first
    /// error that `layer` returns.
    #[doc(hidden)]
    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError>;

    /// Whether a window may show a pixel of the shape with a stroke of that width: a quick test of rows, `true` where
    /// there is none.
    #[doc(hidden)]
    fn may_meet(&self, _window: &Window, _stroke_width: u32) -> bool {
        true
    }
}

impl<S: OutlinedShape> OutlinedShape for &S {
    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        S::layers(self, style, layer)
    }

    fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
        S::may_meet(self, window, stroke_width)
    }
}
