//! Counts rows of a picture that meet one item of many corners: kept by copy, or drawn anew in each row by reference.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box};

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Polyline, Rectangle, StrokeAlignment},
};
use zrow::{
    band::{Band, PictureLoop},
    draw::{FillRule, LineCap, LineJoin, Picture, PictureItem, PictureSlot, Polygon, PrimitiveStyle, StrokeStyle},
    fixed::types::U16F16,
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const SIDE: usize = 200;
const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(SIDE as u32, SIDE as u32));

type Prepared<'m, 'a> = Picture<'m, 'a, Rgb565>;

/// A star of five points, 190 rows high.
const STAR: [Point; 10] = [
    Point::new(100, 3),
    Point::new(123, 71),
    Point::new(196, 72),
    Point::new(138, 115),
    Point::new(160, 184),
    Point::new(101, 193),
    Point::new(41, 185),
    Point::new(62, 116),
    Point::new(4, 73),
    Point::new(77, 70),
];

/// A dash and a gap that are longer than the stroke is wide.
const DASHES: [U16F16; 2] = [U16F16::lit("7"), U16F16::lit("5")];

/// A picture of one item.
struct Frame<'m, 'a>(Prepared<'m, 'a>);

impl Frame<'_, '_> {
    /// Draws all rows, and hands on each.
    #[inline(never)]
    fn draw(&mut self, mut output: impl FnMut(&[u16])) {
        let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
            output(black_box(band.words()));
            Ok(())
        };
        let bands = PictureLoop::new(AREA, Rgb565::BLACK).rows(1);
        if bands.draw(&mut [0; SIDE], &mut sink, |band| self.0.draw(band)).is_err() {
            report::exit(false)
        }
    }
}

impl Canvas for Frame<'_, '_> {
    fn erase(&mut self) {}

    fn checksum(&mut self) -> u32 {
        let mut sum = Checksum::default();
        self.draw(|words| sum.add(words.iter().copied()));
        sum.0
    }
}

/// Counts a frame of a picture to which something is added.
fn count<'a>(runner: &mut Runner<'_>, name: &str, variant: &str, add: impl FnOnce(&mut Prepared<'_, 'a>) -> bool) {
    if !runner.wants(name) {
        return;
    }
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 6_000], [0; SIDE]);
    let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets);
    if !add(&mut picture) {
        report::exit(false)
    }
    runner.count(name, variant, &mut Frame(picture), &[(); 2], |frame, ()| {
        frame.draw(|words| {
            black_box(words);
        });
    });
}

/// Counts an item by reference.
fn count_reference<T: PictureItem<Rgb565>>(runner: &mut Runner<'_>, name: &str, item: &T) {
    count(runner, name, "reference", |picture| picture.add_item(item).is_ok());
}

#[entry]
fn main() -> ! {
    let mut words = [0; 512];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let runner = &mut runner;
    count(runner, "picture.empty", "copy", |_| true);

    let contours = black_box([STAR.as_slice()]);
    let star = Polygon::new(&contours, FillRule::NonZero);
    let Ok(prepared) = star.prepare::<10, 6>() else {
        report::exit(false)
    };
    let fill = PrimitiveStyle::with_fill(Rgb565::RED);
    count(runner, "picture.star", "copy", |picture| {
        picture.add(&star.into_styled(fill)).is_ok()
    });
    count_reference(runner, "picture.star", &prepared.into_styled(fill));

    let wide = PrimitiveStyle::with_stroke(Rgb565::RED, 3);
    count(runner, "picture.star_stroke", "copy", |picture| {
        picture.add(&star.into_styled(wide)).is_ok()
    });
    count_reference(runner, "picture.star_stroke", &prepared.into_styled(wide));

    let thin = PrimitiveStyle::with_stroke(Rgb565::RED, 1);
    let values: [Point; 60] = black_box(core::array::from_fn(|index| {
        let index = index as i32;
        Point::new(3 * index + 10, 100 + (index * index * 7 % 83) - index % 5 * 6)
    }));
    let chart = Polyline::new(&values).into_styled(thin);
    count(runner, "picture.chart", "copy", |picture| picture.add(&chart).is_ok());
    count_reference(runner, "picture.chart", &chart);

    let chart = Polyline::new(&values).into_styled(wide);
    count(runner, "picture.wide_chart", "copy", |picture| {
        picture.add(&chart).is_ok()
    });
    count_reference(runner, "picture.wide_chart", &chart);

    let dashed = StrokeStyle::new(Rgb565::RED, 3)
        .cap(LineCap::Round)
        .join(LineJoin::Round)
        .dashes(&DASHES);
    let chart = Polyline::new(&values).into_styled(dashed);
    count(runner, "picture.dashed_chart", "copy", |picture| {
        picture.add(&chart).is_ok()
    });
    count_reference(runner, "picture.dashed_chart", &chart);

    let mut inner = wide;
    inner.stroke_alignment = StrokeAlignment::Inside;
    count(runner, "picture.inner_star", "copy", |picture| {
        picture.add(&star.into_styled(inner)).is_ok()
    });
    count_reference(runner, "picture.inner_star", &prepared.into_styled(inner));
    report::exit(true)
}
