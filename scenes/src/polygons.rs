//! Polygons that cross themselves, have holes, or are stroked.

use embedded_graphics::{
    mono_font::ascii::FONT_5X8,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{PrimitiveStyleBuilder, Rectangle},
    text::Alignment,
};
use zrow::{
    band::{Band, Order},
    draw::{FillRule, Polygon, PreparedShape, PrimitiveStyle, StrokeAlignment},
    geometry::TooSmall,
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape, title},
};

/// A polygon, its edges set up: none here has more than 16, and 8 in one row.
type Ready = PreparedShape<Polygon<'static, Point>, 16, 8>;
type Contours = [&'static [Point]];

const COLORS: [Rgb565; 5] = [
    rgb(255, 202, 40),
    rgb(236, 64, 122),
    rgb(38, 198, 218),
    rgb(156, 204, 101),
    rgb(171, 130, 235),
];
const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
const OUTLINE: Rgb565 = rgb(255, 255, 255);

const COLUMNS: [(&str, i32); 5] = [
    ("star 5", 78),
    ("star 7", 132),
    ("overlap", 186),
    ("same way", 240),
    ("other way", 293),
];
const ROWS: [(&str, i32, FillRule); 2] = [("even-odd", 64, FillRule::EvenOdd), ("nonzero", 124, FillRule::NonZero)];
const STROKES: [(&str, StrokeAlignment, u32); 5] = [
    ("inside", StrokeAlignment::Inside, 4),
    ("center", StrokeAlignment::Center, 4),
    ("outside", StrokeAlignment::Outside, 4),
    ("1 px", StrokeAlignment::Center, 1),
    ("3 px", StrokeAlignment::Center, 3),
];
const STROKES_Y: i32 = 194;

const STAR_5: [(i32, i32); 5] = [(0, -24), (14, 19), (-23, -7), (23, -7), (-14, 19)];
const STAR_7: [(i32, i32); 7] = [(0, -24), (10, 22), (-19, -15), (23, 5), (-23, 5), (19, -15), (-10, 22)];
const UPPER_SQUARE: [(i32, i32); 4] = [(-22, -22), (10, -22), (10, 10), (-22, 10)];
const LOWER_SQUARE: [(i32, i32); 4] = [(-10, -10), (22, -10), (22, 22), (-10, 22)];
const SQUARE: [(i32, i32); 4] = [(-22, -22), (22, -22), (22, 22), (-22, 22)];
const DIAMOND: [(i32, i32); 4] = [(0, -15), (15, 0), (0, 15), (-15, 0)];
const REVERSED_DIAMOND: [(i32, i32); 4] = [(0, -15), (-15, 0), (0, 15), (15, 0)];
const ARROW: [(i32, i32); 7] = [(-20, -7), (2, -7), (2, -18), (20, 0), (2, 18), (2, 7), (-20, 7)];
const BOLT: [(i32, i32); 6] = [(6, -20), (-14, 4), (-2, 4), (-6, 20), (14, -4), (2, -4)];

/// Points about another one.
const fn moved<const N: usize>(points: [(i32, i32); N], x: i32, y: i32) -> [Point; N] {
    let mut moved = [Point::zero(); N];
    let mut index = 0;
    while index < N {
        moved[index] = Point::new(x + points[index].0, y + points[index].1);
        index += 1;
    }
    moved
}

/// The five polygons of a row of the table.
macro_rules! row {
    ($y:expr) => {
        [
            &[&moved(STAR_5, COLUMNS[0].1, $y)],
            &[&moved(STAR_7, COLUMNS[1].1, $y)],
            &[
                &moved(UPPER_SQUARE, COLUMNS[2].1, $y),
                &moved(LOWER_SQUARE, COLUMNS[2].1, $y),
            ],
            &[&moved(SQUARE, COLUMNS[3].1, $y), &moved(DIAMOND, COLUMNS[3].1, $y)],
            &[
                &moved(SQUARE, COLUMNS[4].1, $y),
                &moved(REVERSED_DIAMOND, COLUMNS[4].1, $y),
            ],
        ]
    };
}

/// The polygons that are filled: the same five for each of the two fill rules.
static FILLED: [[&Contours; 5]; 2] = [row!(ROWS[0].1), row!(ROWS[1].1)];
static STROKED: [&Contours; 5] = [
    &[&moved(ARROW, COLUMNS[0].1, STROKES_Y)],
    &[&moved(ARROW, COLUMNS[1].1, STROKES_Y)],
    &[&moved(ARROW, COLUMNS[2].1, STROKES_Y)],
    &[&moved(BOLT, COLUMNS[3].1, STROKES_Y)],
    &[
        &moved(SQUARE, COLUMNS[4].1, STROKES_Y),
        &moved(DIAMOND, COLUMNS[4].1, STROKES_Y),
    ],
];

/// The scene: what it keeps is in the frame.
#[derive(Debug, Default)]
pub struct Polygons;

/// All polygons, their edges set up.
#[derive(Debug)]
pub struct Frame {
    filled: [[Ready; 5]; 2],
    stroked: [Ready; 5],
}

impl Scene for Polygons {
    type Color = Rgb565;
    type Prepared<'s> = Frame;
    const NAME: &'static str = "polygons";
    const TITLE: &'static str = "polygons: stars and holes, two rules";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<Frame, PrepareError> {
        let [even_odd, nonzero] = FILLED;
        Ok(Frame {
            filled: [prepare(even_odd, ROWS[0].2)?, prepare(nonzero, ROWS[1].2)?],
            stroked: prepare(STROKED, FillRule::EvenOdd)?,
        })
    }
}

fn prepare(row: [&'static Contours; 5], rule: FillRule) -> Result<[Ready; 5], TooSmall> {
    let ready = |contours| Polygon::new(contours, rule).prepare();
    let [a, b, c, d, e] = row.map(ready);
    Ok([a?, b?, c?, d?, e?])
}

impl Prepared for Frame {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        title::<Polygons, O>(band);
        for (name, x) in COLUMNS {
            label(band, name, Point::new(x, 22), Alignment::Center, &FONT_5X8, LABEL_COLOR);
        }
        for ((name, y, _), polygons) in ROWS.into_iter().zip(&self.filled) {
            label(
                band,
                name,
                Point::new(6, y - 4),
                Alignment::Left,
                &FONT_5X8,
                LABEL_COLOR,
            );
            for (polygon, color) in polygons.iter().zip(COLORS) {
                shape(band, &polygon.into_styled(PrimitiveStyle::with_fill(color)));
            }
        }
        draw_stroked(band, &self.stroked);
    }
}

fn draw_stroked<O: Order>(band: &mut Band<'_, Rgb565, O>, polygons: &[Ready; 5]) {
    label(
        band,
        "strokes",
        Point::new(6, STROKES_Y - 4),
        Alignment::Left,
        &FONT_5X8,
        LABEL_COLOR,
    );
    let columns = COLUMNS.map(|(_, x)| x).into_iter();
    let parts = columns.zip(polygons).zip(STROKES).zip(COLORS);
    for (((x, polygon), (name, alignment, width)), color) in parts {
        let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
            .fill_color(color)
            .stroke_color(OUTLINE)
            .stroke_width(width)
            .stroke_alignment(alignment)
            .build()
            .into();
        shape(band, &polygon.into_styled(style));
        let under = Point::new(x, STROKES_Y + 32);
        label(band, name, under, Alignment::Center, &FONT_5X8, LABEL_COLOR);
    }
}
