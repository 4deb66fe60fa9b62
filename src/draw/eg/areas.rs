//! The two areas that a style gives a closed shape: an outer area with a hole, and the inner area that is the hole.
//!
//! ```text
//!  +---------------+   outer: the bounding box moved outwards by the stroke's outside part
//!  |sssssssssssssss|
//!  |ss+---------+ss|   inner: the bounding box moved inwards by the stroke's inside part
//!  |ss|fffffffff|ss|   s  stroke colour
//!  |ss+---------+ss|   f  fill colour, or nothing
//!  |sssssssssssssss|
//!  +---------------+
//! ```
//!
//! Without a stroke colour, the outer area is that of the fill and the inner area is empty.

use embedded_graphics::{geometry::Size, pixelcolor::PixelColor, primitives::Rectangle};

use crate::{
    draw::PrimitiveStyle,
    geometry::{WideRectangle, Window},
    scan::round::{Curve, CurveNumber, SymmetricRows},
    surface::{SymmetricBox, Target},
};

/// Outer and inner area of a closed shape, as boxes. `color` is for the pixels of the outer area that are not in the
/// inner one; `inner_color` for those of the inner area, which stay unchanged where it is `None`. Each pixel is painted
/// at most once.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct Areas<C> {
    pub outer: WideRectangle,
    pub inner: WideRectangle,
    pub color: C,
    pub inner_color: Option<C>,
}

impl<C: PixelColor> Areas<C> {
    /// The areas of a shape with a given box, in a style; `None` where the style paints nothing.
    pub fn new(bounding_box: impl Into<WideRectangle>, style: &PrimitiveStyle<C>) -> Option<Self> {
        let bounding_box = bounding_box.into();
        let (inside, outside) = style.stroke_widths();
        let fill_area = bounding_box.inset(inside);
        match (style.effective_stroke_color(), style.fill_color) {
            (Some(color), inner_color) => Some(Self {
                outer: bounding_box.outset(outside),
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

    /// Paints both areas, each of them being the inside of the curve in its box.
    // Not inlined, so that the curve's walks are not on the stack of a caller that draws several shapes.
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
        // A curve whose box is as wide as high, or wider, has pixels in every row.
        if width < height {
            shape.rows.start = shape.rows.start.max((curve.first_row)(self.outer.size));
            if shape.rows.is_empty() {
                return Ok(());
            }
        }
        let mut rows = SymmetricRows::new(self.outer, self.inner, curve, &shape);
        let inner_raw = self.inner_color.map(|color| target.raw(color));
        target.fill_symmetric(&shape, &mut rows, target.raw(self.color), inner_raw)
    }
}

/// Whether the window may show a pixel of a closed shape in a box, with its stroke. A quick test of rows only, made
/// first because most shapes are not in the current band.
#[inline]
pub(crate) fn may_meet<C: PixelColor>(bounding_box: &Rectangle, style: &PrimitiveStyle<C>, window: &Window) -> bool {
    // A box without rows still has a stroke, like one with a single row.
    window.may_meet_rows(
        bounding_box.top_left.y,
        bounding_box.size.height.max(1),
        style.stroke_width,
    )
}

/// The box of a closed shape together with its stroke.
pub(crate) fn styled_box<C: PixelColor>(bounding_box: Rectangle, style: &PrimitiveStyle<C>) -> Rectangle {
    WideRectangle::from(bounding_box)
        .outset(style.outside_stroke_width())
        .to_rectangle()
}
