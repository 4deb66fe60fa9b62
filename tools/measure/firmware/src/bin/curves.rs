//! Counts the ways to flatten a Bézier curve, apart by degree, size and tolerance.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use fixed::types::U8F8;
use zrow::{
    geometry::{Sub8, SubPoint},
    scan::Bezier,
};
use zrow_measure_firmware::{
    inputs::Uniform,
    report,
    run::{Canvas, Runner},
    stopwatch::Stopwatch,
};

/// Columns and rows that control points are on, in pixels.
const SCREEN: (i32, i32) = (240, 320);
const GLYPH: (i32, i32) = (16, 16);

/// The ends of all lines, folded into one number.
struct Ends(u32);

impl Ends {
    fn add(&mut self, ends: impl Iterator<Item = SubPoint<Sub8>>) {
        for end in ends {
            for units in [end.x_units(), end.y_units()] {
                self.0 = self.0.rotate_left(5) ^ units as u32;
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

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let (usual, fine) = (U8F8::lit("0.125"), U8F8::lit("0.0078125"));
    flatten::<3>(&mut runner, "curve.quadratic", SCREEN, usual);
    flatten::<4>(&mut runner, "curve.cubic", SCREEN, usual);
    flatten::<4>(&mut runner, "curve.cubic.fine", SCREEN, fine);
    flatten::<4>(&mut runner, "curve.cubic.glyph", GLYPH, usual);
    report::exit(true)
}

/// Counts the siblings with the same curves.
fn flatten<const CONTROLS: usize>(runner: &mut Runner, name: &str, size: (i32, i32), tolerance: U8F8) {
    let mut uniform = Uniform::default();
    let inputs: [Bezier<CONTROLS>; 100] = core::array::from_fn(|_| curve(&mut uniform, size));
    if runner.wants(name) {
        let mut ends = Ends(0);
        macro_rules! count {
            ($([$name:ident] [$($flatten:tt)+])+) => {$(
                runner.count(name, stringify!($name), &mut ends, &inputs, |ends, curve| {
                    ends.add($($flatten)+(curve, tolerance));
                });
            )+};
        }
        zrow_methods::curves!(count);
    }
}

/// The next curve of the series.
fn curve<const CONTROLS: usize>(uniform: &mut Uniform, (width, height): (i32, i32)) -> Bezier<CONTROLS> {
    let controls = core::array::from_fn(|_| {
        let (x, y) = (uniform.number(0, width * 256), uniform.number(0, height * 256));
        SubPoint::<Sub8>::from_units(x, y).unwrap_or_default()
    });
    match Bezier::new(controls) {
        Ok(curve) => curve,
        Err(_) => report::exit(false),
    }
}
