//! Counts the segment clippers at both precisions, apart by what becomes of the segment, and mixed.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use zrow::{
    clip::Segments,
    geometry::{ConvexWindow, FixedPointWindow, Sub4, Sub8, SubPixel, SubPoint, Window},
};
use zrow_measure_firmware::{
    inputs::Uniform,
    report,
    run::{Canvas, Runner},
    stopwatch::Stopwatch,
};

const WINDOW: Window = Window {
    left: 0,
    top: 0,
    right: 240,
    bottom: 320,
};
/// Distance in pixels that a point may have to the window.
const MARGIN: i32 = 600;

/// What becomes of a segment.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Fate {
    /// Accepted as it is.
    Inside,
    /// Accepted after a cut.
    Crossing,
    /// Rejected.
    Outside,
}

/// What becomes of one segment after the other: a quarter is inside, a quarter crosses, half is outside.
const MIXED: [Fate; 4] = [Fate::Inside, Fate::Outside, Fate::Crossing, Fate::Outside];

type Segment<S> = (SubPoint<S>, SubPoint<S>);

/// The window, and all that was clipped to it, folded into one number.
struct Clipped<S: SubPixel> {
    window: FixedPointWindow<S>,
    sum: u32,
}

impl<S: SubPixel> Clipped<S> {
    fn add(&mut self, segment: Option<Segment<S>>) {
        match segment {
            Some((from, to)) => {
                for units in [from.x_units(), from.y_units(), to.x_units(), to.y_units()] {
                    self.sum = self.sum.rotate_left(5) ^ units as u32;
                }
            }
            None => self.sum = self.sum.rotate_left(5) ^ 1,
        }
    }
}

impl<S: SubPixel> Canvas for Clipped<S> {
    fn erase(&mut self) {
        self.sum = 0;
    }

    fn checksum(&mut self) -> u32 {
        self.sum
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
    for (fates, sub4, sub8) in [
        (&[Fate::Inside][..], "segment.inside.sub4", "segment.inside.sub8"),
        (&[Fate::Crossing], "segment.crossing.sub4", "segment.crossing.sub8"),
        (&[Fate::Outside], "segment.outside.sub4", "segment.outside.sub8"),
        (&MIXED, "segment.mixed.sub4", "segment.mixed.sub8"),
    ] {
        clippers::<Sub4>(&mut runner, sub4, fates);
        clippers::<Sub8>(&mut runner, sub8, fates);
    }
    report::exit(true)
}

/// Counts all clippers with the same segments.
fn clippers<S: SubPixel>(runner: &mut Runner, name: &str, fates: &[Fate]) {
    let Ok(window) = FixedPointWindow::between_centers(&WINDOW) else {
        report::exit(false)
    };
    let (first, last) = (window.top_left(), window.bottom_right());
    let corner = |x, y| SubPoint { x, y };
    let corners = [first, corner(last.x, first.y), last, corner(first.x, last.y)];
    let Ok(convex) = ConvexWindow::new(black_box(&corners)) else {
        report::exit(false)
    };
    if !runner.wants(name) {
        return;
    }
    let mut uniform = Uniform::default();
    let mut fates = fates.iter().cycle();
    let inputs: [Segment<S>; 200] =
        core::array::from_fn(|_| segment(&mut uniform, &window, fates.next().copied().unwrap_or(Fate::Outside)));
    let mut clipped = Clipped { window, sum: 0 };
    macro_rules! count {
        ($([$name:ident] [$($clip:tt)+])+) => {$(
            runner.count(name, stringify!($name), &mut clipped, &inputs, |canvas, &(from, to)| {
                canvas.add($($clip)+(from, to, &canvas.window));
            });
        )+};
    }
    zrow_methods::segments!(count);
    runner.count(name, "cyrus_beck", &mut clipped, &inputs, |canvas, &(from, to)| {
        let part = Segments::cyrus_beck(from, to, &convex);
        canvas.add(part.map(|part| part.ends_within(&convex)));
    });
}

/// The next segment of the series that meets this fate.
fn segment<S: SubPixel>(uniform: &mut Uniform, window: &FixedPointWindow<S>, fate: Fate) -> Segment<S> {
    let margin = if fate == Fate::Inside { 0 } else { MARGIN } << S::FRACTION_BITS;
    let mut point = || {
        let x = uniform.number(-margin, ((WINDOW.right - 1) << S::FRACTION_BITS) + margin);
        let y = uniform.number(-margin, ((WINDOW.bottom - 1) << S::FRACTION_BITS) + margin);
        SubPoint::from_units(x, y).unwrap_or_default()
    };
    loop {
        let whole = (point(), point());
        let found = match Segments::liang_barsky(whole.0, whole.1, window) {
            None => Fate::Outside,
            Some(clipped) if clipped == whole => Fate::Inside,
            Some(_) => Fate::Crossing,
        };
        if found == fate {
            return whole;
        }
    }
}
