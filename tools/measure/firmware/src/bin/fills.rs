//! Counts the ways to fill a polygon, those to fill a triangle, and those to interpolate over one, on a full-frame `Band` of
//! 240 x 320 RGB565.
//!
//! Each way hands its spans to the band: the pixels are part of the count, and equal checksums are equal pictures.
#![no_std]
#![no_main]

use core::convert::Infallible;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use zrow::{
    band::{Band, Span, Target},
    geometry::{Sub4, Sub8, SubPixel, SubPoint, Window},
    scan::{FillRule, Polygons},
};
use zrow_measure_firmware::{
    inputs::{Colored, Uniform, colored},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const SCREEN: Size = Size::new(240, 320);
const PIXELS: usize = (SCREEN.width * SCREEN.height) as usize;
const WINDOW: Window = Window {
    left: 0,
    top: 0,
    right: SCREEN.width as i32,
    bottom: SCREEN.height as i32,
};
const RULE: FillRule = FillRule::EvenOdd;

/// Sixteen directions around a circle, in 1/64.
const DIRECTIONS: [(i32, i32); 16] = [
    (64, 0),
    (59, 24),
    (45, 45),
    (24, 59),
    (0, 64),
    (-24, 59),
    (-45, 45),
    (-59, 24),
    (-64, 0),
    (-59, -24),
    (-45, -45),
    (-24, -59),
    (0, -64),
    (24, -59),
    (45, -45),
    (59, -24),
];
/// Rings of a polygon, at most.
const RINGS: usize = 4;
/// Edges of a polygon, at most.
const EDGES: usize = RINGS * DIRECTIONS.len();

type Ring = [SubPoint<Sub4>; DIRECTIONS.len()];

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
    fn painter(&mut self, color: Rgb565) -> impl FnMut(Span) -> Result<(), Infallible> {
        let raw = self.0.raw(color);
        move |span| self.0.fill_span(span, raw)
    }

    /// Draws pixels in colours whose channels are three attributes of 8 bits.
    fn shader(&mut self) -> impl FnMut(Point, [i16; 3]) -> Result<(), Infallible> {
        let words = self.0.words_mut();
        move |pixel, [red, green, blue]| {
            if let Some(word) = words.get_mut((pixel.y * WINDOW.right + pixel.x) as usize) {
                *word = (red as u16 & 0xF8) << 8 | (green as u16 & 0xFC) << 3 | (blue as u16 & 0xF8) >> 3;
            }
            Ok(())
        }
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 1024];
    let wanted = report::wanted(&mut words);
    let words = cortex_m::singleton!(: [u16; PIXELS] = [0; PIXELS]);
    let (Some(peripherals), Some(words)) = (Peripherals::take(), words) else {
        report::exit(false)
    };
    let Ok(band) = Band::new(Rectangle::new(Point::zero(), SCREEN), words) else {
        report::exit(false)
    };
    let mut frame = Frame(band);
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    polygons::<1>(&mut runner, &mut frame, "fill.polygon.small", 8);
    polygons::<1>(&mut runner, &mut frame, "fill.polygon.large", 100);
    polygons::<RINGS>(&mut runner, &mut frame, "fill.polygon.rings", 100);
    triangles::<Sub4>(&mut runner, &mut frame, "fill.triangle.small.sub4", small);
    triangles::<Sub4>(&mut runner, &mut frame, "fill.triangle.large.sub4", large);
    triangles::<Sub4>(&mut runner, &mut frame, "fill.triangle.sliver.sub4", sliver);
    triangles::<Sub8>(&mut runner, &mut frame, "fill.triangle.small.sub8", small);
    triangles::<Sub8>(&mut runner, &mut frame, "fill.triangle.large.sub8", large);
    triangles::<Sub8>(&mut runner, &mut frame, "fill.triangle.sliver.sub8", sliver);
    interpolations(&mut runner, &mut frame, "interpolation.small", small);
    interpolations(&mut runner, &mut frame, "interpolation.large", large);
    report::exit(true)
}

