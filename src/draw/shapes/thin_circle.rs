//! Bresenham's circle: a thin closed line of pixels around the centre of a pixel.
//!
//! Rows are walked with an integer error term from the outside to the middle, each together with its mirrored row. The
//! walk begins at the first visible row, which is entered by an integer square root.

use embedded_graphics::{
    geometry::{Dimensions, Point, Size},
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, StyledDimensions},
    transform::Transform,
};

use crate::{
    draw::{PrimitiveStyle, StyledShape, drawable_through_generic},
    geometry::WideRectangle,
    scan::round::bresenham_circle::{BresenhamCircle, MAX_RADIUS},
    surface::{SymmetricBox, Target},
};

/// A thin circle: in each octant one pixel for each step, the one nearest to the exact circle (Bresenham 1977).
///
/// The circle is 8-connected, and has the eightfold symmetry of a square about the centre of a pixel. A `Circle` with a
/// stroke of one pixel is a different set of pixels: those of its disc that are not in the next smaller disc.
///
/// The line is drawn in the stroke colour; the width and alignment of the stroke are ignored. A fill colour fills the
/// pixels inside the line, and the line too where the style has no stroke.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use zrow::draw::{PrimitiveStyle, ThinCircle};
///
/// let mut display = MockDisplay::new();
/// ThinCircle::new(Point::new(3, 3), 3)
///     .into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1))
///     .draw(&mut display)?;
/// display.assert_pattern(&[
///     "  ###  ",
///     " #   # ",
///     "#     #",
///     "#     #",
///     "#     #",
///     " #   # ",
///     "  ###  ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ThinCircle {
    /// The pixel at the centre.
    pub center: Point,
    /// Distance of the line from the centre in pixels; 0 is a single pixel.
    ///
    /// A radius above 2,147,483,647 counts as 2,147,483,647, the largest one whose box a `Size` can measure.
    pub radius: u32,
}

impl ThinCircle {
    /// A circle around a pixel, with a radius in pixels.
    pub const fn new(center: Point, radius: u32) -> Self {
        Self { center, radius }
    }

    /// The box around the pixels of the circle.
    fn wide_box(&self) -> WideRectangle {
        let radius = self.radius.min(MAX_RADIUS);
        WideRectangle {
            left: i64::from(self.center.x) - i64::from(radius),
            top: i64::from(self.center.y) - i64::from(radius),
            size: Size::new_equal(2 * radius + 1),
        }
    }
}

impl Primitive for ThinCircle {}

impl Dimensions for ThinCircle {
    fn bounding_box(&self) -> Rectangle {
        self.wide_box().to_rectangle()
    }
}

impl Transform for ThinCircle {
    /// Moves the circle. The coordinates of its centre saturate at the ends of the number range.
    fn translate(&self, by: Point) -> Self {
        let center = Point::new(self.center.x.saturating_add(by.x), self.center.y.saturating_add(by.y));
        Self { center, ..*self }
    }

    fn translate_mut(&mut self, by: Point) -> &mut Self {
        *self = self.translate(by);
        self
    }
}

impl StyledShape for ThinCircle {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let Some(shape) = SymmetricBox::new(self.wide_box(), &target.window()) else {
            return Ok(());
        };
        let Some(color) = style.effective_stroke_color().or(style.fill_color) else {
            return Ok(());
        };
        let fill_raw = style.fill_color.map(|color| target.raw(color));
        let mut rows = BresenhamCircle::new(&shape);
        target.fill_symmetric(&shape, &mut rows, target.raw(color), fill_raw)
    }
}

drawable_through_generic!(ThinCircle);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for ThinCircle {
    fn styled_bounding_box(&self, _style: &PrimitiveStyle<C>) -> Rectangle {
        self.bounding_box()
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{Drawable, mock_display::MockDisplay, primitives::StrokeAlignment};

    use super::*;
    use crate::draw::pictures::{drawn, green_in_red, stroke};

    #[test]
    fn radii_of_0_to_3_pixels() {
        let mut display = MockDisplay::new();
        for (center, radius) in [(0, 0), (3, 1), (8, 2), (15, 3)] {
            let circle = ThinCircle::new(Point::new(center, 3), radius);
            let Ok(()) = circle.into_styled(stroke(1)).draw(&mut display);
        }
        display.assert_pattern(&[
            "              ###  ",
            "       ###   #   # ",
            "   #  #   # #     #",
            "# # # #   # #     #",
            "   #  #   # #     #",
            "       ###   #   # ",
            "              ###  ",
        ]);
    }

    /// The line is one pixel wide, although the style's stroke is 3 pixels wide.
    #[test]
    fn a_green_disc_in_a_red_line() {
        let circle = ThinCircle::new(Point::new(6, 6), 6);
        let display = drawn(&circle, green_in_red(3, StrokeAlignment::Outside));
        display.assert_pattern(&[
            "    RRRRR    ",
            "   RGGGGGR   ",
            "  RGGGGGGGR  ",
            " RGGGGGGGGGR ",
            "RGGGGGGGGGGGR",
            "RGGGGGGGGGGGR",
            "RGGGGGGGGGGGR",
            "RGGGGGGGGGGGR",
            "RGGGGGGGGGGGR",
            " RGGGGGGGGGR ",
            "  RGGGGGGGR  ",
            "   RGGGGGR   ",
            "    RRRRR    ",
        ]);
    }

    #[test]
    fn a_circle_cut_by_the_upper_left_corner() {
        let circle = ThinCircle::new(Point::new(2, 1), 7);
        drawn(&circle, stroke(1)).assert_pattern(&[
            "         #",
            "         #",
            "         #",
            "         #",
            "        # ",
            "        # ",
            "       #  ",
            "     ##   ",
            "#####     ",
        ]);
    }
}
