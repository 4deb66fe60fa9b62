//! Counts what only the accuracy report asks for: lines, curves, circles and corners on its own inputs, and the figures that
//! other rasterizers fill in `coverage_peers`.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use fixed::types::U8F8;
use heapless::Vec;
use zrow::{
    coverage::{CoverageMethod, InsideArea, SignedArea},
    draw::{AntialiasedPolygon, FillRule},
    geometry::TooSmall,
    geometry::{Sub8, SubPoint, Window},
};
use zrow_measure_firmware::{
    coverages, report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};
use zrow_methods::{
    CIRCLE_CORNERS, CIRCLE_SIZE, CURVE_SIBLINGS, CURVES, CircleInput, CircleMethod, Class, CurveInput, DISCS,
    FIGURE_SIZES, Figure, LINE_GROUPS, LINE_SIBLINGS, Line, OUTLINES, PRECISIONS, Rounded, SHAPES, SIZE, Shape,
    TIMED_RADIUS, TOLERANCES, curves,
};

/// Lines of a group.
const LINES: usize = 200;
/// Times that a circle is drawn.
const CIRCLES: usize = 10;
/// Columns and rows of the largest square.
const LARGEST: usize = 200;

/// Bytes of the largest picture.
struct Greys([u8; LARGEST * LARGEST]);

impl Canvas for Greys {
    fn erase(&mut self) {
        self.0.fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.iter().map(|grey| u16::from(*grey)))
    }
}

impl Greys {
    /// A square of so many columns.
    fn square(&mut self, size: usize) -> &mut [u8] {
        self.0.get_mut(..size * size).unwrap_or_default()
    }
}

/// What is handed over for nothing.
struct Nothing;

impl Canvas for Nothing {
    fn erase(&mut self) {}

    fn checksum(&mut self) -> u32 {
        0
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 1024];
    let wanted = report::wanted(&mut words);
    let greys = cortex_m::singleton!(: Greys = Greys([0; LARGEST * LARGEST]));
    let (Some(peripherals), Some(greys)) = (Peripherals::take(), greys) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    lines(&mut runner);
    flattened_curves(&mut runner);
    circles(&mut runner, greys, "circles.outline", OUTLINES);
    circles(&mut runner, greys, "circles.disc", DISCS);
    corners(&mut runner, greys);
    figures(&mut runner, greys);
    report::exit(true)
}

fn lines(runner: &mut Runner) {
    for group in LINE_GROUPS {
        if runner.wants(group.count) {
            let lines: Vec<Line, LINES> = group.lines().take(LINES).collect();
            for sibling in LINE_SIBLINGS {
                runner.count(group.count, sibling.name, &mut Nothing, &lines, |_, line| {
                    (sibling.walk)(line);
                });
            }
        }
    }
}

fn flattened_curves(runner: &mut Runner) {
    let inputs: Result<Vec<CurveInput, CURVES>, _> = curves().take(CURVES).collect();
    let Ok(inputs) = inputs else { report::exit(false) };
    for tolerance in TOLERANCES {
        if runner.wants(tolerance.count) {
            for sibling in CURVE_SIBLINGS {
                runner.count(tolerance.count, sibling.name, &mut Nothing, &inputs, |_, input| {
                    (sibling.walk)(&input.curve, U8F8::from_bits(tolerance.units));
                });
            }
        }
    }
}

fn circles(runner: &mut Runner, greys: &mut Greys, name: &str, methods: &[CircleMethod]) {
    if !runner.wants(name) {
        return;
    }
    for method in methods {
        let inputs: [CircleInput; CIRCLES] = core::array::from_fn(|_| method.input(TIMED_RADIUS));
        runner.count(name, method.variant, greys, &inputs, |greys, circle| {
            method.draw(circle, greys.square(CIRCLE_SIZE));
        });
    }
}

fn corners(runner: &mut Runner, greys: &mut Greys) {
    for class in Class::ALL {
        let name = class.corners_count_name();
        if runner.wants(name) {
            for precision in PRECISIONS {
                let rounded = (0..SHAPES).map(|number| Rounded::new(&class.shape_in(number, precision.units)));
                let rounded: Result<Vec<Rounded, { SHAPES as usize }>, _> = rounded.collect();
                let Ok(rounded) = rounded else { report::exit(false) };
                runner.count(name, precision.variant, greys, &rounded, |greys, shape| {
                    let mask = greys.square(SIZE);
                    mask.fill(0);
                    shape.fill(mask);
                });
            }
        }
    }
}

fn figures(runner: &mut Runner, greys: &mut Greys) {
    for figure in Figure::ALL {
        for size in FIGURE_SIZES {
            let name = figure.count_name(size);
            if runner.wants(name) {
                let shape = figure.shape(size);
                count_figure(runner, greys, name, "signed_area", &SignedArea, &shape, size);
                count_figure(runner, greys, name, "inside_area", &InsideArea, &shape, size);
            }
        }
    }
}

fn count_figure<T: CoverageMethod>(
    runner: &mut Runner,
    greys: &mut Greys,
    name: &str,
    variant: &str,
    method: &T,
    shape: &Shape,
    size: u32,
) {
    // The caller's, and empty after each shape.
    let mut memory = [T::Cell::default(); LARGEST + 1];
    let few = shape.contours.iter().map(|contour| contour.len()).sum::<usize>() < 8;
    runner.count(name, variant, greys, core::slice::from_ref(shape), |greys, shape| {
        if few {
            cover::<T, 8, 8>(method, greys, &mut memory, shape, size);
        } else {
            cover::<T, { 2 * CIRCLE_CORNERS }, { 2 * CIRCLE_CORNERS }>(method, greys, &mut memory, shape, size);
        }
    });
}

/// Sets the shape up and covers a square with it.
#[inline(never)]
fn cover<T: CoverageMethod, const EDGES: usize, const ACTIVE: usize>(
    method: &T,
    greys: &mut Greys,
    memory: &mut [T::Cell],
    shape: &Shape,
    size: u32,
) {
    let contours = shape.contours.iter().map(|contour| {
        let corners = contour.iter().map(|&(x, y)| SubPoint::<Sub8>::from_units(x, y));
        corners.collect::<Result<Vec<_, CIRCLE_CORNERS>, _>>()
    });
    let contours: Result<Vec<_, 2>, _> = contours.collect();
    let Ok(contours) = contours else { report::exit(false) };
    let slices: Vec<&[SubPoint<Sub8>], 2> = contours.iter().map(Vec::as_slice).collect();
    let Ok(polygon) = AntialiasedPolygon::<EDGES, ACTIVE>::prepare(slices.as_slice(), FillRule::NonZero) else {
        report::exit(false)
    };
    let window = Window {
        left: 0,
        top: 0,
        right: size as i32,
        bottom: size as i32,
    };
    let covered = polygon.cover(method, &window, memory, |span, coverage| {
        let row = span.y as usize * size as usize;
        if let Some(pixels) = greys.0.get_mut(row + span.start as usize..row + span.end as usize) {
            coverages::fill(pixels, coverage);
        }
        Ok::<_, TooSmall>(())
    });
    if covered.is_err() {
        report::exit(false)
    }
}