/// Counts every way to fill a polygon of so many rings about one centre, each with its own radii.
fn polygons<const RINGS: usize>(runner: &mut Runner, frame: &mut Frame<'_>, name: &str, radius: i32) {
    if !runner.wants(name) {
        return;
    }
    let inputs = colored::<[Ring; RINGS], 5>(|uniform| {
        let centre = sub_point(uniform.on_screen(SCREEN), uniform);
        core::array::from_fn(|_| ring(uniform, centre, radius << Sub4::FRACTION_BITS))
    });
    macro_rules! count {
        ($([$name:ident] [$($fill:tt)+])+) => {$(
            runner.count(name, stringify!($name), frame, &inputs, |frame, input| {
                let contours = slices(&input.shape);
                // A full table would show in the checksum.
                let _ = $($fill)+::<_, _, EDGES>(&contours, RULE, &WINDOW, frame.painter(input.color));
            });
        )+};
    }
    zrow_methods::polygon_fills!(count);
    macro_rules! count_brute_force {
        ($([$name:ident] [$($test:tt)+])+) => {$(
            runner.count(name, stringify!($name), frame, &inputs, |frame, input| {
                let contours = slices(&input.shape);
                let paint = frame.painter(input.color);
                let Ok(()) = Polygons::brute_force(&contours, RULE, &WINDOW, $($test)+, paint);
            });
        )+};
    }
    zrow_methods::point_tests!(count_brute_force);
}

fn slices<const RINGS: usize>(rings: &[Ring; RINGS]) -> [&[SubPoint<Sub4>]; RINGS] {
    rings.each_ref().map(|ring| ring.as_slice())
}

/// A jagged ring: each radius is random, from a quarter of the largest.
fn ring(uniform: &mut Uniform, centre: SubPoint<Sub4>, radius: i32) -> Ring {
    DIRECTIONS.map(|(x, y)| {
        let radius = uniform.number(radius / 4, radius);
        let (x, y) = (centre.x_units() + x * radius / 64, centre.y_units() + y * radius / 64);
        SubPoint::from_units(x, y).unwrap_or_default()
    })
}

/// A point somewhere about the centre of a pixel.
fn sub_point<S: SubPixel>(pixel: Point, uniform: &mut Uniform) -> SubPoint<S> {
    let unit = 1 << S::FRACTION_BITS;
    let (x, y) = (uniform.number(0, unit), uniform.number(0, unit));
    SubPoint::from_units(pixel.x * unit + x, pixel.y * unit + y).unwrap_or_default()
}

type Corners = [Point; 3];

/// Counts every way to fill a triangle.
fn triangles<S: SubPixel>(
    runner: &mut Runner,
    frame: &mut Frame<'_>,
    name: &str,
    corners: impl Fn(&mut Uniform) -> Corners,
) {
    if !runner.wants(name) {
        return;
    }
    let inputs: [Colored<[SubPoint<S>; 3]>; 50] =
        colored(|uniform| corners(uniform).map(|corner| sub_point(corner, uniform)));
    runner.count(name, "scanline_polygon", frame, &inputs, |frame, input| {
        let _ = Polygons::scanline::<_, _, 3>(&[&input.shape], RULE, &WINDOW, frame.painter(input.color));
    });
    macro_rules! count {
        ($([$name:ident] [$($fill:tt)+])+) => {$(
            runner.count(name, stringify!($name), frame, &inputs, |frame, input| {
                let Ok(()) = $($fill)+(input.shape, &WINDOW, frame.painter(input.color));
            });
        )+};
    }
    zrow_methods::triangles!(count);
}

/// Counts every way to interpolate three attributes over a triangle at 1/16 pixel.
fn interpolations(runner: &mut Runner, frame: &mut Frame<'_>, name: &str, corners: impl Fn(&mut Uniform) -> Corners) {
    if !runner.wants(name) {
        return;
    }
    let inputs: [Colored<[(SubPoint<Sub4>, [i16; 3]); 3]>; 50] = colored(|uniform| {
        corners(uniform).map(|corner| {
            let attributes = [(); 3].map(|()| uniform.number(0, 256) as i16);
            (sub_point(corner, uniform), attributes)
        })
    });
    macro_rules! count {
        ($([$name:ident] [$($interpolate:tt)+])+) => {$(
            runner.count(name, stringify!($name), frame, &inputs, |frame, input| {
                let Ok(()) = $($interpolate)+(&input.shape, &WINDOW, frame.shader());
            });
        )+};
    }
    zrow_methods::interpolations!(count);
}

/// Within 16 pixels.
fn small(uniform: &mut Uniform) -> Corners {
    let first = uniform.on_screen(SCREEN);
    [(); 3].map(|()| first + Point::new(uniform.number(0, 16), uniform.number(0, 16)))
}

/// Anywhere on the screen.
fn large(uniform: &mut Uniform) -> Corners {
    [(); 3].map(|()| uniform.on_screen(SCREEN))
}

/// The third corner is near the middle of the others.
fn sliver(uniform: &mut Uniform) -> Corners {
    let [one, other, _] = large(uniform);
    let aside = Point::new(uniform.number(-2, 3), uniform.number(-2, 3));
    [one, other, (one + other) / 2 + aside]
}
