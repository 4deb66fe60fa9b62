//! Counts dithering of a frame of 240 x 320 pixels, row by row in place: one where neighbours are never alike, and one of a single
//! colour.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use zrow::{
    band::{Band, BandColor},
    shade::ChannelColor,
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const WIDTH: usize = 240;
const HEIGHT: usize = 320;
const ROW: Size = Size::new(WIDTH as u32, 1);

/// A frame in a colour of 8 bits a channel, which is dithered where it lies, and what it shows: the colour of each pixel.
struct Frame<'a, C: ChannelColor> {
    words: &'a mut [<C::EightBit as BandColor>::Word],
    color: fn(Point) -> C::EightBit,
}

impl<C: ChannelColor> Frame<'_, C> {
    /// Dithers all rows, each as a band of its own.
    #[inline(never)]
    fn dither(&mut self) {
        for (y, words) in (0..).zip(self.words.chunks_exact_mut(WIDTH)) {
            let area = black_box(Rectangle::new(Point::new(0, y), ROW));
            if let Ok(band) = Band::<C::EightBit>::new(area, words) {
                black_box(band.into_dithered::<C>().words());
            }
        }
    }
}

impl<C: ChannelColor> Canvas for Frame<'_, C>
where
    <C::EightBit as BandColor>::Word: Into<u32>,
{
    fn erase(&mut self) {
        for (index, word) in (0..).zip(self.words.iter_mut()) {
            let position = Point::new(index % WIDTH as i32, index / WIDTH as i32);
            *word = Band::<C::EightBit>::word((self.color)(position));
        }
    }

    /// That of the dithered words, which lie in the first ones of each row.
    fn checksum(&mut self) -> u32 {
        let mut sum = Checksum::default();
        let dithered = WIDTH * size_of::<C::Word>() / size_of::<<C::EightBit as BandColor>::Word>();
        for words in self.words.chunks_exact(WIDTH) {
            let words = words.iter().take(dithered).map(|&word| word.into());
            sum.add(words.flat_map(|word| [word as u16, (word >> 16) as u16]));
        }
        sum.0
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let colors = cortex_m::singleton!(: [u32; WIDTH * HEIGHT] = [0; WIDTH * HEIGHT]);
    let greys = cortex_m::singleton!(: [u8; WIDTH * HEIGHT] = [0; WIDTH * HEIGHT]);
    let (Some(peripherals), Some(colors), Some(greys)) = (Peripherals::take(), colors, greys) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let color = |point: Point| Rgb888::new(point.x as u8, (point.x + point.y) as u8, point.y as u8);
    count::<Rgb565>(&mut runner, "dither.rgb565", colors, color);
    count::<Rgb565>(&mut runner, "dither.rgb565.flat", colors, |_| Rgb888::new(12, 16, 24));
    let grey = |point: Point| Gray8::new((point.x + point.y) as u8);
    count::<Gray4>(&mut runner, "dither.gray4", greys, grey);
    count::<Gray4>(&mut runner, "dither.gray4.flat", greys, |_| Gray8::new(24));
    count::<BinaryColor>(&mut runner, "dither.binary", greys, grey);
    report::exit(true)
}

fn count<C: ChannelColor>(
    runner: &mut Runner<'_>,
    name: &str,
    words: &mut [<C::EightBit as BandColor>::Word],
    color: fn(Point) -> C::EightBit,
) where
    <C::EightBit as BandColor>::Word: Into<u32>,
{
    if runner.wants(name) {
        // Once: what is dithered is no picture to dither any more.
        runner.count(name, "dither", &mut Frame::<C> { words, color }, &[()], |frame, ()| {
            frame.dither()
        });
    }
}
