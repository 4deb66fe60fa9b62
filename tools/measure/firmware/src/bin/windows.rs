//! Counts polygons against a convex window, and circles and text-sized rectangles against an upright one, apart by what
//! becomes of them.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    prelude::*,
    primitives::{Circle, Rectangle},
};
use zrow::{
    clip::{Classification, Clipper, Operation},
    geometry::{ConvexWindow, Sub4, Sub8, SubPixel, SubPoint, Window},
};
use zrow_measure_firmware::{
    inputs::Uniform,
    report,
    run::{Canvas, Runner},
    stopwatch::Stopwatch,
};

const SCREEN: Size = Size::new(240, 320);
/// Distance in pixels that a shape may have to the screen.
const MARGIN: i32 = 160;
/// A panel in perspective, in pixels.
const PANEL: [(i32, i32); 6] = [(40, 10), (200, 30), (236, 160), (190, 300), (50, 310), (4, 150)];
/// Corners of a polygon of the series.
const CORNERS: usize = 5;

/// All that was clipped, folded into one number.
struct Sum(u32);

impl Sum {
    fn add(&mut self, number: u32) {
        self.0 = self.0.rotate_left(5) ^ number;
    }

    fn add_classification(&mut self, classification: Classification) {
        self.add(match classification {
            Classification::Nothing => 1,
            Classification::Whole => 2,
            Classification::Fills => 3,
            Classification::Part => 4,
        });
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
    for (visibility, sub4, sub8) in [
        (
            Classification::Whole,
            "polygon.convex.inside.sub4",
            "polygon.convex.inside.sub8",
        ),
        (
            Classification::Part,
            "polygon.convex.crossing.sub4",
            "polygon.convex.crossing.sub8",
        ),
        (
            Classification::Nothing,
            "polygon.convex.outside.sub4",
            "polygon.convex.outside.sub8",
        ),
    ] {
        polygons::<Sub4>(&mut runner, sub4, visibility);
        polygons::<Sub8>(&mut runner, sub8, visibility);
    }
    shapes(&mut runner);
    report::exit(true)
}

type Polygon<S> = [SubPoint<S>; CORNERS];

fn polygons<S: SubPixel>(runner: &mut Runner, name: &str, wanted: Classification) {
    let corners = PANEL.map(|(x, y)| SubPoint::<S>::from_pixel(Point::new(x, y)).unwrap_or_default());
    let Ok(window) = ConvexWindow::new(black_box(&corners)) else {
        report::exit(false)
    };
    if !runner.wants(name) {
        return;
    }
    let mut uniform = Uniform::default();
    let inputs: [Polygon<S>; 100] = core::array::from_fn(|_| polygon(&mut uniform, &window, wanted));
    let mut sum = Sum(0);
    runner.count(name, "sutherland_hodgman_2d", &mut sum, &inputs, |sum, polygon| {
        let clipped = window.sutherland_hodgman_2d::<24, 6>(polygon);
        for corner in clipped.iter().flatten() {
            sum.add(corner.x_units() as u32);
            sum.add(corner.y_units() as u32);
        }
        sum.add(1);
    });
    let mut clipper = Clipper::<S, 64>::new();
    runner.count(name, "greiner_hormann", &mut sum, &inputs, |sum, polygon| {
        let clipped = clipper.greiner_hormann(&[polygon], &[&corners], Operation::Intersection);
        for contour in clipped.into_iter().flatten() {
            for corner in contour.points() {
                sum.add(corner.x_units() as u32);
                sum.add(corner.y_units() as u32);
            }
            sum.add(1);
        }
    });
}

/// The next polygon of the series that is so visible: up to 80 pixels wide and high, corners in any order.
fn polygon<S: SubPixel>(uniform: &mut Uniform, window: &ConvexWindow<'_, S>, wanted: Classification) -> Polygon<S> {
    loop {
        let around = uniform.around_screen(SCREEN, MARGIN);
        let polygon: Polygon<S> = core::array::from_fn(|_| {
            let mut unit = |at: i32| uniform.number((at - 40) << S::FRACTION_BITS, (at + 40) << S::FRACTION_BITS);
            SubPoint::from_units(unit(around.x), unit(around.y)).unwrap_or_default()
        });
        let found = match window.sutherland_hodgman_2d::<24, 6>(&polygon) {
            Ok(clipped) if clipped[..] == polygon => Classification::Whole,
            Ok(clipped) if clipped.is_empty() => Classification::Nothing,
            _ => Classification::Part,
        };
        if found == wanted {
            return polygon;
        }
    }
}

fn shapes(runner: &mut Runner) {
    let window: Window = black_box(Rectangle::new(Point::zero(), SCREEN)).into();
    for (wanted, circle, rectangle) in [
        (Classification::Whole, "circle.window.inside", "rectangle.window.inside"),
        (
            Classification::Part,
            "circle.window.crossing",
            "rectangle.window.crossing",
        ),
        (
            Classification::Nothing,
            "circle.window.outside",
            "rectangle.window.outside",
        ),
    ] {
        let mut uniform = Uniform::default();
        let mut place = || uniform.around_screen(SCREEN, MARGIN);
        let circles: [Circle; 200] = core::array::from_fn(|_| {
            next(
                || Circle::new(place(), 50),
                |circle| Classification::circle_against_window(circle, &window),
                wanted,
            )
        });
        let rectangles: [Rectangle; 200] = core::array::from_fn(|_| {
            let rectangle = || Rectangle::new(place(), Size::new(60, 10));
            next(
                rectangle,
                |shape| Classification::rectangle_against_window(shape, &window),
                wanted,
            )
        });
        let mut sum = Sum(0);
        if runner.wants(circle) {
            runner.count(circle, "circle_against_window", &mut sum, &circles, |sum, circle| {
                sum.add_classification(Classification::circle_against_window(circle, &window));
            });
        }
        if runner.wants(rectangle) {
            let variant = "rectangle_against_window";
            runner.count(rectangle, variant, &mut sum, &rectangles, |sum, rectangle| {
                sum.add_classification(Classification::rectangle_against_window(rectangle, &window));
            });
        }
    }
}

/// The next shape of a series that is so visible.
fn next<Shape>(
    mut shape: impl FnMut() -> Shape,
    classify: impl Fn(&Shape) -> Classification,
    wanted: Classification,
) -> Shape {
    loop {
        let shape = shape();
        if classify(&shape) == wanted {
            return shape;
        }
    }
}
