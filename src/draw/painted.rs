//! Any shape filled with a pattern or a gradient: a target that replaces the colour of each pixel by the colour of a
//! paint.
//!
//! Each span, window or line that is drawn on the target becomes the paint's colours from its first pixel on, which are
//! passed to the target below.
//!
//! Guarantees: exactly the pixels that were drawn, each in the paint's colour at its position. Colours depend neither
//! on whether a shape is drawn in spans, windows or lines, nor on the band. Memory: none.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    primitives::Rectangle,
};

use crate::{
    geometry::Window,
    surface::{BatchTarget, LineSteps, Paint, Painted, Span, Target, contiguous::ContiguousRows},
};

impl<T, P> Painted<'_, T, P>
where
    T: Target,
    P: Paint<Color = T::Color>,
{
    /// The pixels at `points` in the paint's colours. A point that lies directly right of the one before takes the next
    /// colour of the same row iterator, because setting a row up can take a division.
    fn pixels<'p>(
        paint: &'p P,
        points: impl Iterator<Item = Point> + 'p,
    ) -> impl Iterator<Item = Pixel<T::Color>> + 'p {
        let mut row = None;
        points.filter_map(move |point| {
            let (_, mut colors) = row
                .take()
                .filter(|(next, _)| *next == point)
                .unwrap_or_else(|| (point, paint.colors_from(point)));
            let color = colors.next();
            row = point.x.checked_add(1).map(|x| (Point::new(x, point.y), colors));
            color.map(|color| Pixel(point, color))
        })
    }
}

impl<T: Dimensions, P> Dimensions for Painted<'_, T, P> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounding_box()
    }
}

impl<T, P> DrawTarget for Painted<'_, T, P>
where
    T: Target,
    P: Paint<Color = T::Color>,
{
    type Color = T::Color;
    type Error = T::Error;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), T::Error>
    where
        I: IntoIterator<Item = Pixel<T::Color>>,
    {
        let Self { target, paint } = self;
        let points = pixels.into_iter().map(|Pixel(point, _)| point);
        target.draw_iter(Self::pixels(paint, points))
    }

    /// Paints the pixels of the area for which `colors` has an element. The values of these colours are ignored.
    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), T::Error>
    where
        I: IntoIterator<Item = T::Color>,
    {
        let visible = Window::from(*area).intersection(&self.window());
        let mut rows = ContiguousRows::new(area, visible, colors.into_iter());
        while let Some((span, colors)) = rows.next_row() {
            let painted = self.paint.colors_from(Point::new(span.start, span.y));
            let mut colors = colors.take(visible.width() as usize).fuse();
            let row = span.to_window().to_rectangle();
            self.target
                .fill_contiguous(&row, colors.by_ref().zip(painted).map(|(_, color)| color))?;
            // Takes the row's colours that the target left unread, so that the next row begins with its own.
            colors.for_each(drop);
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, _: T::Color) -> Result<(), T::Error> {
        self.fill_window(Window::from(*area), ())
    }
}

impl<T, P> Target for Painted<'_, T, P>
where
    T: Target,
    P: Paint<Color = T::Color>,
{
    fn window(&self) -> Window {
        self.target.window()
    }

    /// There is no raw colour: the paint decides the colour of each pixel.
    fn raw(&self, _: T::Color) {}
}

impl<T, P> BatchTarget for Painted<'_, T, P>
where
    T: Target,
    P: Paint<Color = T::Color>,
{
    type Raw = ();

    fn fill_clipped_span(&mut self, span: Span, (): ()) -> Result<(), T::Error> {
        if span.is_empty() {
            return Ok(());
        }
        let colors = self.paint.colors_from(Point::new(span.start, span.y));
        let area = span.to_window().to_rectangle();
        self.target
            .fill_contiguous(&area, colors.take(area.size.width as usize))
    }

    fn fill_clipped_window(&mut self, window: Window, (): ()) -> Result<(), T::Error> {
        if window.is_empty() {
            return Ok(());
        }
        for y in window.top..window.bottom {
            self.fill_clipped_span(Span::new(y, window.left, window.right), ())?;
        }
        Ok(())
    }

    fn draw_steps(&mut self, steps: &LineSteps, (): ()) -> Result<(), T::Error> {
        let Self { target, paint } = self;
        target.draw_iter(Self::pixels(paint, steps.into_iter()))
    }
}

#[cfg(feature = "defmt")]
impl<T, P> defmt::Format for Painted<'_, T, P> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Painted");
    }
}
