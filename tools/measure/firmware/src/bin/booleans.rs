//! Counts intersection, union and difference of polygons with a hole each, apart by how the two lie.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::prelude::*;
use zrow::{
    clip::{Clipper, Contour, Operation},
    geometry::{InputError, Sub4, Sub8, SubPixel, SubPoint},
};
use zrow_measure_firmware::{
    inputs::Uniform,
    report,
    run::{Canvas, Runner},
    stopwatch::Stopwatch,
};

const SCREEN: Size = Size::new(240, 320);
/// Corners of an outer contour, and of a hole.
const OUTER: usize = 8;
const HOLE: usize = 4;

/// How the polygons of a pair lie.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pair {
    /// Their extents are apart.
    Apart,
    /// Crossing each other.
    Crossing,
    /// The same polygon twice.
    Same,
}

/// A polygon with a hole.
#[derive(Clone, Copy)]
struct Shape<S: SubPixel> {
    outer: [SubPoint<S>; OUTER],
    hole: [SubPoint<S>; HOLE],
}

impl<S: SubPixel> Shape<S> {
    fn contours(&self) -> [&[SubPoint<S>]; 2] {
        [&self.outer, &self.hole]
    }
}

/// All contours that a clipper gave, folded into one number, whatever their order and their first corners are.
struct Sum(u32);

impl Sum {
    fn add<'c, S: SubPixel>(&mut self, clipped: Result<impl Iterator<Item = Contour<'c, S>>, InputError>) {
        let Ok(clipped) = clipped else { report::exit(false) };
        for contour in clipped {
            self.0 = self.0.wrapping_add(u32::from(contour.is_hole()));
            for corner in contour.points() {
                let mixed = (corner.x_units() as u32).wrapping_mul(0x9e37_79b1) ^ corner.y_units() as u32;
                self.0 = self.0.wrapping_add(mixed.wrapping_mul(0x85eb_ca6b));
            }
        }
    }
}

impl Canvas for Sum {
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
    use Operation::{Difference, Intersection, Union};
    for (pair, operation, sub4, sub8) in [
        (Pair::Apart, Intersection, "polygon.apart.sub4", "polygon.apart.sub8"),
        (
            Pair::Crossing,
            Intersection,
            "polygon.intersection.sub4",
            "polygon.intersection.sub8",
        ),
        (Pair::Crossing, Union, "polygon.union.sub4", "polygon.union.sub8"),
        (
            Pair::Crossing,
            Difference,
            "polygon.difference.sub4",
            "polygon.difference.sub8",
        ),
        (Pair::Same, Intersection, "polygon.same.sub4", "polygon.same.sub8"),
    ] {
        count::<Sub4>(&mut runner, sub4, pair, operation);
        count::<Sub8>(&mut runner, sub8, pair, operation);
    }
    report::exit(true)
}

fn count<S: SubPixel>(runner: &mut Runner, name: &str, pair: Pair, operation: Operation) {
    if !runner.wants(name) {
        return;
    }
    let mut uniform = Uniform::default();
    let inputs: [(Shape<S>, Shape<S>); 50] = core::array::from_fn(|_| shapes(&mut uniform, pair));
    macro_rules! count {
        ($([$name:ident] [$($algorithm:tt)+])+) => {$(
            let mut clipper = Clipper::<S, 96>::new();
            runner.count(name, stringify!($name), &mut Sum(0), &inputs, |sum, (subject, clip)| {
                sum.add($($algorithm)+(&mut clipper, &subject.contours(), &clip.contours(), operation));
            });
        )+};
    }
    zrow_methods::booleans!(count);
}

fn shapes<S: SubPixel>(uniform: &mut Uniform, pair: Pair) -> (Shape<S>, Shape<S>) {
    let first = uniform.on_screen(SCREEN);
    let subject = shape(uniform, first);
    match pair {
        Pair::Apart => (subject, shape(uniform, first + Point::new(170, 0))),
        Pair::Crossing => {
            let offset = Point::new(uniform.number(-60, 60), uniform.number(-60, 60));
            (subject, shape(uniform, first + offset))
        }
        Pair::Same => (subject, subject),
    }
}

/// A star of uneven rays, 30 to 80 pixels long, around a hole of up to 20.
fn shape<S: SubPixel>(uniform: &mut Uniform, center: Point) -> Shape<S> {
    /// Eight directions, 16 units long.
    const RAYS: [(i32, i32); OUTER] = [
        (16, 0),
        (11, 11),
        (0, 16),
        (-11, 11),
        (-16, 0),
        (-11, -11),
        (0, -16),
        (11, -11),
    ];
    let mut corner = |(x, y): (i32, i32), low: i32, high: i32| {
        let unit = 1 << S::FRACTION_BITS;
        let length = uniform.number(low * unit, high * unit);
        let at = |center: i32, ray: i32| center * unit + ray * length / 16;
        SubPoint::from_units(at(center.x, x), at(center.y, y)).unwrap_or_default()
    };
    Shape {
        outer: RAYS.map(|ray| corner(ray, 30, 80)),
        hole: core::array::from_fn(|index| corner(RAYS.get(2 * index).copied().unwrap_or_default(), 5, 20)),
    }
}
