//! embedded-graphics' `Ellipse`, at any size and position.

use embedded_graphics::{
    geometry::Dimensions,
    pixelcolor::PixelColor,
    primitives::{Ellipse, Rectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StyledShape,
        areas::{Areas, styled_box},
        drawable_through_generic,
    },
    scan::{Curve, ellipse},
    target::Target,
};

const NARROW: Curve<u32> = Curve {
    first_row: ellipse::first_row,
    enter: ellipse::enter_narrow,
};

const WIDE: Curve<u128> = Curve {
    first_row: ellipse::first_row,
    enter: ellipse::enter_wide,
};

impl StyledShape for Ellipse {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        match Areas::new(self.bounding_box(), style) {
            Some(areas) if ellipse::is_narrow(areas.outer.size) && ellipse::is_narrow(areas.inner.size) => {
                areas.draw_curve(NARROW, target)
            }
            Some(areas) => areas.draw_curve(WIDE, target),
            None => Ok(()),
        }
    }
}

drawable_through_generic!(Ellipse);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Ellipse {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        styled_box(self.bounding_box(), style)
    }
}
