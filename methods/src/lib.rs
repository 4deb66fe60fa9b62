//! The shape classes on which antialiasing is measured: 48 x 48 pixels, 25 random shapes a class, fixed seeds.
//!
//! Corners are in 1/256 pixel with pixel centres at multiples of 256, as in `zrow`: the square of pixels reaches from -128
//! to 47 * 256 + 128. The desktop and the chips get the same integers. The same shapes can be had on coarser or finer grids.
#![no_std]
#![forbid(unsafe_code)]

#[macro_use]
pub mod registry;

mod circles;
mod corners;
mod curves;
mod figures;
mod hidden_surfaces;
mod lines;
mod look;
mod methods;
mod precision;
mod random;
pub mod space;
mod trigonometry;

use core::f64::consts::TAU;

use heapless::Vec;

pub use circles::{CIRCLE_CENTER, CIRCLE_SIZE, CircleInput, CircleMethod, DISCS, OUTLINES, TIMED_RADIUS};
pub use corners::{PRECISIONS, Precision, Rounded};
pub use curves::{CURVE_SCREEN, CURVE_SIBLINGS, CURVES, CurveInput, CurveSibling, TOLERANCES, Tolerance, curves};
pub use figures::{FIGURE_SIZES, Figure};
pub use hidden_surfaces::{HIDDEN_SURFACES, HiddenSurfaces};
pub use lines::{LINE_GROUPS, LINE_SIBLINGS, Line, LineGroup, LineSibling, SCREEN, UPRIGHT_SCREEN, cut_lines};
pub use look::LookOf;
pub use methods::{Input, METHODS, Method};
pub use precision::{Fraction, clip_window};
pub use random::Random;
pub use trigonometry::{
    TRIGONOMETRY, TRIGONOMETRY_COUNT, Trigonometry, cordic, interpolated_entry, libm_single, micromath, nearest_entry,
    polynomial,
};

/// Columns and rows of the square that the shapes are in.
pub const SIZE: usize = 48;
/// Units of a pixel, where no others are asked for.
pub const UNITS: i32 = 256;
/// Shapes of a class.
pub const SHAPES: u32 = 25;
/// Corners of a circle: it lies within 1/128 pixel of the round one.
pub const CIRCLE_CORNERS: usize = 128;

/// Column and row, in units of the shape.
pub type Corner = (i32, i32);
/// A closed line through its corners.
pub type Contour = Vec<Corner, CIRCLE_CORNERS>;

/// Which points are inside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    /// Points with an odd number of contours around them.
    EvenOdd,
    /// Points about which the contours wind a number of times that is not 0.
    NonZero,
}

/// A shape with sub-pixel corners.
#[derive(Debug, Clone)]
pub struct Shape {
    /// Its contours, each closed by itself.
    pub contours: Vec<Contour, 2>,
    /// Its fill rule.
    pub rule: Rule,
    /// Units of a pixel.
    pub units: i32,
}

/// A kind of shape that tells methods apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// Three random corners.
    Triangle,
    /// A line of one pixel, as a thin rectangle.
    Line,
    /// A quadrangle whose long sides rise by less than 1 in 16.
    NearHorizontal,
    /// A quadrangle whose long sides lean by less than 1 in 16 from upright.
    NearVertical,
    /// A line of 0.15 pixel.
    Hairline,
    /// A circle, as a polygon.
    Circle,
    /// Two circles about the same centre.
    Ring,
    /// Seven corners, every third of them joined: it crosses itself.
    Star,
}

/// The name of a class behind a prefix.
macro_rules! names_of_classes {
    ($class:expr, $prefix:literal) => {
        match $class {
            Self::Triangle => concat!($prefix, "triangle"),
            Self::Line => concat!($prefix, "line"),
            Self::NearHorizontal => concat!($prefix, "near_horizontal"),
            Self::NearVertical => concat!($prefix, "near_vertical"),
            Self::Hairline => concat!($prefix, "hairline"),
            Self::Circle => concat!($prefix, "circle"),
            Self::Ring => concat!($prefix, "ring"),
            Self::Star => concat!($prefix, "star"),
        }
    };
}

impl Class {
    /// Every class.
    pub const ALL: [Self; 8] = [
        Self::Triangle,
        Self::Line,
        Self::NearHorizontal,
        Self::NearVertical,
        Self::Hairline,
        Self::Circle,
        Self::Ring,
        Self::Star,
    ];

    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        names_of_classes!(self, "")
    }

    /// What the chips report the counts of methods as.
    pub const fn count_name(self) -> &'static str {
        names_of_classes!(self, "class.")
    }

    /// What the chips report the counts of precisions of corners as.
    pub const fn corners_count_name(self) -> &'static str {
        names_of_classes!(self, "corners.")
    }

    /// What its shapes are.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Triangle => "triangle of random corners",
            Self::Line => "line of 1 px as a thin rectangle",
            Self::NearHorizontal => "quadrangle with nearly horizontal sides",
            Self::NearVertical => "quadrangle with nearly vertical sides",
            Self::Hairline => "hairline of 0.15 px",
            Self::Circle => "circle",
            Self::Ring => "ring",
            Self::Star => "{7/3} star, nonzero",
        }
    }

    /// One of its shapes; any number is one, and `0..SHAPES` are those that are measured.
    pub fn shape(self, number: u32) -> Shape {
        self.shape_in(number, UNITS)
    }

    /// One of its shapes with corners rounded to units of which `units` are a pixel.
    pub fn shape_in(self, number: u32, units: i32) -> Shape {
        let mut random = Random::new(0x7A72_6F77 ^ ((self as u64) << 40) ^ (u64::from(number) << 8));
        let mut shape = Shape {
            contours: Vec::new(),
            rule: Rule::NonZero,
            units,
        };
        match self {
            Self::Triangle => shape.add(triangle(&mut random)),
            Self::Line => shape.add(stroke(&mut random, 1.0)),
            Self::NearHorizontal => shape.add(flat_quadrangle(&mut random)),
            Self::NearVertical => shape.add(flat_quadrangle(&mut random).map(|(x, y)| (y, x))),
            Self::Hairline => shape.add(stroke(&mut random, 0.15)),
            Self::Circle => {
                let radius = random.between(3.0, 22.0);
                shape.add(round(centre(&mut random, radius), radius, 1.0));
            }
            Self::Ring => ring(&mut shape, &mut random),
            Self::Star => shape.add(star(&mut random)),
        }
        shape
    }
}

