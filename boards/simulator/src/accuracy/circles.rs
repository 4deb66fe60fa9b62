//! Circles: which pixels the ways to draw one take, against the round one.

use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{Gray8, GrayColor},
    primitives::{Circle, Ellipse, Primitive, Rectangle},
};
use fixed::types::U8F8;
use zrow::{
    band::Band,
    draw::{DrawOn, FillRule, Polygon, PrimitiveStyle, ThinCircle},
    geometry::{Sub8, SubPoint},
    scan::{Cubic, adaptive_forward_difference},
};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    errors::Errors,
    picture::Picture,
    timing::{Spread, Work, interleaved},
};

const SIZE: usize = 112;
const CENTER: i32 = 55;
/// Radii from the centre of a pixel to the centres of others; the costs are those of the last one.
const RADII: std::ops::RangeInclusive<u32> = 3..=50;
const TIMED_RADIUS: u32 = 50;
/// Of a quarter circle as a cubic Bezier curve (Riskus 2006): at most 0.02 % of the radius off.
const QUARTER: f64 = 0.551_915_024_494;

/// Thin circles and discs.
pub struct Circles;

/// Draws with a radius into a square of greys.
type Draw = fn(u32, &mut [u8]);

struct Method {
    name: &'static str,
    draw: Draw,
    count: Option<&'static str>,
}

const fn method(name: &'static str, draw: Draw, count: Option<&'static str>) -> Method {
    Method { name, draw, count }
}

const OUTLINE: &str = "outline of 1 px";
const DISC: &str = "disc";

const OUTLINES: &[Method] = &[
    method(
        "ThinCircle (Bresenham)",
        |radius, greys| {
            on_band(greys, |band| {
                ThinCircle::new(Point::new_equal(CENTER), radius)
                    .into_styled(PrimitiveStyle::with_stroke(Gray8::WHITE, 1))
                    .draw_on(band)
            });
        },
        Some("circle.thin"),
    ),
    method(
        "Circle",
        |radius, greys| on_band(greys, |band| circle(radius).into_styled(stroke()).draw_on(band)),
        Some("circle.outline"),
    ),
    method(
        "Ellipse",
        |radius, greys| on_band(greys, |band| ellipse(radius).into_styled(stroke()).draw_on(band)),
        None,
    ),
];

const DISCS: &[Method] = &[
    method(
        "Circle",
        |radius, greys| on_band(greys, |band| circle(radius).into_styled(fill()).draw_on(band)),
        Some("circle.filled"),
    ),
    method(
        "Ellipse",
        |radius, greys| on_band(greys, |band| ellipse(radius).into_styled(fill()).draw_on(band)),
        None,
    ),
    method("4 cubics to 1/2 px", curves::<128>, None),
    method("4 cubics to 1/8 px", curves::<32>, None),
    method("4 cubics to 1/64 px", curves::<4>, None),
    method("polygon of 16", corners::<16>, None),
    method("polygon of 64", corners::<64>, None),
];

impl Axis for Circles {
    fn name(&self) -> &'static str {
        "circles"
    }

    fn counts(&self) -> Vec<String> {
        let methods = OUTLINES.iter().chain(DISCS);
        methods.filter_map(|method| method.count.map(str::to_owned)).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let groups = [
            (OUTLINE, OUTLINES, outline_error as fn(u32, &[u8]) -> Errors),
            (DISC, DISCS, disc_error),
        ];
        let mut entries = Vec::new();
        for (group, methods, error) in groups {
            let radius = [TIMED_RADIUS];
            let works = methods.iter().map(|method| {
                let mut greys = vec![0; SIZE * SIZE];
                Work::on_each(&radius, move |radius| (method.draw)(*radius, &mut greys))
            });
            let times = interleaved(works.collect(), context.plan);
            let group = methods.iter().zip(times).map(|(method, time)| {
                let instructions = method.count.and_then(|count| context.counted.get(count));
                method.entry(group, error, time, instructions)
            });
            entries.extend(group);
        }
        Ok(Chapter {
            name: self.name(),
            title: "Circles: the methods",
            about: vec![
                format!(
                    "Circles about the centre of a pixel with all radii of {} to {} pixels. The displacement of an outline's \
                     pixel is its distance from the round line; even the nearest pixels have one. That of a disc is the \
                     distance of each pixel that is wrongly in or out from the round line of radius r + 1/2, over as many \
                     pixels as that line is long.",
                    RADII.start(),
                    RADII.end()
                ),
                format!(
                    "Cost: the circle of radius {TIMED_RADIUS} into a square of bytes, from the centre and radius or from \
                     the corners on. The emulated chip draws such circles in RGB565 on 240 x 320 pixels, partly off screen."
                ),
            ],
            operation: "one circle",
            memory: None,
            figures: vec![
                "rms displacement in 1/256 px",
                "largest displacement in 1/256 px",
                "pixels",
            ],
            entries,
        })
    }
}

impl Method {
    fn entry(&self, group: &str, error: fn(u32, &[u8]) -> Errors, time: Spread, instructions: Option<f64>) -> Entry {
        let mut errors = Errors::default();
        for radius in RADII {
            errors.add_all(&error(radius, &self.greys(radius)));
        }
        Entry {
            group: group.to_owned(),
            method: self.name.to_owned(),
            figures: vec![errors.rms(), errors.max(), errors.count() as f64],
            memory_bytes: 0,
            time: Some(time),
            instructions,
            picture: Some(self.picture(group)),
        }
    }

    fn greys(&self, radius: u32) -> Vec<u8> {
        let mut greys = vec![0; SIZE * SIZE];
        (self.draw)(radius, &mut greys);
        greys
    }

