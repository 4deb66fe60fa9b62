//! embedded-graphics' `Polyline`: the union of Bresenham's lines where the stroke is one pixel wide, otherwise a wide
//! stroke along the vertices.

use embedded_graphics::{
    geometry::Point,
    pixelcolor::PixelColor,
    primitives::{Polyline, Rectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StrokedShape, StyledShape, drawable_through_generic, stroked_through_generic, style::stroke,
    },
    geometry::{Bounds, Window},
    scan::{line::bresenham, stroke::wide_stroke::Path},
    surface::{LineSteps, Target},
};

impl StyledShape for Polyline<'_> {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        if is_missed(self, &target.window(), stroke::reach(style.stroke_width)) {
            return Ok(());
        }
        match style.effective_stroke_color() {
            None => Ok(()),
            Some(_) if style.stroke_width > 1 => draw_wide(self, style, target),
            Some(color) => draw_thin(self, color, target),
        }
    }
}

/// Draws a stroke of two pixels or more as a polygon. Not inlined, so that what is not met does not have its stack frame.
#[inline(never)]
fn draw_wide<T: Target>(
    polyline: &Polyline<'_>,
    style: &PrimitiveStyle<T::Color>,
    target: &mut T,
) -> Result<(), T::Error> {
    stroke_path(polyline, u64::from(style.stroke_width) * 2, |path| {
        stroke::draw_path(target, style, path)
    })
}

/// Draws lines of one pixel's width.
// Always, as is `reach` of a stroke: with `inline` alone a polyline that is not met takes 4.5 % more instructions (Cortex-M4).
#[inline(always)]
fn draw_thin<T: Target>(polyline: &Polyline<'_>, color: T::Color, target: &mut T) -> Result<(), T::Error> {
    let raw = target.raw(color);
    let window = target.window();
    let mut first_visible = true;
    for (&from, &to) in polyline.vertices.iter().zip(polyline.vertices.iter().skip(1)) {
        // The pixel of a vertex belongs to the line that ends there; that of the first vertex to the first line.
        let begins_before = !first_visible;
        first_visible = false;
        if let Some(steps) = segment(from, to, polyline.translate, begins_before, &window) {
            target.draw_steps(&steps, raw)?;
        }
    }
    Ok(())
}

/// Whether all vertices of a polyline are so far above the window, or all below it, that a stroke which extends `reach`
/// rows beyond them is not shown. Cost: up to the first vertex that is not, and a compare for each.
fn is_missed(polyline: &Polyline<'_>, window: &Window, reach: u32) -> bool {
    // Rows of vertices before they are moved. At the ends of the number range no vertex is beyond.
    let row = |row: i32| row.saturating_sub(polyline.translate.y);
    // In two halves, which are signed numbers.
    let half = (reach / 2) as i32;
    let rest = half.saturating_add((reach & 1) as i32);
    let above = row(window.top).saturating_sub(half).saturating_sub(rest);
    let last_row = window.bottom.saturating_sub(1);
    let below = row(last_row).saturating_add(half).saturating_add(rest);
    let vertices = polyline.vertices;
    match vertices.first() {
        Some(first) if first.y < above => vertices.iter().all(|vertex| vertex.y < above),
        _ => vertices.iter().all(|vertex| vertex.y > below),
    }
}

/// Calls `call` with the polyline as the path of a stroke of the given width in half pixels.
fn stroke_path<R>(polyline: &Polyline<'_>, width_in_halves: u64, call: impl FnOnce(&Path<'_>) -> R) -> R {
    let vertex = |number: usize| {
        let pixel = polyline.vertices.get(number).copied().unwrap_or_default();
        stroke::position(pixel, polyline.translate)
    };
    // A polyline with one vertex draws nothing, as in embedded-graphics.
    let count = if polyline.vertices.len() < 2 {
        0
    } else {
        polyline.vertices.len()
    };
    call(&Path::new(&vertex, count, false, width_in_halves))
}

impl StrokedShape for Polyline<'_> {
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>)) {
        stroke_path(self, width_in_halves, call);
    }
}

