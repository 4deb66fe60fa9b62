//! embedded-graphics' `Triangle`: three Bresenham lines and all between, and wide strokes along them.

use embedded_graphics::{
    geometry::Point,
    pixelcolor::PixelColor,
    primitives::{Rectangle, StrokeAlignment, StyledDimensions, Triangle},
};

use crate::{
    draw::{PrimitiveStyle, StrokedShape, StyledShape, drawable_through_generic, stroke, stroked_through_generic},
    geometry::Bounds,
    scan::{
        scanline_polygon::{FillRule, PartRule, StrokePlace},
        triangle::{self, Rows},
        wide_stroke::Path,
    },
    target::{Span, Target},
};

impl StyledShape for Triangle {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let window = target.window();
        let stroke = style.effective_stroke_color().map(|color| target.ink(color));
        let fill = style.fill_color.map(|color| target.ink(color));
        if style.stroke_width == 0 {
            let Some(fill) = fill else { return Ok(()) };
            return triangle::fill(self.vertices, &window, |rows| match rows {
                Rows::One(span) => target.fill_span(span, fill),
                Rows::Many(trapezoids) => target.fill_trapezoids(trapezoids, fill),
            });
        }
        if style.stroke_width > 1 {
            return draw_wide(self, style, target);
        }
        triangle::outline(self.vertices, &window, |row| {
            fill_span(target, row.left, stroke)?;
            fill_span(target, row.inside, fill)?;
            fill_span(target, row.right, stroke)
        })
    }
}

/// Not inlined: what thin outlines do not need is not on the stack of what draws them.
#[inline(never)]
fn draw_wide<T: Target>(triangle: &Triangle, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
    let rule = PartRule {
        fill_rule: FillRule::NonZero,
        stroke_place: match style.stroke_alignment {
            StrokeAlignment::Center => StrokePlace::Everywhere,
            StrokeAlignment::Inside => StrokePlace::Inside,
            StrokeAlignment::Outside => StrokePlace::Outside,
        },
    };
    stroke_path(triangle, style, |path| {
        stroke::draw(target, style, rule, &|window, sink| {
            if stroke::needs_inside(style) {
                triangle::edges(triangle.vertices, window, sink);
            }
            path.edges(window, sink);
        })
    })
}

/// Calls with the outline as a closed path.
///
/// The triangle is half a pixel larger than the lines between its vertices: its outermost pixels have their centres there.
/// What is stroked inside it so reaches a width inwards from half a pixel outside the lines, and what is stroked outside
/// begins there. The path's width is what both sides of the lines together take.
fn stroke_path<C: PixelColor, R>(
    triangle: &Triangle,
    style: &PrimitiveStyle<C>,
    call: impl FnOnce(&Path<'_>) -> R,
) -> R {
    let width = u64::from(style.stroke_width);
    let width_in_halves = match style.stroke_alignment {
        StrokeAlignment::Center => width * 2,
        StrokeAlignment::Inside => (width * 4).saturating_sub(2),
        StrokeAlignment::Outside => width * 4 + 2,
    };
    outline(triangle, width_in_halves, call)
}

/// Calls with the lines between the vertices as a closed path of that width.
fn outline<R>(triangle: &Triangle, width_in_halves: u64, call: impl FnOnce(&Path<'_>) -> R) -> R {
    let vertex = |number: usize| {
        let pixel = triangle.vertices.get(number).copied().unwrap_or_default();
        stroke::position(pixel, Point::zero())
    };
    call(&Path::new(&vertex, triangle.vertices.len(), true, width_in_halves))
}

impl StrokedShape for Triangle {
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>)) {
        outline(self, width_in_halves, call);
    }
}

/// Fills the span where there is a colour and a pixel.
fn fill_span<T: Target>(target: &mut T, span: Span, ink: Option<T::Ink>) -> Result<(), T::Error> {
    match ink {
        Some(ink) if !span.is_empty() => target.fill_span(span, ink),
        _ => Ok(()),
    }
}

drawable_through_generic!(Triangle);
stroked_through_generic!(Triangle);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Triangle {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        let bounds = Bounds::of(self.vertices);
        if style.stroke_width < 2 || style.stroke_alignment == StrokeAlignment::Inside {
            return bounds.to_rectangle();
        }
        stroke_path(self, style, |path| bounds.around(&stroke::bounds(path)).to_rectangle())
    }
}
