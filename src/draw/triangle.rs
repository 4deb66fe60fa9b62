//! embedded-graphics' `Triangle`: three Bresenham lines and all between.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{Rectangle, StyledDimensions, Triangle},
};

use crate::{
    draw::{PrimitiveStyle, StyledShape, drawable_through_generic},
    geometry::Bounds,
    scan::triangle,
    target::{Span, Target},
};

impl StyledShape for Triangle {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let window = target.window();
        let stroke = style.effective_stroke_color().map(|color| target.ink(color));
        let fill = style.fill_color.map(|color| target.ink(color));
        if style.stroke_width == 0 {
            let Some(fill) = fill else { return Ok(()) };
            return triangle::fill(self.vertices, &window, |span| target.fill_span(span, fill));
        }
        triangle::outline(self.vertices, &window, |row| {
            fill_span(target, row.left, stroke)?;
            fill_span(target, row.inside, fill)?;
            fill_span(target, row.right, stroke)
        })
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

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Triangle {
    fn styled_bounding_box(&self, _style: &PrimitiveStyle<C>) -> Rectangle {
        Bounds::of(self.vertices).to_rectangle()
    }
}
