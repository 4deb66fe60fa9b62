//! The ways to draw a circle that are held against each other: one entry each, for the desktop and the chips.

use core::{convert::Infallible, f64::consts::TAU};

use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{Gray8, GrayColor},
    primitives::{Circle, Ellipse, Primitive, PrimitiveStyleBuilder, Rectangle, StrokeAlignment},
};
use fixed::types::U8F8;
use heapless::Vec;
use zrow::{
    band::Band,
    draw::{DrawOn, FillRule, Polygon, PrimitiveStyle, ThinCircle},
    geometry::{Sub8, SubPoint},
    scan::Bezier,
};

/// Columns and rows of the square that circles are drawn in.
pub const CIRCLE_SIZE: usize = 112;
/// Column and row of their centre.
pub const CIRCLE_CENTER: i32 = 55;
/// The radius whose costs are reported.
pub const TIMED_RADIUS: u32 = 50;
/// Of a quarter circle as a cubic Bezier curve (Riskus 2006): at most 0.02 % of the radius off.
const QUARTER: f64 = 0.551_915_024_494;
/// Points of a circle, at most.
const POINTS: usize = 64;

type Points = Vec<SubPoint<Sub8>, POINTS>;

/// A circle as the methods take it.
#[derive(Debug, Clone)]
pub struct CircleInput {
    radius: u32,
    /// Corners or control points; none where the radius is enough.
    points: Points,
}

/// A way to draw a circle.
#[derive(Debug)]
pub struct CircleMethod {
    /// The name of this entry in the report's tables.
    pub name: &'static str,
    /// The name of this entry in what the firmware on the emulated chips reports.
    pub variant: &'static str,
    points: fn(f64) -> Points,
    draw: fn(&CircleInput, &mut [u8]),
}

const fn method(name: &'static str, variant: &'static str, draw: fn(&CircleInput, &mut [u8])) -> CircleMethod {
    through_points(name, variant, |_| Points::new(), draw)
}

const fn through_points(
    name: &'static str,
    variant: &'static str,
    points: fn(f64) -> Points,
    draw: fn(&CircleInput, &mut [u8]),
) -> CircleMethod {
    CircleMethod {
        name,
        variant,
        points,
        draw,
    }
}

/// Every way to draw an outline of one pixel.
pub const OUTLINES: &[CircleMethod] = &[
    method("ThinCircle (Bresenham)", "thin_circle", |circle, greys| {
        on_band(greys, |band| {
            ThinCircle::new(Point::new_equal(CIRCLE_CENTER), circle.radius)
                .into_styled(PrimitiveStyle::with_stroke(Gray8::WHITE, 1))
                .draw_on(band)
        });
    }),
    method("Circle", "circle", |circle, greys| {
        on_band(greys, |band| {
            round(circle.radius).into_styled(inside_stroke()).draw_on(band)
        });
    }),
    method("Ellipse", "ellipse", |circle, greys| {
        on_band(greys, |band| {
            ellipse(circle.radius).into_styled(inside_stroke()).draw_on(band)
        });
    }),
];

/// Every way to draw a disc.
pub const DISCS: &[CircleMethod] = &[
    method("Circle", "circle", |circle, greys| {
        on_band(greys, |band| round(circle.radius).into_styled(fill()).draw_on(band));
    }),
    method("Ellipse", "ellipse", |circle, greys| {
        on_band(greys, |band| ellipse(circle.radius).into_styled(fill()).draw_on(band));
    }),
    through_points("4 cubics to 1/2 px", "cubics_1_2", control_points, curves::<128, 32>),
    through_points("4 cubics to 1/8 px", "cubics_1_8", control_points, curves::<32, 64>),
    through_points("4 cubics to 1/64 px", "cubics_1_64", control_points, curves::<4, 256>),
    through_points("polygon of 16", "polygon_16", corners::<16>, |circle, greys| {
        polygon::<16>(&circle.points, greys);
    }),
    through_points("polygon of 64", "polygon_64", corners::<64>, |circle, greys| {
        polygon::<64>(&circle.points, greys);
    }),
];

