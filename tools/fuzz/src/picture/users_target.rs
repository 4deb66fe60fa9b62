//! A display that a user writes: a draw target that can be read back, to be wrapped in [`Generic`](zrow::band::Generic).

use std::cell::Cell;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    image::GetPixel,
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::picture::{Sheet, Stopped};

/// A [`Sheet`] that takes areas of one colour and pixels, as they come: what is outside of it is noted there. Areas of many
/// colours come pixel by pixel, as embedded-graphics has it where a driver leaves them out.
#[derive(Debug)]
pub struct UsersTarget<'s, C> {
    sheet: &'s mut Sheet<C>,
    /// Pixels that were read.
    reads: Cell<u64>,
    most_reads: u64,
}

impl<'s, C: PixelColor> UsersTarget<'s, C> {
    /// A display on a sheet.
    pub const fn new(sheet: &'s mut Sheet<C>) -> Self {
        Self {
            sheet,
            reads: Cell::new(0),
            most_reads: u64::MAX,
        }
    }

    /// The display that has no pixels any more when it was read so often.
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

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Stopped> {
        self.sheet.fill_solid(area, color)
    }
}

impl<C: PixelColor> GetPixel for UsersTarget<'_, C> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        self.reads.set(self.reads.get() + 1);
        self.sheet.pixel(point).filter(|_| self.reads.get() <= self.most_reads)
    }
}
