//! Wraps any embedded-graphics display so that it takes spans, blocks and lines.

use embedded_graphics::{Pixel, draw_target::DrawTarget, geometry::Dimensions, primitives::Rectangle};

use crate::{
    geometry::Window,
    target::{LineSteps, Span, Target},
};

/// A display without pixel memory of ours, as a [`Target`].
///
/// Spans and blocks become `fill_solid`, lines become one `draw_iter`; nothing reaches the display that lies outside
/// its bounding box.
#[derive(Debug)]
pub struct Generic<'a, D: ?Sized>(pub &'a mut D);

impl<D: DrawTarget + ?Sized> Dimensions for Generic<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        self.0.bounding_box()
    }
}

impl<D: DrawTarget> DrawTarget for Generic<'_, D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Pixel<Self::Color>>,
    {
        self.0.draw_iter(pixels)
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Self::Color>,
    {
        self.0.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Self::Color) -> Result<(), Self::Error> {
        self.0.fill_solid(area, color)
    }

    fn clear(&mut self, color: Self::Color) -> Result<(), Self::Error> {
        self.0.clear(color)
    }
}

impl<D: DrawTarget> Target for Generic<'_, D> {
    type Ink = D::Color;

    fn window(&self) -> Window {
        self.0.bounding_box().into()
    }

    fn ink(&self, color: D::Color) -> D::Color {
        color
    }

    fn fill_span(&mut self, span: Span, ink: D::Color) -> Result<(), D::Error> {
        self.fill_window(span.to_window(), ink)
    }

    fn fill_window(&mut self, window: Window, ink: D::Color) -> Result<(), D::Error> {
        if window.is_empty() {
            return Ok(());
        }
        self.0.fill_solid(&window.to_rectangle(), ink)
    }

    fn draw_steps(&mut self, steps: LineSteps, ink: D::Color) -> Result<(), D::Error> {
        self.0.draw_iter(steps.into_iter().map(|point| Pixel(point, ink)))
    }
}

#[cfg(feature = "defmt")]
impl<D: ?Sized> defmt::Format for Generic<'_, D> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Generic");
    }
}
