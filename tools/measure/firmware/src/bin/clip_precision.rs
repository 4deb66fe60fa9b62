//! Counts what the end of a clipped line costs at several precisions, against keeping the error term.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::geometry::Point;
use zrow::{
    clip::Segments,
    geometry::{FixedPointWindow, SubPoint},
    scan::Lines,
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Runner},
    stopwatch::Stopwatch,
};
use zrow_methods::{Fraction, SCREEN, clip_window, cut_lines};

/// All results, folded into one number.
struct Ends(u32);

impl Ends {
    fn add(&mut self, number: i32) {
        self.0 = self.0.rotate_left(5) ^ number as u32;
    }

    #[inline(always)]
    fn add_clipped<const BITS: u32>(&mut self, (from, to): &(Point, Point), window: &FixedPointWindow<Fraction<BITS>>) {
        let point = |point: &Point| SubPoint {
            x: point.x << BITS,
            y: point.y << BITS,
        };
        if let Some((from, to)) = Segments::liang_barsky(point(from), point(to), window) {
            for units in [from.x, from.y, to.x, to.y] {
                self.add(units);
            }
        }
    }
}

impl Canvas for Ends {
    fn erase(&mut self) {
        self.0 = 0;
    }

    fn checksum(&mut self) -> u32 {
        self.0
    }
}

/// The count of this firmware.
const NAME: &str = "clip.precision";

#[entry]
fn main() -> ! {
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), NAME);
    let mut lines = cut_lines();
    let lines: [(Point, Point); 200] = core::array::from_fn(|_| lines.next().unwrap_or_default());
    rounded::<0>(&mut runner, "whole_pixel", &lines);
    rounded::<4>(&mut runner, "1_16", &lines);
    rounded::<8>(&mut runner, "1_256", &lines);
    rounded::<16>(&mut runner, "1_65536", &lines);
    rounded_in_grown_window::<8>(&mut runner, "1_256_grown", &lines);
    rounded_in_grown_window::<16>(&mut runner, "1_65536_grown", &lines);
    runner.count(NAME, "error_term_kept", &mut Ends(0), &lines, |ends, &(from, to)| {
        if let Some(start) = black_box(Lines::bresenham(from, to, &SCREEN)).next() {
            ends.add(start.x ^ start.y);
        }
    });
    report::exit(true)
}

fn rounded<const BITS: u32>(runner: &mut Runner, variant: &str, lines: &[(Point, Point)]) {
    let window = window::<BITS>((false, false));
    runner.count(NAME, variant, &mut Ends(0), lines, |ends, line| {
        ends.add_clipped(line, &window);
    });
}

/// Larger by half a pixel on the minor axis of the line.
fn rounded_in_grown_window<const BITS: u32>(runner: &mut Runner, variant: &str, lines: &[(Point, Point)]) {
    let (wide, high) = (window::<BITS>((true, false)), window::<BITS>((false, true)));
    runner.count(NAME, variant, &mut Ends(0), lines, |ends, line| {
        let delta = line.1 - line.0;
        let is_x_major = delta.x.abs() >= delta.y.abs();
        ends.add_clipped(line, if is_x_major { &high } else { &wide });
    });
}

fn window<const BITS: u32>(grown: (bool, bool)) -> FixedPointWindow<Fraction<BITS>> {
    match clip_window(&SCREEN, grown) {
        Ok(window) => window,
        Err(_) => report::exit(false),
    }
}
