//! embedded-graphics' `Circle`, at any diameter and position.

use embedded_graphics::{
    geometry::{Dimensions, Size},
    pixelcolor::PixelColor,
    primitives::{Circle, Rectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StyledShape, drawable_through_generic,
        eg::areas::{Areas, styled_box},
    },
    scan::round::{Curve, ForwardDifference, circle},
    surface::Target,
};

pub(crate) const CURVE: Curve<u32> = Curve {
    first_row: |_| 0,
    enter,
};

fn enter(size: Size, row: u32) -> ForwardDifference<u32> {
    circle::enter(size.width, row)
}

impl StyledShape for Circle {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        match Areas::new(self.bounding_box(), style) {
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