/// The visible pixels of the line between two vertices moved by `offset`. With `begins_before`, without the pixel of
/// `from`, which the line before has drawn. `None` where no pixel is left.
pub(crate) fn segment(
    from: Point,
    to: Point,
    offset: Point,
    begins_before: bool,
    window: &Window,
) -> Option<LineSteps> {
    if begins_before && from == to {
        return None;
    }
    let mut steps = bresenham::moved_line_steps(from, to, offset, window)?;
    // Where it has no coordinates it wraps, and is not used.
    let first = Point::new(from.x.wrapping_add(offset.x), from.y.wrapping_add(offset.y));
    let first_is_pixel = from.x.checked_add(offset.x).is_some() && from.y.checked_add(offset.y).is_some();
    if begins_before && first_is_pixel && window.contains(first) {
        steps = without(steps, first)?;
    }
    Some(steps)
}

/// Removes the first or the last pixel of a line, whichever `pixel` is; `None` where no other pixel is left.
fn without(mut steps: LineSteps, pixel: Point) -> Option<LineSteps> {
    steps.count = steps.count.checked_sub(1).filter(|&count| count > 0)?;
    if steps.start != pixel {
        return Some(steps);
    }
    let until_minor_step = steps.major_delta - steps.minor_delta;
    let moves_aside = steps.error >= until_minor_step;
    steps.error = if moves_aside {
        steps.error - until_minor_step
    } else {
        steps.error + steps.minor_delta
    };
    // No overflow: the next pixel lies in the window.
    if steps.x_major || moves_aside {
        let sideways = if steps.leftwards { -1 } else { 1 };
        steps.start.x += sideways;
    }
    if !steps.x_major || moves_aside {
        steps.start.y += 1;
    }
    Some(steps)
}

drawable_through_generic!(Polyline<'_>);
stroked_through_generic!(Polyline<'_>);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Polyline<'_> {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        if style.stroke_width > 1 {
            return stroke_path(self, u64::from(style.stroke_width) * 2, |path| {
                stroke::bounds(path).to_rectangle()
            });
        }
        let (dx, dy) = (i64::from(self.translate.x), i64::from(self.translate.y));
        if self.vertices.len() < 2 {
            return Rectangle::zero();
        }
        self.vertices
            .iter()
            .fold(Bounds::EMPTY, |bounds, vertex| {
                bounds.with(i64::from(vertex.x) + dx, i64::from(vertex.y) + dy)
            })
            .to_rectangle()
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::transform::Transform;

    use super::*;
    use crate::draw::pictures::{drawn, drawn_by_both, stroke};

    #[test]
    fn a_zigzag_has_each_vertex_once() {
        let vertices = [Point::new(0, 5), Point::new(4, 0), Point::new(8, 5), Point::new(13, 1)];
        drawn_by_both(&Polyline::new(&vertices), stroke(1)).assert_pattern(&[
            "    #         ",
            "   # #       #",
            "  #   #     # ",
            "  #   #   ##  ",
            " #     # #    ",
            "#       #     ",
        ]);
    }

    #[test]
    fn a_right_angle_3_pixels_wide_has_a_sharp_corner() {
        let vertices = [Point::new(1, 1), Point::new(9, 1), Point::new(9, 8)];
        drawn_by_both(&Polyline::new(&vertices), stroke(3)).assert_pattern(&[
            " ##########",
            " ##########",
            " ##########",
            "        ###",
            "        ###",
            "        ###",
            "        ###",
            "        ###",
            "        ###",
        ]);
    }

    /// The tip of the corner would be further from the vertex than twice the width, so the corner is a bevel.
    #[test]
    fn a_sharp_turn_4_pixels_wide_is_cut_off_straight() {
        let vertices = [Point::new(2, 2), Point::new(12, 4), Point::new(2, 6)];
        drawn(&Polyline::new(&vertices), stroke(4)).assert_pattern(&[
            "  #          ",
            "  ######     ",
            "  ###########",
            "  ###########",
            "  ###########",
            "  ###########",
            "  ###########",
            "  ######     ",
            "  #          ",
        ]);
    }

    #[test]
    fn a_moved_polyline_cut_by_the_upper_edge() {
        let vertices = [Point::new(0, 0), Point::new(4, 6), Point::new(10, 0), Point::new(10, 6)];
        let polyline = Polyline::new(&vertices).translate(Point::new(1, -3));
        drawn_by_both(&polyline, stroke(1)).assert_pattern(&[
            "   #    #  #",
            "    #  #   #",
            "    # #    #",
            "     #     #",
        ]);
    }

    #[test]
    fn one_vertex_draws_nothing() {
        let vertices = [Point::new(1, 1)];
        for width in [1, 5] {
            drawn_by_both(&Polyline::new(&vertices), stroke(width)).assert_pattern(&[]);
        }
    }
}
