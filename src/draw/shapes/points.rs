//! Points as markers of charts and maps: squares or discs of one radius around pixels.
//!
//! Each point is drawn as a `Rectangle` or a `Circle` around its pixel, where its box meets the window.

use embedded_graphics::{
    geometry::{Dimensions, Point, Size},
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StyledShape, drawable_through_generic,
        eg::{areas::Areas, circle, rectangle},
    },
    geometry::{Bounds, WideRectangle},
    surface::Target,
};

/// The largest radius: the columns of a larger square exceed a `u32`.
const MAX_RADIUS: u32 = i32::MAX as u32;

/// Many points of one shape and radius, each in the middle of a pixel.
///
/// A square has the pixels that are at most `radius` columns and rows away from its centre. A disc has the pixels of
/// embedded-graphics' `Circle` with the diameter `2 * radius + 1`: those with `dx^2 + dy^2 <= radius^2 + radius`, which
/// are closer than `radius + 1/2`; except for radius 1, where it is a cross of 5 pixels and not the whole square.
/// Radius 0 is the pixel itself. Styles have the same effect as on a `Rectangle` or a `Circle`. Points are drawn in
/// order: where they overlap, the later one is on top.
///
/// Cost: that of the shape for each visible point, and that of a comparison with its box for any other. Any position
/// and radius can be drawn; a radius above 2,147,483,647 counts as 2,147,483,647.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use zrow::draw::{Points, PrimitiveStyle};
///
/// let mut display = MockDisplay::new();
/// let style = PrimitiveStyle::with_fill(BinaryColor::On);
/// Points::discs(&[Point::new(2, 2)], 2).into_styled(style).draw(&mut display)?;
/// Points::squares(&[Point::new(7, 1), Point::new(10, 3)], 1).into_styled(style).draw(&mut display)?;
/// display.assert_pattern(&[
///     " ###  ###   ",
///     "##### ###   ",
///     "##### ######",
///     "#####    ###",
///     " ###     ###",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Points<'a> {
    centers: &'a [Point],
    radius: u32,
    shape: Shape,
}

#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Shape {
    Square,
    Disc,
}

impl<'a> Points<'a> {
    /// Squares with sides of `2 * radius + 1` pixels around these pixels.
    pub const fn squares(centers: &'a [Point], radius: u32) -> Self {
        Self {
            centers,
            radius,
            shape: Shape::Square,
        }
    }

    /// Discs with a diameter of `2 * radius + 1` pixels around these pixels.
    pub const fn discs(centers: &'a [Point], radius: u32) -> Self {
        Self {
            centers,
            radius,
            shape: Shape::Disc,
        }
    }

    /// The box of one point, without its stroke.
    fn wide_box(&self, center: Point) -> WideRectangle {
        let radius = self.radius.min(MAX_RADIUS);
        WideRectangle {
            left: i64::from(center.x) - i64::from(radius),
            top: i64::from(center.y) - i64::from(radius),
            size: Size::new_equal(2 * radius + 1),
        }
    }

    /// The smallest box around all points, each enlarged by `outset` pixels on every side.
    fn bounds(&self, outset: u32) -> Rectangle {
        let around = |bounds: Bounds, rectangle: WideRectangle| {
            let (left, top) = (rectangle.left, rectangle.top);
            let right = left + i64::from(rectangle.size.width) - 1;
            let bottom = top + i64::from(rectangle.size.height) - 1;
            bounds.with(left, top).with(right, bottom)
        };
        let boxes = self.centers.iter().map(|&center| self.wide_box(center).outset(outset));
        boxes.fold(Bounds::EMPTY, around).to_rectangle()
    }
}

impl Primitive for Points<'_> {}

impl Dimensions for Points<'_> {
    fn bounding_box(&self) -> Rectangle {
        self.bounds(0)
    }
}

impl StyledShape for Points<'_> {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let window = target.window();
        for &center in self.centers {
            match Areas::new(self.wide_box(center), style) {
                // Tested first, because most points of a picture are not in the current band.
                Some(areas) if areas.outer.to_window().meets(&window) => match self.shape {
                    Shape::Square => rectangle::draw(&areas, target)?,
                    Shape::Disc => areas.draw_curve(circle::CURVE, target)?,
                },
                _ => {}
            }
        }
        Ok(())
    }
}

drawable_through_generic!(Points<'_>);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Points<'_> {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        self.bounds(style.outside_stroke_width())
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{Drawable, mock_display::MockDisplay, pixelcolor::Rgb565, primitives::StrokeAlignment};

    use super::*;
    use crate::draw::pictures::{FILL, drawn, green_in_red, stroke};

    #[test]
    fn discs_of_radii_0_to_3() {
        let mut display = MockDisplay::new();
        for (center, radius) in [(0, 0), (3, 1), (8, 2), (15, 3)] {
            let disc = [Point::new(center, 3)];
            let Ok(()) = Points::discs(&disc, radius).into_styled(FILL).draw(&mut display);
        }
        display.assert_pattern(&[
            "              ###  ",
            "       ###   ##### ",
            "   #  ##### #######",
            "# ### ##### #######",
            "   #  ##### #######",
            "       ###   ##### ",
            "              ###  ",
        ]);
    }

    #[test]
    fn squares_with_a_stroke_around_them() {
        let centers = [Point::new(2, 2), Point::new(9, 4)];
        let display = drawn(&Points::squares(&centers, 1), green_in_red(1, StrokeAlignment::Outside));
        display.assert_pattern(&[
            "RRRRR       ",
            "RGGGR       ",
            "RGGGR  RRRRR",
            "RGGGR  RGGGR",
            "RRRRR  RGGGR",
            "       RGGGR",
            "       RRRRR",
        ]);
    }

    #[test]
    fn rings_cut_by_the_upper_left_corner() {
        let centers = [Point::new(-1, 4), Point::new(6, 0)];
        drawn(&Points::discs(&centers, 3), stroke(1)).assert_pattern(&[
            "   #     #",
            "#  #     #",
            " #  #   # ",
            "  #  ###  ",
            "  #       ",
            "  #       ",
            " #        ",
            "#         ",
        ]);
    }

    #[test]
    fn the_later_of_two_points_is_on_top() {
        let centers = [Point::new(3, 3), Point::new(7, 4)];
        let mut display = MockDisplay::<Rgb565>::new();
        display.set_allow_overdraw(true);
        let squares = Points::squares(&centers, 3).into_styled(green_in_red(1, StrokeAlignment::Inside));
        let Ok(()) = squares.draw(&mut display);
        display.assert_pattern(&[
            "RRRRRRR    ",
            "RGGGRRRRRRR",
            "RGGGRGGGGGR",
            "RGGGRGGGGGR",
            "RGGGRGGGGGR",
            "RGGGRGGGGGR",
            "RRRRRGGGGGR",
            "    RRRRRRR",
        ]);
    }
}
