//! Counts the thin circles and ellipses at 240 x 320 RGB565 on a full-frame `Band`, each pixel by pixel through the same
//! loop.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use zrow::band::{Band, Target};
use zrow_measure_firmware::{
    inputs::{Colored, Uniform, colored},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const SCREEN: Size = Size::new(240, 320);
const PIXELS: usize = (SCREEN.width * SCREEN.height) as usize;

/// The screen.
struct Frame<'a>(Band<'a, Rgb565>);

impl Canvas for Frame<'_> {
    fn erase(&mut self) {
        self.0.words_mut().fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.words().iter().copied())
    }
}

impl Frame<'_> {
    fn draw(&mut self, pixels: impl Iterator<Item = Point>, color: Rgb565) {
        let Ok(()) = self.0.draw_iter(pixels.map(|point| Pixel(point, color)));
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let words = cortex_m::singleton!(: [u16; PIXELS] = [0; PIXELS]);
    let (Some(peripherals), Some(words)) = (Peripherals::take(), words) else {
        report::exit(false)
    };
    let Ok(band) = Band::new(Rectangle::new(Point::zero(), SCREEN), words) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let mut frame = Frame(band);
    circles(&mut runner, &mut frame);
    ellipses(&mut runner, &mut frame);
    report::exit(true)
}

/// A radius of 10 to 100 pixels.
fn radius(uniform: &mut Uniform) -> u32 {
    uniform.number(10, 101).unsigned_abs()
}

fn circles(runner: &mut Runner, frame: &mut Frame<'_>) {
    let inputs: [Colored<(Point, u32)>; 100] = colored(|uniform| (uniform.on_screen(SCREEN), radius(uniform)));
    macro_rules! count {
        ($([$name:ident] [$($circle:tt)+])+) => {$(
            runner.count("round.circle", stringify!($name), frame, &inputs, |frame, input| {
                let (center, radius) = input.shape;
                let circle = $($circle)+(center, radius, &frame.0.window());
                frame.draw(circle.into_iter().flatten(), input.color);
            });
        )+};
    }
    if runner.wants("round.circle") {
        zrow_methods::circles!(count);
    }
}

fn ellipses(runner: &mut Runner, frame: &mut Frame<'_>) {
    let inputs: [Colored<(Point, Size)>; 100] =
        colored(|uniform| (uniform.on_screen(SCREEN), Size::new(radius(uniform), radius(uniform))));
    macro_rules! count {
        ($([$name:ident] [$($ellipse:tt)+])+) => {$(
            runner.count("round.ellipse", stringify!($name), frame, &inputs, |frame, input| {
                let (center, radii) = input.shape;
                let ellipse = $($ellipse)+(center, radii, &frame.0.window());
                frame.draw(ellipse.into_iter().flatten(), input.color);
            });
        )+};
    }
    if runner.wants("round.ellipse") {
        zrow_methods::ellipses!(count);
    }
}
