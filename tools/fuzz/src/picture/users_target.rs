//! A target that a user writes: only what [`Target`] asks for, and nothing of its own.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    image::GetPixel,
    pixelcolor::PixelColor,
    primitives::Rectangle,
};
use std::cell::Cell;
use zrow::{
    geometry::Window,
    surface::{LineSteps, Span, Target},
};

use crate::picture::{Sheet, Stopped};

/// A [`Sheet`] that takes spans, windows and steps, as they come: what is outside of it is noted there.
#[derive(Debug)]
pub struct UsersTarget<'s, C> {
    sheet: &'s mut Sheet<C>,
    /// Pixels that were read.
    reads: Cell<u64>,
    most_reads: u64,
}

impl<'s, C: PixelColor> UsersTarget<'s, C> {
    /// A target on a sheet.
    pub const fn new(sheet: &'s mut Sheet<C>) -> Self {
        Self {
            sheet,
            reads: Cell::new(0),
            most_reads: u64::MAX,
        }
    }

    /// The target that has no pixels any more when it was read so often.
    pub const fn with_most_reads(mut self, reads: u64) -> Self {
        self.most_reads = reads;
        self
    }

    /// How often a pixel was read.
    pub const fn reads(&self) -> u64 {
        self.reads.get()
    }
}

impl<C> Dimensions for UsersTarget<'_, C>
where
    C: PixelColor,
{
    fn bounding_box(&self) -> Rectangle {
        self.sheet.bounding_box()
    }
}

impl<C: PixelColor> DrawTarget for UsersTarget<'_, C> {
    type Color = C;
    type Error = Stopped;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Stopped> {
        self.sheet.draw_iter(pixels)
    }
}

impl<C: PixelColor> Target for UsersTarget<'_, C> {
    type Raw = C;

    fn window(&self) -> Window {
        self.sheet.bounding_box().into()
    }

    fn raw(&self, color: C) -> C {
        color
    }

    fn fill_span(&mut self, span: Span, raw: C) -> Result<(), Stopped> {
        self.fill_window(span.to_window(), raw)
    }

    fn fill_window(&mut self, window: Window, raw: C) -> Result<(), Stopped> {
        self.sheet.fill_solid(&window.to_rectangle(), raw)
    }

    fn draw_steps(&mut self, steps: LineSteps, raw: C) -> Result<(), Stopped> {
        self.sheet.draw_iter(steps.into_iter().map(|point| Pixel(point, raw)))
    }
}

impl<C: PixelColor> GetPixel for UsersTarget<'_, C> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        self.reads.set(self.reads.get() + 1);
        self.sheet.pixel(point).filter(|_| self.reads.get() <= self.most_reads)
    }
}
