//! What a style makes of a shape for antialiasing: the outline of its fill, and over it the outline of its stroke.

use core::fmt;

use embedded_graphics::{pixelcolor::PixelColor, primitives::StrokeAlignment};

use crate::{
    coverage::{Combination, edges::AntialiasedEdge},
    draw::{FillRule, PrimitiveStyle, SubOutline, antialiased::sub_outline::Corner},
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

/// A combination of a shape and its stroke, or of two contours, in one colour, to be blended over what lies below it.
#[derive(Copy, Clone)]
pub struct AlignedLayer<'o, C> {
    /// The outline of the shape and then that of the stroke, in 1/256 pixel.
    pub(crate) outline: &'o dyn SubOutline,
    /// How many edges of the shape are not level.
    pub(crate) edges_of_shape: u32,
    /// The rule by which the inside of the shape is filled.
    pub(crate) fill_rule: FillRule,
    /// What is drawn of the two.
    pub(crate) combination: Combination,
    /// The colour in which it is drawn.
    pub(crate) color: C,
}

impl<C: fmt::Debug> fmt::Debug for AlignedLayer<'_, C> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("AlignedLayer")
            .field("fill_rule", &self.fill_rule)
            .field("combination", &self.combination)
            .field("color", &self.color)
            .finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl<C> defmt::Format for AlignedLayer<'_, C> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "AlignedLayer, {}, {}", self.combination, self.fill_rule);
    }
}

/// The number of edges that are not level.
pub(crate) fn edges_with_height(edges: impl FnOnce(&mut dyn FnMut(Corner, Corner))) -> u32 {
    let mut count = 0u32;
    edges(&mut |from, to| {
        let is_level = AntialiasedEdge::from_units(from, to).is_none();
        count = count.saturating_add((!is_level).into());
    });
    count
}

/// A function that takes the layers of a shape that are cut off, from the lowest one on.
pub type AlignedSink<'s, C> = dyn FnMut(&AlignedLayer<'_, C>) -> Result<(), InputError> + 's;

/// A shape whose fill and stroke have outlines: it can be drawn antialiased in a [`PrimitiveStyle`].
///
/// Where both are drawn, the fill reaches to the middle of the stroke, so that nothing of what lies below shows between
/// them.
pub trait OutlinedShape {
    /// Whether [`is_cut_off`](Self::is_cut_off) may be true. A constant, so that what draws such layers is linked for such shapes
    /// only.
    #[doc(hidden)]
    const IS_CUT_OFF: bool = false;

    /// Whether an outline of the shape may be its own [mirror image](SubOutline::mirror). A constant, so that what draws such
    /// outlines is linked for such shapes only.
    #[doc(hidden)]
    const MAY_BE_MIRRORED: bool = false;

    /// Whether fill or stroke are what one outline cuts off from another one, so that [`aligned_layers`](Self::aligned_layers)
    /// has the layers: where not said otherwise, those of a stroke inside or outside of the shape.
    #[doc(hidden)]
    fn is_cut_off<C: PixelColor>(&self, style: &PrimitiveStyle<C>) -> bool {
        style.stroke_alignment != StrokeAlignment::Center && style.effective_stroke_color().is_some()
    }

    /// Calls `layer` with the outline of the fill and then with that of the stroke, if they are not empty and have a
    /// colour.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where an outline leaves the domain of [`Sub8`](crate::geometry::Sub8). The first
    /// error that `layer` returns.
    #[doc(hidden)]
    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError>;

    /// Calls `layer` with the fill of the shape and then with its stroke, where they are [cut off](Self::is_cut_off).
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the shape leaves the domain of [`Sub8`](crate::geometry::Sub8). The first error that `layer` returns.
    #[doc(hidden)]
    fn aligned_layers<C: PixelColor>(
        &self,
        _style: &PrimitiveStyle<C>,
        _layer: &mut AlignedSink<'_, C>,
    ) -> Result<(), InputError> {
        Ok(())
    }

    /// Whether a window may show a pixel of the shape with a stroke of that width: a quick test of rows, `true` where
    /// there is none.
    #[doc(hidden)]
    fn may_meet(&self, _window: &Window, _stroke_width: u32) -> bool {
        true
    }
}

impl<S: OutlinedShape> OutlinedShape for &S {
    const IS_CUT_OFF: bool = S::IS_CUT_OFF;
    const MAY_BE_MIRRORED: bool = S::MAY_BE_MIRRORED;

    fn is_cut_off<C: PixelColor>(&self, style: &PrimitiveStyle<C>) -> bool {
        S::is_cut_off(self, style)
    }

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        S::layers(self, style, layer)
    }

    fn aligned_layers<C: PixelColor>(
        &self,
        style: &PrimitiveStyle<C>,
        layer: &mut AlignedSink<'_, C>,
    ) -> Result<(), InputError> {
        S::aligned_layers(self, style, layer)
    }

    fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
        S::may_meet(self, window, stroke_width)
    }
}
