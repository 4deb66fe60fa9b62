//! zrow's style of fill and stroke, with the names and the meaning of embedded-graphics' `PrimitiveStyle`.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{self, StrokeAlignment},
};

use crate::draw::Antialiased;

/// Fill and stroke of a shape. Replaces `embedded_graphics::primitives::PrimitiveStyle`, and converts from and to it.
///
/// A style that [`new`](Self::new), [`with_fill`](Self::with_fill) and [`with_stroke`](Self::with_stroke) do not make comes
/// from embedded-graphics' builder:
///
/// ```
/// use embedded_graphics::{pixelcolor::{Rgb565, RgbColor}, primitives::PrimitiveStyleBuilder};
/// use zrow::draw::{PrimitiveStyle, StrokeAlignment};
///
/// let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
///     .stroke_color(Rgb565::RED)
///     .stroke_width(3)
///     .stroke_alignment(StrokeAlignment::Inside)
///     .fill_color(Rgb565::GREEN)
///     .build()
///     .into();
/// assert_eq!(style.inside_stroke_width(), 3);
/// ```
///
/// In a constant, where `into` cannot be called, its fields are set:
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use zrow::draw::PrimitiveStyle;
///
/// const STYLE: PrimitiveStyle<Rgb565> = {
///     let mut style = PrimitiveStyle::with_stroke(Rgb565::RED, 3);
///     style.fill_color = Some(Rgb565::GREEN);
///     style
/// };
/// # assert!(!STYLE.is_transparent());
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct PrimitiveStyle<C: PixelColor> {
    /// Colour of the inside; `None` leaves its pixels unchanged.
    pub fill_color: Option<C>,
    /// Colour of the stroke; `None` draws no stroke. The stroke's inner part is left out of the fill all the same,
    /// except in a [`ThinCircle`](crate::draw::ThinCircle), in a [`Path`](crate::draw::Path), and in an antialiased
    /// [`Polygon`](crate::draw::Polygon), [`SubArc`](crate::draw::SubArc) or [`SubLine`](crate::draw::SubLine).
    pub stroke_color: Option<C>,
    /// Width of the stroke in pixels; 0 is no stroke.
    pub stroke_width: u32,
    /// The position of the stroke: inside the outline, outside, or centred on it; of an odd width, the larger part of a
    /// centred stroke lies inside.
    pub stroke_alignment: StrokeAlignment,
}

impl<C: PixelColor> PrimitiveStyle<C> {
    /// A style that draws nothing.
    pub const fn new() -> Self {
        Self {
            fill_color: None,
            stroke_color: None,
            stroke_width: 0,
            stroke_alignment: StrokeAlignment::Center,
        }
    }

    /// A style with a stroke of this colour and width in pixels, centred on the outline, and without a fill.
    pub const fn with_stroke(stroke_color: C, stroke_width: u32) -> Self {
        Self {
            stroke_color: Some(stroke_color),
            stroke_width,
            ..Self::new()
        }
    }

    /// A style with a fill of this colour and without a stroke.
    pub const fn with_fill(fill_color: C) -> Self {
        Self {
            fill_color: Some(fill_color),
            ..Self::new()
        }
    }

    /// The style with antialiased edges, for shapes on [`Band::antialiased`](crate::band::Band::antialiased).
    pub const fn antialiased(self) -> Antialiased<Self> {
        Antialiased(self)
    }

    /// Whether the style draws nothing: it has neither a fill colour nor a stroke.
    pub fn is_transparent(&self) -> bool {
        self.effective_stroke_color().is_none() && self.fill_color.is_none()
    }

    /// The colour of the stroke; `None` where the stroke has no colour or its width is 0.
    pub fn effective_stroke_color(&self) -> Option<C> {
        self.stroke_color.filter(|_| self.stroke_width > 0)
    }

    /// The width of the stroke's part outside the outline, in pixels.
    pub const fn outside_stroke_width(&self) -> u32 {
        self.stroke_widths().1
    }

    /// The width of the stroke's part inside the outline, in pixels.
    pub const fn inside_stroke_width(&self) -> u32 {
        self.stroke_widths().0
    }

    /// The widths of the stroke's parts inside and outside the outline, in this order, in pixels.
    pub(crate) const fn stroke_widths(&self) -> (u32, u32) {
        let width = self.stroke_width;
        match self.stroke_alignment {
            StrokeAlignment::Inside => (width, 0),
            StrokeAlignment::Center => (width.saturating_add(1) / 2, width / 2),
            StrokeAlignment::Outside => (0, width),
        }
    }
}

impl<C: PixelColor> Default for PrimitiveStyle<C> {
    fn default() -> Self {
        Self::new()
    }
}

impl<C: PixelColor> From<primitives::PrimitiveStyle<C>> for PrimitiveStyle<C> {
    fn from(style: primitives::PrimitiveStyle<C>) -> Self {
        Self {
            fill_color: style.fill_color,
            stroke_color: style.stroke_color,
            stroke_width: style.stroke_width,
            stroke_alignment: style.stroke_alignment,
        }
    }
}

impl<C: PixelColor> From<PrimitiveStyle<C>> for primitives::PrimitiveStyle<C> {
    fn from(style: PrimitiveStyle<C>) -> Self {
        let mut theirs = Self::new();
        theirs.fill_color = style.fill_color;
        theirs.stroke_color = style.stroke_color;
        theirs.stroke_width = style.stroke_width;
        theirs.stroke_alignment = style.stroke_alignment;
        theirs
    }
}
