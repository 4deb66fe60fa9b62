//! embedded-graphics' `Line`: one pixel wide by Bresenham.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{Line, Rectangle, StyledDimensions},
};

use crate::{
    draw::{PrimitiveStyle, StyledShape, drawable_through_generic},
    geometry::Bounds,
    scan::bresenham,
    target::Target,
};

impl StyledShape for Line {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let Some(color) = style.effective_stroke_color() else {
            return Ok(());
        };
        match bresenham::line(self.start, self.end, &target.window()) {
            Some(steps) => target.draw_steps(steps, target.ink(color)),
            None => Ok(()),
        }
    }
}

drawable_through_generic!(Line);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Line {
    fn styled_bounding_box(&self, _style: &PrimitiveStyle<C>) -> Rectangle {
        Bounds::of([self.start, self.end]).to_rectangle()
    }
}
