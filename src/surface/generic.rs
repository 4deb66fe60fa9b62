//! Wraps any embedded-graphics display so that it takes spans, blocks and lines.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    image::GetPixel,
    primitives::Rectangle,
};

use crate::{
    geometry::Window,
    surface::{BatchTarget, LineSteps, Span, Target, contiguous::ContiguousRows},
};

/// Any embedded-graphics display, as a [`Target`].
///
/// Spans and blocks become `fill_solid`, lines become one `draw_iter`. Nothing reaches the display that lies outside its
/// bounding box, whoever draws: drivers that send what is beyond their right and lower edge are protected, from
/// embedded-graphics' own shapes and texts too.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*, primitives::Circle};
/// use zrow::{band::Generic, draw::{DrawOn, PrimitiveStyle}};
///
/// // This display panics where a pixel is drawn outside of it.
/// let mut display = MockDisplay::new();
/// let circle = Circle::new(Point::new(-3, -3), 8).into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1));
/// circle.draw_on(&mut Generic(&mut display))?;
/// display.assert_pattern(&[
///     "    #", //
///     "    #",
///     "    #",
///     "   # ",
///     "###  ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
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
        let visible = Window::from(*area).intersection(&self.window());
        if visible.is_empty() {
            return Ok(());
        }
        if visible.to_rectangle() == *area {
            return self.0.fill_contiguous(area, colors);
        }
        let cropped = Cropped {
            rows: ContiguousRows::new(area, visible, colors.into_iter()),
            width: visible.width(),
            left_in_row: 0,
        };
        self.0.fill_contiguous(&visible.to_rectangle(), cropped)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Self::Color) -> Result<(), Self::Error> {
        self.fill_window(Window::from(*area), color)
    }

    fn clear(&mut self, color: Self::Color) -> Result<(), Self::Error> {
        self.0.clear(color)
    }
}

/// Reads a pixel back from a display that can, such as a frame buffer.
impl<D: GetPixel + ?Sized> GetPixel for Generic<'_, D> {
    type Color = D::Color;

    fn pixel(&self, point: Point) -> Option<D::Color> {
        self.0.pixel(point)
    }
}

impl<D: DrawTarget> Target for Generic<'_, D> {
    fn window(&self) -> Window {
        self.0.bounding_box().into()
    }

    fn raw(&self, color: D::Color) -> D::Color {
        color
    }
}

impl<D: DrawTarget> BatchTarget for Generic<'_, D> {
    type Raw = D::Color;

    fn fill_clipped_span(&mut self, span: Span, raw: D::Color) -> Result<(), D::Error> {
        if span.is_empty() {
            return Ok(());
        }
        let size = Size::new(span.end.abs_diff(span.start), 1);
        self.0
            .fill_solid(&Rectangle::new(Point::new(span.start, span.y), size), raw)
    }

    fn fill_clipped_window(&mut self, window: Window, raw: D::Color) -> Result<(), D::Error> {
        if window.is_empty() {
            return Ok(());
        }
        self.0.fill_solid(&window.to_rectangle(), raw)
    }

    fn draw_steps(&mut self, steps: &LineSteps, raw: D::Color) -> Result<(), D::Error> {
        self.0.draw_iter(steps.into_iter().map(|point| Pixel(point, raw)))
    }
}

/// The colours of the visible part of an area in one list.
struct Cropped<I> {
    rows: ContiguousRows<I>,
    /// Columns of the visible part.
    width: u32,
    left_in_row: u32,
}

impl<I: Iterator> Iterator for Cropped<I> {
    type Item = I::Item;

    fn next(&mut self) -> Option<I::Item> {
        if self.left_in_row == 0 {
            self.rows.next_row()?;
            self.left_in_row = self.width;
        }
        self.left_in_row -= 1;
        self.rows.next_color()
    }
}

#[cfg(feature = "defmt")]
impl<D: ?Sized> defmt::Format for Generic<'_, D> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Generic");
    }
}
