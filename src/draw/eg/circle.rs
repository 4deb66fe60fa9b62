//! embedded-graphics' `Circle`, at any diameter and position.
//!
//! The rows of the circle in the outer box, and of the circle in the inner box that is its hole, are walked by forward
//! differences, from the outside to the middle; each row is drawn together with its mirrored row.

use embedded_graphics::{
    geometry::{Dimensions, Size},
    pixelcolor::PixelColor,
    primitives::{Circle, Rectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StyledShape, drawable_through_generic,
        eg::areas::{Areas, may_meet, styled_box},
    },
    scan::round::{Curve, ForwardDifference, circle},
    surface::Target,
};

/// The circle of a box with equal sides. Every row of the box has a pixel.
pub(crate) const CURVE: Curve<u32> = Curve {
    first_row: |_| 0,
    enter,
};

/// Enters the circle in a row of a box, to be walked down to the middle row.
fn enter(size: Size, row: u32) -> ForwardDifference<u32> {
    circle::enter(size.width, row)
}

impl StyledShape for Circle {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let outline = self.bounding_box();
        if !may_meet(&outline, style, &target.window()) {
            return Ok(());
        }
        match Areas::new(outline, style) {
            Some(areas) => areas.draw_curve(CURVE, target),
            None => Ok(()),
        }
    }
}

drawable_through_generic!(Circle);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Circle {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        styled_box(self.bounding_box(), style)
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        Drawable,
        geometry::Point,
        mock_display::MockDisplay,
        primitives::{Primitive, StrokeAlignment},
    };

    use super::*;
    use crate::draw::pictures::{FILL, drawn_by_both, green_in_red, stroke};

    #[test]
    fn a_disc_of_7_pixels() {
        let disc = Circle::new(Point::zero(), 7);
        drawn_by_both(&disc, FILL).assert_pattern(&[
            "  ###    ",
            " #####   ",
            "#######  ",
            "#######  ",
            "#######  ",
            " #####   ",
            "  ###    ",
        ]);
    }

    #[test]
    fn a_green_disc_in_a_red_stroke_2_pixels_wide() {
        let circle = Circle::new(Point::zero(), 11);
        let display = drawn_by_both(&circle, green_in_red(2, StrokeAlignment::Inside));
        display.assert_pattern(&[
            "   RRRRR   ",
            "  RRRRRRR  ",
            " RRRGGGRRR ",
            "RRRGGGGGRRR",
            "RRGGGGGGGRR",
            "RRGGGGGGGRR",
            "RRGGGGGGGRR",
            "RRRGGGGGRRR",
            " RRRGGGRRR ",
            "  RRRRRRR  ",
            "   RRRRR   ",
        ]);
    }

    #[test]
    fn a_thin_circle_cut_by_the_upper_left_corner() {
        let circle = Circle::new(Point::new(-4, -3), 11);
        drawn_by_both(&circle, stroke(1)).assert_pattern(&[
            "      #  ",
            "      #  ",
            "      #  ",
            "      #  ",
            "      #  ",
            "     #   ",
            "    #    ",
            "####     ",
        ]);
    }

    /// embedded-graphics makes circles of up to 4 pixels a little smaller. Otherwise the disc of 3 pixels would be a
    /// square.
    #[test]
    fn the_disc_of_3_pixels_is_a_cross() {
        let discs = [(0, 1), (2, 2), (5, 3), (9, 4), (14, 5)];
        let mut display = MockDisplay::new();
        for (left, diameter) in discs {
            let disc = Circle::new(Point::new(left, 0), diameter).into_styled(FILL);
            let Ok(()) = disc.draw(&mut display);
        }
        display.assert_pattern(&[
            "# ##  #   ##   ### ",
            "  ## ### #### #####",
            "      #  #### #####",
            "          ##  #####",
            "               ### ",
        ]);
    }
}