impl CircleMethod {
    /// What it draws a circle of that radius from.
    pub fn input(&self, radius: u32) -> CircleInput {
        CircleInput {
            radius,
            points: (self.points)(f64::from(radius) + 0.5),
        }
    }

    /// Draws it into a square of greys.
    pub fn draw(&self, circle: &CircleInput, greys: &mut [u8]) {
        (self.draw)(circle, greys);
    }
}

fn round(radius: u32) -> Circle {
    Circle::with_center(Point::new_equal(CIRCLE_CENTER), 2 * radius + 1)
}

fn ellipse(radius: u32) -> Ellipse {
    Ellipse::with_center(Point::new_equal(CIRCLE_CENTER), Size::new_equal(2 * radius + 1))
}

fn inside_stroke() -> PrimitiveStyle<Gray8> {
    PrimitiveStyleBuilder::new()
        .stroke_color(Gray8::WHITE)
        .stroke_width(1)
        .stroke_alignment(StrokeAlignment::Inside)
        .build()
        .into()
}

fn fill() -> PrimitiveStyle<Gray8> {
    PrimitiveStyle::with_fill(Gray8::WHITE)
}

fn on_band(greys: &mut [u8], draw: impl FnOnce(&mut Band<'_, Gray8>) -> Result<(), Infallible>) {
    let area = Rectangle::new(Point::zero(), Size::new_equal(CIRCLE_SIZE as u32));
    if let Ok(mut band) = Band::new(area, greys) {
        let Ok(()) = draw(&mut band);
    }
}

/// A point by its distance from the centre.
fn point(x: f64, y: f64) -> SubPoint<Sub8> {
    let units = |pixels: f64| libm::floor((pixels + f64::from(CIRCLE_CENTER)) * 256.0 + 0.5) as i32;
    SubPoint::from_units(units(x), units(y)).unwrap_or_default()
}

/// The control points of the four cubic curves that approximate a circle, a quarter each.
fn control_points(radius: f64) -> Points {
    let quarters = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
    let points = quarters.into_iter().flat_map(|(x, y)| {
        // The next quarter begins a right angle further.
        let (next_x, next_y) = (-y, x);
        let positions = [(1.0, 0.0), (1.0, QUARTER), (QUARTER, 1.0), (0.0, 1.0)];
        positions.map(|(along, aside)| {
            point(
                radius * (along * x + aside * next_x),
                radius * (along * y + aside * next_y),
            )
        })
    });
    points.collect()
}

fn corners<const COUNT: usize>(radius: f64) -> Points {
    let corner = |index: usize| {
        let angle = TAU * index as f64 / COUNT as f64;
        point(radius * libm::cos(angle), radius * libm::sin(angle))
    };
    (0..COUNT).map(corner).collect()
}

/// The disc as four curves, flattened to that many 1/256 pixel.
fn curves<const TOLERANCE: u16, const LINES: usize>(circle: &CircleInput, greys: &mut [u8]) {
    let mut ends = Vec::<_, LINES>::new();
    for controls in circle.points.as_chunks().0 {
        if let Ok(curve) = Bezier::<4>::new(*controls) {
            ends.extend(Bezier::adaptive_forward_difference(&curve, U8F8::from_bits(TOLERANCE)));
        }
    }
    polygon::<LINES>(&ends, greys);
}

/// From a table of so many edges: one with more room takes longer to hand on.
fn polygon<const EDGES: usize>(corners: &[SubPoint<Sub8>], greys: &mut [u8]) {
    if let Ok(polygon) = Polygon::new(&[corners], FillRule::NonZero).prepare::<EDGES, EDGES>() {
        on_band(greys, |band| polygon.into_styled(fill()).draw_on(band));
    }
}
