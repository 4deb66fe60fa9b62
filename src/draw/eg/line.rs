//! embedded-graphics' `Line`: Bresenham's line where the stroke is one pixel wide, otherwise a rectangle around the
//! line.

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
            let (start, end) = (self.start.y, self.end.y);
            // From half its width and a quarter of a pixel above the upper end to as far below the lower one, whose row is not among
            // those that are counted.
            let reach = style.stroke_width;
            if !target
                .window()
                .may_meet_rows(start.min(end), start.abs_diff(end), reach)
            {
                return Ok(());
            }
            return draw_wide(self, style, target);
        }
        if bresenham::is_beyond_rows(self.start, self.end, &target.window()) {
            return Ok(());
        }
        draw_thin(self, color, target)
    }
}

/// Draws a line one pixel wide that is not wholly above or below the window.
// Not inlined: its registers are saved only where the line is met, which takes 16 instructions less of what is not (Cortex-M4).
#[inline(never)]
fn draw_thin<T: Target>(line: &Line, color: T::Color, target: &mut T) -> Result<(), T::Error> {
    match bresenham::steps_in_rows(line.start, line.end, &target.window()) {
        Some(steps) => target.draw_steps(&steps, target.raw(color)),
        None => Ok(()),
    }
}

/// Draws a stroke of two pixels or more as a polygon. Not inlined, so that thin lines do not have its stack frame.
#[inline(never)]
fn draw_wide<T: Target>(line: &Line, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
    stroke_path(line, u64::from(style.stroke_width) * 2, |path| {
        stroke::draw_path(target, style, path)
    })
}

/// Calls `call` with the line as the path of a stroke of the given width in half pixels.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::pictures::{drawn, drawn_by_both, stroke};

    #[test]
    fn a_line_from_end_to_end() {
        let line = Line::new(Point::new(0, 1), Point::new(11, 5));
        drawn_by_both(&line, stroke(1)).assert_pattern(&[
            "            ",
            "##          ",
            "  ###       ",
            "     ##     ",
            "       ###  ",
            "          ##",
        ]);
    }

    /// In column 2, the line is halfway between two pixels. embedded-graphics draws a different one of them for each
    /// order of the ends.
    #[test]
    fn a_tie_goes_to_the_larger_coordinate_from_either_end() {
        let pattern = [
            "##       ", //
            "  ###    ",
        ];
        let (left, right) = (Point::new(0, 0), Point::new(4, 1));
        drawn(&Line::new(left, right), stroke(1)).assert_pattern(&pattern);
        drawn(&Line::new(right, left), stroke(1)).assert_pattern(&pattern);
    }

    #[test]
    fn a_steep_line_cut_by_the_left_and_the_upper_edge() {
        let line = Line::new(Point::new(-5, -4), Point::new(4, 9));
        drawn_by_both(&line, stroke(1)).assert_pattern(&[
            "         ",
            "         ",
            "         ",
            "#        ",
            " #       ",
            " #       ",
            "  #      ",
            "   #     ",
            "   #     ",
            "    #    ",
        ]);
    }

    #[test]
    fn a_level_line_5_pixels_wide_ends_with_its_end_pixels() {
        let line = Line::new(Point::new(2, 2), Point::new(10, 2));
        drawn_by_both(&line, stroke(5)).assert_pattern(&[
            "  #########",
            "  #########",
            "  #########",
            "  #########",
            "  #########",
        ]);
    }

    /// A rectangle along the line: its sides are 2 pixels from the line, and its ends half a pixel beyond the end
    /// points.
    #[test]
    fn a_slanted_line_4_pixels_wide() {
        let line = Line::new(Point::new(2, 2), Point::new(11, 8));
        drawn(&line, stroke(4)).assert_pattern(&[
            "             ",
            "   ##        ",
            "  ####       ",
            " #######     ",
            "  #######    ",
            "   ########  ",
            "     ####### ",
            "      #######",
            "        #### ",
            "         ##  ",
        ]);
    }
}
