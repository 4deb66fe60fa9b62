//! What a style makes of a closed shape: an area and a hole in it, each in one colour.

use embedded_graphics::{geometry::Size, pixelcolor::PixelColor, primitives::Rectangle};

use crate::{
    draw::PrimitiveStyle,
    geometry::{WideRectangle, Window},
    scan::round::{Curve, CurveNumber, SymmetricRows},
    surface::{SymmetricBox, Target},
};

/// The outer area without the inner one is painted in one colour, the inner one in another or not at all.
///
/// So no pixel is painted twice.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct Areas<C> {
    pub outer: WideRectangle,
    pub inner: WideRectangle,
    pub color: C,
    pub inner_color: Option<C>,
}

impl<C: PixelColor> Areas<C> {
    /// `None` where the style paints nothing.
    pub fn new(outline: impl Into<WideRectangle>, style: &PrimitiveStyle<C>) -> Option<Self> {
        let outline = outline.into();
        let (inside, outside) = style.stroke_widths();
        let fill_area = outline.inset(inside);
        match (style.effective_stroke_color(), style.fill_color) {
            (Some(color), inner_color) => Some(Self {
                outer: outline.outset(outside),
                inner: fill_area,
                color,
                inner_color,
            }),
            (None, Some(color)) => Some(Self {
                outer: fill_area,
                inner: WideRectangle {
                    size: Size::zero(),
                    ..fill_area
                },
                color,
                inner_color: None,
            }),
            (None, None) => None,
        }
    }

    /// Paints both areas, each within the curve in its box.
    // Not inlined: its walks would be on the stack of a caller that draws several shapes, each of them.
    #[inline(never)]
    pub fn draw_curve<N, T>(&self, curve: Curve<N>, target: &mut T) -> Result<(), T::Error>
    where
        N: CurveNumber,
        T: Target<Color = C>,
    {
        let Some(mut shape) = SymmetricBox::new(self.outer, &target.window()) else {
            return Ok(());
        };
        let Size { width, height } = self.outer.size;
        // Circles and wide ellipses have pixels in every row.
        if width < height {
            shape.rows.start = shape.rows.start.max((curve.first_row)(self.outer.size));
            if shape.rows.is_empty() {
                return Ok(());
            }
        }
        let mut rows = SymmetricRows::new(self.outer, self.inner, curve, &shape);
        let inner_ink = self.inner_color.map(|color| target.raw(color));
        target.fill_symmetric(&shape, &mut rows, target.raw(self.color), inner_ink)
    }
}

/// Whether the window may show something of a closed shape in a box, with its stroke: the first question, because most shapes
/// are not in a band.
#[inline(always)]
pub(crate) fn may_meet<C: PixelColor>(outline: &Rectangle, style: &PrimitiveStyle<C>, window: &Window) -> bool {
    // A box without rows is stroked as one with a row.
    window.may_meet_rows(outline.top_left.y, outline.size.height.max(1), style.stroke_width)
}

/// The box of a closed shape with its stroke.
pub(crate) fn styled_box<C: PixelColor>(outline: Rectangle, style: &PrimitiveStyle<C>) -> Rectangle {
    WideRectangle::from(outline)
        .outset(style.outside_stroke_width())
        .to_rectangle()
}
