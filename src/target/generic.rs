//! Wraps any embedded-graphics display so that it takes spans, blocks and lines.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    primitives::Rectangle,
};

use crate::{
    geometry::Window,
    target::{LineSteps, Span, Target},
};

/// A display without pixel memory of ours, as a [`Target`].
///
/// Spans and blocks become `fill_solid`, lines become one `draw_iter`. Nothing reaches the display that lies outside its
/// bounding box, whoever draws: drivers that send what is beyond their right and lower edge are protected, from
/// embedded-graphics' own shapes and texts too.
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
        let window = self.window();
        self.0
            .draw_iter(pixels.into_iter().filter(|pixel| window.contains(pixel.0)))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Self::Color>,
    {
        let whole = Window::from(*area);
        let visible = whole.intersection(&self.window());
        if visible.is_empty() {
            return Ok(());
        }
        if visible.to_rectangle() == *area {
            return self.0.fill_contiguous(area, colors);
        }
        let cropped = Cropped::new(colors.into_iter(), area.size.width as usize, &whole, &visible);
        self.0.fill_contiguous(&visible.to_rectangle(), cropped)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Self::Color) -> Result<(), Self::Error> {
        self.fill_window(Window::from(*area).intersection(&self.window()), color)
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
        if span.is_empty() {
            return Ok(());
        }
        let size = Size::new(span.end.abs_diff(span.start), 1);
        self.0
            .fill_solid(&Rectangle::new(Point::new(span.start, span.y), size), ink)
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

/// The colours of the visible part of an area, row by row.
struct Cropped<I> {
    colors: I,
    /// Colours to leave out before the next one.
    skip: usize,
    /// Colours to leave out between two rows.
    gap: usize,
    width: u32,
    left_in_row: u32,
    rows_left: u32,
}

impl<I: Iterator> Cropped<I> {
    fn new(colors: I, stride: usize, whole: &Window, visible: &Window) -> Self {
        let rows_above = visible.top.abs_diff(whole.top) as usize;
        let columns_before = visible.left.abs_diff(whole.left) as usize;
        Self {
            colors,
            skip: rows_above.saturating_mul(stride).saturating_add(columns_before),
            gap: stride.saturating_sub(visible.width() as usize),
            width: visible.width(),
            left_in_row: visible.width(),
            rows_left: visible.height().saturating_sub(1),
        }
    }
}

impl<I: Iterator> Iterator for Cropped<I> {
    type Item = I::Item;

    fn next(&mut self) -> Option<I::Item> {
        if self.left_in_row == 0 {
            self.rows_left = self.rows_left.checked_sub(1)?;
            self.left_in_row = self.width;
            self.skip = self.gap;
        }
        self.left_in_row = self.left_in_row.checked_sub(1)?;
        self.colors.nth(core::mem::take(&mut self.skip))
    }
}

#[cfg(feature = "defmt")]
impl<D: ?Sized> defmt::Format for Generic<'_, D> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Generic");
    }
}
