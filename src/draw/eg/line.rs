//! embedded-graphics' `Line`: one pixel wide by Bresenham, wider as a rectangle around the line.

use embedded_graphics::{
    geometry::Point,
    pixelcolor::PixelColor,
    primitives::{Line, Rectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StrokedShape, StyledShape, drawable_through_generic, stroked_through_generic, style::stroke,
    },
    geometry::Bounds,
    scan::{line::bresenham, stroke::wide_stroke::Path},
    surface::Target,
};

impl StyledShape for Line {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let Some(color) = style.effective_stroke_color() else {
            return Ok(());
        };
        if style.stroke_width > 1 {
            return draw_wide(self, style, target);
        }
        match bresenham::line_steps(self.start, self.end, &target.window()) {
            Some(steps) => target.draw_steps(&steps, target.raw(color)),
            None => Ok(()),
        }
    }
}

/// Draws a stroke of two pixels and more as a polygon. Not inlined: thin lines, which need none of it, have no stack for it.
#[inline(never)]
fn draw_wide<T: Target>(line: &Line, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
    stroke_path(line, u64::from(style.stroke_width) * 2, |path| {
        stroke::draw_path(target, style, path)
    })
}

/// Calls with the line as a path of that width.
fn stroke_path<R>(line: &Line, width_in_halves: u64, call: impl FnOnce(&Path<'_>) -> R) -> R {
    let vertex = |number: usize| {
        let pixel = if number == 0 { line.start } else { line.end };
        stroke::position(pixel, Point::zero())
    };
    call(&Path::new(&vertex, 2, false, width_in_halves))
}

impl StrokedShape for Line {
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>)) {
        stroke_path(self, width_in_halves, call);
    }

    fn is_one_path(&self) -> bool {
        true
    }
}

drawable_through_generic!(Line);
stroked_through_generic!(Line);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Line {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        if style.stroke_width > 1 {
            return stroke_path(self, u64::from(style.stroke_width) * 2, |path| {
                stroke::bounds(path).to_rectangle()
            });
        }
        Bounds::of([self.start, self.end]).to_rectangle()
    }
}
