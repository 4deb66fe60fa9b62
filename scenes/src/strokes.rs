//! Strokes: caps and joins, the miter limit, and dashes round corners.

use embedded_graphics::{
    mono_font::ascii::FONT_5X8,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Polyline, Rectangle, Triangle},
    text::Alignment,
};
use fixed::types::{U8F8, U16F16};
use zrow::{
    band::{Band, Order},
    draw::{LineCap, LineJoin, PrimitiveStyle, StrokeStyle},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape, title},
};

const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
/// The path in the middle of a stroke.
const MIDDLE: Rgb565 = rgb(20, 24, 32);
const COLORS: [Rgb565; 4] = [
    rgb(255, 202, 40),
    rgb(236, 64, 122),
    rgb(38, 198, 218),
    rgb(156, 204, 101),
];

const CAPS: [(&str, LineCap); 4] = [
    ("butt", LineCap::Butt),
    ("pixel", LineCap::WholePixel),
    ("square", LineCap::Square),
    ("round", LineCap::Round),
];
const JOINS: [(&str, LineJoin); 3] = [
    ("miter", LineJoin::MITER),
    ("bevel", LineJoin::Bevel),
    ("round", LineJoin::Round),
];
/// Where the matrix begins, and how far its cells are apart.
const MATRIX: Point = Point::new(44, 40);
const CELL: Size = Size::new(42, 31);
const HOOK: [Point; 4] = [
    Point::new(0, 18),
    Point::new(9, 2),
    Point::new(17, 18),
    Point::new(29, 12),
];

const LIMITS: [(&str, &str, U8F8); 4] = [
    ("limit 1", "none", U8F8::lit("1")),
    ("limit 2", "blunt", U8F8::lit("2")),
    ("limit 4", "default", U8F8::lit("4")),
    ("limit 8", "sharp", U8F8::lit("8")),
];
/// Where three corners stand, and how wide and high they are: ratios 1.4, 3.2 and 6.1.
const CORNERS: [(i32, i32, i32); 3] = [(264, 9, 9), (286, 4, 12), (304, 2, 12)];

const DASHES: [U16F16; 2] = [U16F16::lit("9"), U16F16::lit("6")];
const DOTS: [U16F16; 2] = [U16F16::lit("0"), U16F16::lit("8")];
const DASH_DOT: [U16F16; 4] = [U16F16::lit("10"), U16F16::lit("8"), U16F16::lit("0"), U16F16::lit("8")];
const FINE: [U16F16; 1] = [U16F16::lit("2.5")];

/// The scene; nothing outlives a row.
#[derive(Debug, Default)]
pub struct Strokes;

impl Scene for Strokes {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "strokes";
    const TITLE: &'static str = "strokes: caps, joins, miter limit, dashes";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        Ok(self)
    }
}

impl Prepared for Strokes {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        title::<Self, O>(band);
        draw_matrix(band);
        draw_limits(band);
        draw_dashes(band);
    }
}

fn small<O: Order>(band: &mut Band<'_, Rgb565, O>, text: &str, at: Point, alignment: Alignment) {
    label(band, text, at, alignment, &FONT_5X8, LABEL_COLOR);
}

/// Every join with every cap.
fn draw_matrix<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let across = |column: usize| MATRIX.x + column as i32 * CELL.width as i32;
    let down = |row: usize| MATRIX.y + row as i32 * CELL.height as i32;
    for (column, (name, _)) in CAPS.into_iter().enumerate() {
        small(band, name, Point::new(across(column) + 14, 19), Alignment::Center);
    }
    for (row, (name, join)) in JOINS.into_iter().enumerate() {
        small(band, name, Point::new(6, down(row) + 8), Alignment::Left);
        for (column, ((_, cap), color)) in CAPS.into_iter().zip(COLORS).enumerate() {
            let hook = HOOK.map(|point| point + Point::new(across(column), down(row)));
            let hook = Polyline::new(&hook);
            shape(band, &hook.into_styled(StrokeStyle::new(color, 7).cap(cap).join(join)));
            shape(band, &hook.into_styled(PrimitiveStyle::with_stroke(MIDDLE, 1)));
        }
    }
}

/// Draws a row of corners for each miter limit, from the smallest limit to the largest.
fn draw_limits<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    for (row, ((name, what, limit), color)) in LIMITS.into_iter().zip(COLORS).enumerate() {
        let top = 24 + 28 * row as i32;
        small(band, name, Point::new(214, top + 8), Alignment::Left);
        small(band, what, Point::new(214, top + 17), Alignment::Left);
        let style = StrokeStyle::new(color, 4)
            .cap(LineCap::Butt)
            .join(LineJoin::Miter { limit });
        for (x, aside, down) in CORNERS {
            let foot = top + 26;
            let corner = [(x - aside, foot), (x, foot - down), (x + aside, foot)];
            let corner = corner.map(|(x, y)| Point::new(x, y));
            shape(band, &Polyline::new(&corner).into_styled(style));
        }
    }
}

/// Patterns along open and closed paths.
fn draw_dashes<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let names = [
        ("dashes 9 6", 46),
        ("0 8, round", 124),
        ("10 8 0 8, round", 202),
        ("2.5, 1 px", 280),
    ];
    for (name, x) in names {
        small(band, name, Point::new(x, 228), Alignment::Center);
    }
    let [amber, pink, cyan, green] = COLORS;
    let spiral = [
        (14, 216),
        (14, 146),
        (78, 146),
        (78, 208),
        (30, 208),
        (30, 162),
        (62, 162),
        (62, 192),
    ];
    let spiral = spiral.map(|(x, y)| Point::new(x, y));
    let style = StrokeStyle::new(amber, 5).cap(LineCap::Butt).dashes(&DASHES);
    shape(band, &Polyline::new(&spiral).into_styled(style));
    let triangle = Triangle::new(Point::new(124, 144), Point::new(156, 214), Point::new(94, 200));
    let style = StrokeStyle::new(pink, 4).cap(LineCap::Round).dashes(&DOTS);
    shape(band, &triangle.into_styled(style));
    let wave: [Point; 9] = core::array::from_fn(|index| {
        let aside = [0, 12, 16, 12, 0, -12, -16, -12, 0].get(index).copied().unwrap_or(0);
        Point::new(202 + aside, 146 + 9 * index as i32)
    });
    let style = StrokeStyle::new(cyan, 4)
        .cap(LineCap::Round)
        .join(LineJoin::Round)
        .dashes(&DASH_DOT);
    shape(band, &Polyline::new(&wave).into_styled(style));
    let selected = Rectangle::new(Point::new(250, 146), Size::new(60, 70));
    let style = StrokeStyle::new(green, 1).cap(LineCap::Butt).dashes(&FINE);
    shape(band, &selected.into_styled(style));
    let disc = Circle::with_center(selected.center(), 40);
    shape(band, &disc.into_styled(PrimitiveStyle::with_fill(rgb(38, 70, 120))));
}