impl Shape {
    fn add(&mut self, points: impl IntoIterator<Item = Point>) {
        let snap = |pixels: f64| libm::floor(pixels * f64::from(self.units) + 0.5) as i32;
        let contour = points.into_iter().map(|(x, y)| (snap(x), snap(y))).collect();
        // No shape has more than two.
        let _ = self.contours.push(contour);
    }
}

/// In pixels.
type Point = (f64, f64);

/// Coordinates of points, so that every shape stays more than half a pixel inside the square.
const LOW: f64 = 1.0;
const HIGH: f64 = SIZE as f64 - 2.0;

fn point(random: &mut Random) -> Point {
    (random.between(LOW, HIGH), random.between(LOW, HIGH))
}

/// Not smaller than 40 square pixels.
fn triangle(random: &mut Random) -> [Point; 3] {
    loop {
        let [a, b, c] = core::array::from_fn(|_| point(random));
        let doubled_area = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
        if libm::fabs(doubled_area) >= 80.0 {
            return [a, b, c];
        }
    }
}

/// A rectangle of that width around a line of at least 12 pixels.
fn stroke(random: &mut Random, width: f64) -> [Point; 4] {
    loop {
        let (from, to) = (point(random), point(random));
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = libm::sqrt(dx * dx + dy * dy);
        if length >= 12.0 {
            let aside = (-dy / length * width / 2.0, dx / length * width / 2.0);
            let moved = |point: Point, by: f64| (point.0 + aside.0 * by, point.1 + aside.1 * by);
            return [moved(from, 1.0), moved(to, 1.0), moved(to, -1.0), moved(from, -1.0)];
        }
    }
}

fn flat_quadrangle(random: &mut Random) -> [Point; 4] {
    let (left, right) = (random.between(LOW, 6.0), random.between(40.0, HIGH));
    let top = random.between(4.0, 24.0);
    let bottom = top + random.between(0.7, 18.0);
    // 34 columns at least, so a rise of 2 is less than 1 in 16.
    let mut end = |row: f64| row + random.between(-2.0, 2.0);
    let (one, other) = (end(top), end(bottom));
    // Not crossed.
    let (top_right, bottom_right) = if one < other { (one, other) } else { (other, one) };
    [(left, top), (right, top_right), (right, bottom_right), (left, bottom)]
}

/// Corners on a circle, `step` further each.
fn around(center: Point, radius: f64, corners: usize, start: f64, step: f64) -> impl Iterator<Item = Point> {
    (0..corners).map(move |corner| {
        let angle = start + corner as f64 * step;
        (
            center.0 + radius * libm::cos(angle),
            center.1 + radius * libm::sin(angle),
        )
    })
}

/// A circle as a polygon.
fn round(center: Point, radius: f64, direction: f64) -> impl Iterator<Item = Point> {
    let step = direction * TAU / CIRCLE_CORNERS as f64;
    around(center, radius, CIRCLE_CORNERS, 0.0, step)
}

/// A centre around which a circle of that radius stays in the square.
fn centre(random: &mut Random, radius: f64) -> Point {
    let mut coordinate = || random.between(LOW + radius, HIGH - radius);
    (coordinate(), coordinate())
}

/// Both rules make it the same: its contours run in opposite directions.
fn ring(shape: &mut Shape, random: &mut Random) {
    let radius = random.between(6.0, 22.0);
    let inner = radius - random.between(0.7, 5.0);
    let center = centre(random, radius);
    shape.add(round(center, radius, 1.0));
    shape.add(round(center, inner, -1.0));
    shape.rule = Rule::EvenOdd;
}

fn star(random: &mut Random) -> impl Iterator<Item = Point> {
    let radius = random.between(8.0, 22.0);
    let center = centre(random, radius);
    let start = random.between(0.0, TAU);
    around(center, radius, 7, start, TAU * 3.0 / 7.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shape_lies_in_the_square() {
        for class in Class::ALL {
            for number in 0..SHAPES {
                let shape = class.shape(number);
                assert!(shape.contours.iter().all(|contour| contour.len() >= 3));
                for &(x, y) in shape.contours.iter().flatten() {
                    let inside = 0..=(SIZE as i32 - 1) * UNITS;
                    assert!(
                        inside.contains(&x) && inside.contains(&y),
                        "{class:?} {number}: {x} {y}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_shapes_are_always_the_same() {
        let sum = Class::ALL
            .iter()
            .flat_map(|class| (0..SHAPES).map(|number| class.shape(number)))
            .flat_map(|shape| shape.contours)
            .flatten()
            .fold(0u32, |sum, (x, y)| {
                sum.rotate_left(5) ^ x as u32 ^ (y as u32).rotate_left(16)
            });
        assert_eq!(sum, 437_765_800);
    }
}
