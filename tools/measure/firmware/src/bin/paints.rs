//! Counts seed fills, and a rectangle in a colour, a pattern and gradients.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::{Circle, Rectangle},
};
use zrow::{
    band::{Band, Target},
    draw::{DrawOn, PrimitiveStyle, SeedFill},
    shade::{LinearGradient, Paint, Pattern, RadialGradient, Ramp},
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const SIDE: usize = 110;
const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(SIDE as u32, SIDE as u32));
const SQUARE: Rectangle = Rectangle::new(Point::new(5, 5), Size::new(100, 100));
const MIDDLE: Point = Point::new(54, 54);
const HATCH: [Rgb565; 4] = [Rgb565::RED, Rgb565::BLUE, Rgb565::BLUE, Rgb565::RED];

/// A picture that can be read back.
struct Picture<'a>(Band<'a, Rgb565>);

impl Canvas for Picture<'_> {
    fn erase(&mut self) {
        self.0.fill(Rgb565::BLACK);
        let ring = Circle::with_center(MIDDLE, 101).into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 3));
        let Ok(()) = ring.draw_on(&mut self.0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.words().iter().copied())
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let words = cortex_m::singleton!(: [u16; SIDE * SIDE] = [0; SIDE * SIDE]);
    let (Some(peripherals), Some(words)) = (Peripherals::take(), words) else {
        report::exit(false)
    };
    let Ok(band) = Band::new(AREA, words) else {
        report::exit(false)
    };
    let mut picture = Picture(band);
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    seed_fills(&mut runner, &mut picture);
    paints(&mut runner, &mut picture);
    report::exit(true)
}

/// A disc of 95 pixels, filled with one colour after the other, so that no fill finds its work done.
fn seed_fills(runner: &mut Runner, picture: &mut Picture<'_>) {
    let colors = [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE, Rgb565::YELLOW];
    for (name, eight) in [("seed_fill.disc.four", false), ("seed_fill.disc.eight", true)] {
        if !runner.wants(name) {
            continue;
        }
        runner.count(name, "flood_fill", picture, &colors, |picture, &color| {
            let mut fill = SeedFill::<_, 16>::flood(&picture.0, MIDDLE, color).eight_connected(eight);
            if fill.run(&mut picture.0).is_err() {
                report::exit(false);
            }
        });
    }
}

fn paints(runner: &mut Runner, picture: &mut Picture<'_>) {
    const NAME: &str = "paint.square";
    if !runner.wants(NAME) {
        return;
    }
    let ramp = Ramp::between(Rgb888::RED, Rgb888::GREEN);
    let (Ok(pattern), Ok(linear), Ok(radial)) = (
        Pattern::new(2, &HATCH),
        LinearGradient::<Rgb565, 2>::new(Point::new(5, 5), Point::new(104, 70), ramp),
        RadialGradient::<Rgb565, 2>::new(MIDDLE, 60, ramp),
    ) else {
        report::exit(false)
    };
    runner.count(NAME, "flat", picture, &[(); 4], |picture, ()| {
        let Ok(()) = SQUARE
            .into_styled(PrimitiveStyle::with_fill(Rgb565::RED))
            .draw_on(&mut picture.0);
    });
    paint(runner, NAME, "pattern", picture, pattern);
    paint(runner, NAME, "linear_gradient", picture, linear);
    paint(runner, NAME, "radial_gradient", picture, radial);
}

fn paint(runner: &mut Runner, name: &str, variant: &str, picture: &mut Picture<'_>, paint: impl Paint<Color = Rgb565>) {
    runner.count(name, variant, picture, &[(); 4], |picture, ()| {
        let style = PrimitiveStyle::with_fill(Rgb565::RED);
        let Ok(()) = SQUARE.into_styled(style).draw_on(&mut picture.0.painted(&paint));
    });
}
