//! Counts a short text in fonts of several kinds, of which the letters are about as high: into a frame buffer of 160 x 32 pixels
//! at once, and row by row.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::Rgb565,
    primitives::Rectangle,
};
use zrow::band::Band;
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
    text::{self, HEIGHT, Memory, WIDTH},
};

struct FrameBuffer([u16; WIDTH * HEIGHT]);

impl Canvas for FrameBuffer {
    fn erase(&mut self) {
        self.0.fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.iter().copied())
    }
}

/// A band of the frame buffer: its first row, and how many rows it has.
type Rows = (usize, usize);

impl FrameBuffer {
    fn draw(&mut self, &(top, rows): &Rows, draw: &mut impl FnMut(&mut Band<'_, Rgb565>)) {
        let area = Rectangle::new(Point::new(0, top as i32), Size::new(WIDTH as u32, rows as u32));
        let words = self.0.get_mut(top * WIDTH..(top + rows) * WIDTH).unwrap_or_default();
        let Ok(mut band) = Band::new(area, words) else {
            report::exit(false)
        };
        draw(&mut band);
    }
}

#[entry]
fn main() -> ! {
    static mut MEMORY: Memory = Memory::new();
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let buffer = cortex_m::singleton!(: FrameBuffer = FrameBuffer([0; WIDTH * HEIGHT]));
    let (Some(peripherals), Some(buffer)) = (Peripherals::take(), buffer) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let mut count = |variant: &str, draw: &mut dyn FnMut(&mut Band<'_, Rgb565>)| {
        let rows: [Rows; HEIGHT] = core::array::from_fn(|row| (row, 1));
        runner.count("text.frame", variant, buffer, &[(0, HEIGHT)], |buffer, rows| {
            buffer.draw(rows, &mut |band: &mut Band<'_, Rgb565>| draw(band));
        });
        runner.count("text.row", variant, buffer, &rows, |buffer, rows| {
            buffer.draw(rows, &mut |band: &mut Band<'_, Rgb565>| draw(band));
        });
    };
    count("outlines", &mut text::outlines);
    count("masks", &mut text::masks);
    count("mono", &mut text::mono);
    count("embedded_graphics", &mut text::embedded_graphics);
    count("u8g2", &mut text::u8g2);
    let mut picture = MEMORY.outlines();
    count("outlines_prepared", &mut |band| picture.draw(band));
    let mut picture = MEMORY.masks();
    count("masks_prepared", &mut |band| picture.draw(band));
    report::exit(true)
}