    /// A small one, because pixels have to be seen; what is right is the disc, or Bresenham's circle.
    fn picture(&self, group: &str) -> Picture {
        let radius = 12;
        let place = |(x, y): (i32, i32)| (x + 16, y + 16);
        let drawn: Vec<_> = offsets(&self.greys(radius))
            .filter(|(_, is_drawn)| *is_drawn)
            .map(|(offset, _)| place(offset))
            .collect();
        let right: Vec<_> = if group == DISC {
            let all = offsets(&[0; SIZE * SIZE]).map(|(offset, _)| offset).collect::<Vec<_>>();
            let inside = all
                .into_iter()
                .filter(|offset| distance(*offset) < f64::from(radius) + 0.5);
            inside.map(place).collect()
        } else {
            let greys = OUTLINES[0].greys(radius);
            offsets(&greys)
                .filter(|(_, is_drawn)| *is_drawn)
                .map(|(offset, _)| place(offset))
                .collect()
        };
        let caption = format!(
            "radius {radius}: red drawn, blue {}, grey both",
            if group == DISC { "right" } else { "Bresenham's" }
        );
        Picture::of_pixels(&drawn, &right, (33, 33), caption)
    }
}

/// Every pixel as seen from the centre, and whether it is drawn.
fn offsets(greys: &[u8]) -> impl Iterator<Item = ((i32, i32), bool)> {
    greys.iter().enumerate().map(|(index, grey)| {
        let (x, y) = ((index % SIZE) as i32, (index / SIZE) as i32);
        ((x - CENTER, y - CENTER), *grey != 0)
    })
}

fn distance((x, y): (i32, i32)) -> f64 {
    f64::from(x).hypot(f64::from(y))
}

fn outline_error(radius: u32, greys: &[u8]) -> Errors {
    let mut errors = Errors::default();
    for (offset, _) in offsets(greys).filter(|(_, is_drawn)| *is_drawn) {
        errors.add((distance(offset) - f64::from(radius)) * 256.0);
    }
    errors
}

fn disc_error(radius: u32, greys: &[u8]) -> Errors {
    let boundary = f64::from(radius) + 0.5;
    let mut errors = Errors::default();
    let mut wrong = 0;
    for (offset, is_drawn) in offsets(greys) {
        if is_drawn != (distance(offset) < boundary) {
            errors.add((distance(offset) - boundary) * 256.0);
            wrong += 1;
        }
    }
    let length = (std::f64::consts::TAU * boundary) as u64;
    for _ in wrong..length {
        errors.add(0.0);
    }
    errors
}

fn circle(radius: u32) -> Circle {
    Circle::with_center(Point::new_equal(CENTER), 2 * radius + 1)
}

fn ellipse(radius: u32) -> Ellipse {
    Ellipse::with_center(Point::new_equal(CENTER), Size::new_equal(2 * radius + 1))
}

fn stroke() -> PrimitiveStyle<Gray8> {
    zrow::draw::PrimitiveStyleBuilder::new()
        .stroke_color(Gray8::WHITE)
        .stroke_width(1)
        .stroke_alignment(embedded_graphics::primitives::StrokeAlignment::Inside)
        .build()
}

fn fill() -> PrimitiveStyle<Gray8> {
    PrimitiveStyle::with_fill(Gray8::WHITE)
}

fn on_band(greys: &mut [u8], draw: impl FnOnce(&mut Band<'_, Gray8>) -> Result<(), core::convert::Infallible>) {
    let area = Rectangle::new(Point::zero(), Size::new_equal(SIZE as u32));
    if let Ok(mut band) = Band::new(area, greys) {
        let Ok(()) = draw(&mut band);
    }
}

fn point((x, y): (f64, f64)) -> SubPoint<Sub8> {
    let units = |pixels: f64| ((pixels + f64::from(CENTER)) * 256.0).round() as i32;
    SubPoint::from_units(units(x), units(y)).unwrap_or_default()
}

/// The disc of radius r + 1/2 as four curves, flattened to that many 1/256 pixel.
fn curves<const TOLERANCE: u16>(radius: u32, greys: &mut [u8]) {
    let size = f64::from(radius) + 0.5;
    let mut ends = Vec::new();
    for (x, y) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)] {
        // The next quarter begins a right angle further.
        let (next_x, next_y) = (-y, x);
        let between =
            |along: f64, aside: f64| point((size * (along * x + aside * next_x), size * (along * y + aside * next_y)));
        let controls = [
            between(1.0, 0.0),
            between(1.0, QUARTER),
            between(QUARTER, 1.0),
            between(0.0, 1.0),
        ];
        if let Ok(curve) = Cubic::new(controls) {
            ends.extend(adaptive_forward_difference::flatten(&curve, U8F8::from_bits(TOLERANCE)));
        }
    }
    polygon(&ends, greys);
}

fn corners<const COUNT: usize>(radius: u32, greys: &mut [u8]) {
    let size = f64::from(radius) + 0.5;
    let corner = |index: usize| {
        let angle = std::f64::consts::TAU * index as f64 / COUNT as f64;
        point((size * angle.cos(), size * angle.sin()))
    };
    let corners: Vec<_> = (0..COUNT).map(corner).collect();
    polygon(&corners, greys);
}

fn polygon(corners: &[SubPoint<Sub8>], greys: &mut [u8]) {
    if let Ok(polygon) = Polygon::new(&[corners], FillRule::NonZero).prepare::<512, 32>() {
        on_band(greys, |band| polygon.into_styled(fill()).draw_on(band));
    }
}
