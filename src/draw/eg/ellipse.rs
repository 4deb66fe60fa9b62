//! embedded-graphics' `Ellipse`, at any size and position.
//!
//! The rows of the outer and the inner ellipse are walked by forward differences, from the outside to the middle; each
//! row is drawn together with its mirrored row. The walk is in `u32` where both sizes allow it
//! ([`ellipse::is_narrow`]), otherwise in `u128`.

use embedded_graphics::{
    geometry::{Dimensions, Size},
    pixelcolor::PixelColor,
    primitives::{Ellipse, Rectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StyledShape, drawable_through_generic,
        eg::areas::{Areas, may_meet},
    },
    geometry::WideRectangle,
    scan::round::{Curve, ellipse},
    surface::Target,
};

/// Ellipses whose rows can be walked in `u32`.
const NARROW: Curve<u32> = Curve {
    first_row: ellipse::first_row,
    enter: ellipse::enter_narrow,
};

/// Ellipses of every size.
const WIDE: Curve<u128> = Curve {
    first_row: ellipse::first_row,
    enter: ellipse::enter_wide,
};

impl StyledShape for Ellipse {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let bounding_box = self.bounding_box();
        if !may_meet(&bounding_box, style, &target.window()) {
            return Ok(());
        }
        match Areas::new(bounding_box, style) {
            Some(areas) if ellipse::is_narrow(areas.outer.size) && ellipse::is_narrow(areas.inner.size) => {
                areas.draw_curve(NARROW, target)
            }
            Some(areas) => areas.draw_curve(WIDE, target),
            None => Ok(()),
        }
    }
}

drawable_through_generic!(Ellipse);

/// The smallest box around the pixels of the ellipse in a box. A narrow and high ellipse has no pixel in the first and
/// the last row, a wide and low one none in the first and the last column.
fn smallest_box(rectangle: WideRectangle) -> WideRectangle {
    if rectangle.is_empty() {
        return rectangle;
    }
    let Size { width, height } = rectangle.size;
    let rows = ellipse::first_row(rectangle.size);
    let columns = ellipse::first_row(Size::new(height, width));
    WideRectangle {
        left: rectangle.left + i64::from(columns),
        top: rectangle.top + i64::from(rows),
        size: Size::new(width - 2 * columns, height - 2 * rows),
    }
}

/// The smallest box around the pixels of fill and stroke, whichever of them have a colour.
impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Ellipse {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        let grown = WideRectangle::from(self.bounding_box()).outset(style.outside_stroke_width());
        smallest_box(grown).to_rectangle()
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{geometry::Point, primitives::StrokeAlignment};

    use super::*;
    use crate::draw::pictures::{FILL, drawn, drawn_by_both, green_in_red, stroke};

    #[test]
    fn an_ellipse_of_13_by_7_pixels() {
        let ellipse = Ellipse::new(Point::zero(), Size::new(13, 7));
        drawn_by_both(&ellipse, FILL).assert_pattern(&[
            "   #######   ",
            " ########### ",
            "#############",
            "#############",
            "#############",
            " ########### ",
            "   #######   ",
        ]);
    }

    #[test]
    fn a_green_ellipse_in_a_red_stroke_around_it() {
        let ellipse = Ellipse::new(Point::new(2, 2), Size::new(10, 6));
        let display = drawn_by_both(&ellipse, green_in_red(2, StrokeAlignment::Outside));
        display.assert_pattern(&[
            "    RRRRRR    ",
            "  RRRRRRRRRR  ",
            " RRRGGGGGGRRR ",
            "RRRGGGGGGGGRRR",
            "RRGGGGGGGGGGRR",
            "RRGGGGGGGGGGRR",
            "RRRGGGGGGGGRRR",
            " RRRGGGGGGRRR ",
            "  RRRRRRRRRR  ",
            "    RRRRRR    ",
        ]);
    }

    #[test]
    fn a_high_ellipse_cut_by_the_left_edge() {
        let ellipse = Ellipse::new(Point::new(-3, 0), Size::new(8, 12));
        drawn_by_both(&ellipse, stroke(1)).assert_pattern(&[
            "###      ",
            "  ##     ",
            "   #     ",
            "    #    ",
            "    #    ",
            "    #    ",
            "    #    ",
            "    #    ",
            "    #    ",
            "   #     ",
            "  ##     ",
            "###      ",
        ]);
    }

    /// In a box of 2 x 8 pixels, the ellipse is so narrow in the first and the last row that no pixel centre is inside.
    #[test]
    fn a_narrow_ellipse_has_no_pixel_in_its_first_and_last_row() {
        let ellipse = Ellipse::new(Point::zero(), Size::new(2, 8));
        drawn(&ellipse, FILL).assert_pattern(&[
            "         ",
            "##       ",
            "##       ",
            "##       ",
            "##       ",
            "##       ",
            "##       ",
        ]);
    }
}
