//! The line siblings magnified side by side, with the pixels marked in which they differ from Bresenham's; and points.

use embedded_graphics::{
    mono_font::ascii::{FONT_5X8, FONT_6X10},
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Rectangle},
    text::Alignment,
};
use zrow::{
    band::{Band, Generic, Order},
    draw::{Points, PrimitiveStyle},
    geometry::Window,
    scan::Lines,
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape},
};

const TITLE_COLOR: Rgb565 = rgb(255, 255, 255);
const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
const PAPER: Rgb565 = rgb(32, 38, 50);
const SAME: Rgb565 = rgb(79, 195, 247);
const OTHER_RUN: Rgb565 = rgb(30, 110, 165);
const ADDED: Rgb565 = rgb(255, 82, 82);
const MISSING: Rgb565 = rgb(255, 202, 40);
const EXACT: Rgb565 = rgb(255, 255, 255);

/// What each sibling shows of the lines.
const WINDOW: Window = Window {
    left: 0,
    top: 0,
    right: 18,
    bottom: 11,
};
/// A cell is one pixel.
const CELL: u32 = 5;
/// Size of a panel.
const PANEL: Size = Size::new(18 * CELL, 11 * CELL);
const COLUMNS: [i32; 3] = [14, 115, 216];
const ROWS: [i32; 3] = [30, 106, 182];

/// A line with ties, the end of a line that comes from far off, and a steep one.
const LINES: [(Point, Point); 3] = [
    (Point::new(1, 0), Point::new(13, 5)),
    (Point::new(-25_001, -7_951), Point::new(17, 9)),
    (Point::new(15, 0), Point::new(17, 6)),
];

/// Points of growing radius, in the panels of the last row.
const DISCS: [(&[Point], u32); 4] = [
    (&[Point::new(22, 196), Point::new(22, 210), Point::new(22, 224)], 0),
    (&[Point::new(30, 196), Point::new(30, 210), Point::new(30, 224)], 1),
    (&[Point::new(44, 197), Point::new(44, 221)], 5),
    (&[Point::new(76, 209)], 20),
];
const SQUARES: [(&[Point], u32); 4] = [
    (&[Point::new(123, 196), Point::new(123, 210), Point::new(123, 224)], 0),
    (&[Point::new(131, 196), Point::new(131, 210), Point::new(131, 224)], 1),
    (&[Point::new(145, 197), Point::new(145, 221)], 5),
    (&[Point::new(177, 209)], 20),
];
const LEGEND: [(Rgb565, &str); 4] = [
    (SAME, "Bresenham's"),
    (OTHER_RUN, "every other run"),
    (ADDED, "added"),
    (MISSING, "missing"),
];

/// The scene; nothing outlives a row.
#[derive(Debug, Default)]
pub struct LineSiblings;

impl Scene for LineSiblings {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "line-siblings";
    const TITLE: &'static str = "lines: where the siblings differ";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        Ok(self)
    }
}

impl Prepared for LineSiblings {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        label(
            band,
            <LineSiblings as Scene>::TITLE,
            Point::new(160, 4),
            Alignment::Center,
            &FONT_6X10,
            TITLE_COLOR,
        );
        let ([left, center, right], [top, middle, bottom]) = (COLUMNS, ROWS);
        runs(band, Point::new(left, top));
        sibling(band, "midpoint", Point::new(center, top), Lines::midpoint);
        sibling(band, "supercover", Point::new(right, top), Lines::supercover);
        sibling(
            band,
            "slope-intercept",
            Point::new(left, middle),
            Lines::slope_intercept,
        );
        sibling(band, "DDA, float", Point::new(center, middle), Lines::dda);
        sibling(band, "DDA, 16.16", Point::new(right, middle), Lines::dda_fixed);
        paper(band, "points: discs", Point::new(left, bottom));
        paper(band, "points: squares", Point::new(center, bottom));
        let style = PrimitiveStyle::with_fill(SAME);
        for (centers, radius) in DISCS {
            shape(band, &Points::discs(centers, radius).into_styled(style));
        }
        for (centers, radius) in SQUARES {
            shape(band, &Points::squares(centers, radius).into_styled(style));
        }
        legend(band, Point::new(right, bottom));
    }
}

/// A named panel.
fn paper<O: Order>(band: &mut Band<'_, Rgb565, O>, name: &str, position: Point) {
    let above = position + Point::new(PANEL.width as i32 / 2, -10);
    label(band, name, above, Alignment::Center, &FONT_5X8, LABEL_COLOR);
    shape(
        band,
        &Rectangle::new(position, PANEL).into_styled(PrimitiveStyle::with_fill(PAPER)),
    );
}

/// A pixel of the lines, magnified; its cell leaves a gap to the next one.
fn cell<O: Order>(band: &mut Band<'_, Rgb565, O>, position: Point, pixel: Point, color: Rgb565) {
    let square = Rectangle::new(position + pixel * CELL as i32, Size::new_equal(CELL - 1));
    shape(band, &square.into_styled(PrimitiveStyle::with_fill(color)));
}

/// Where the lines run exactly: through the middle of their first and last cell.
fn exact_lines<O: Order>(band: &mut Band<'_, Rgb565, O>, position: Point) {
    let middle = |pixel: Point| position + pixel * CELL as i32 + Point::new_equal(CELL as i32 / 2 - 1);
    let mut panel = band.clipped(&Rectangle::new(position, PANEL));
    for (from, to) in LINES {
        let line = Line::new(middle(from), middle(to));
        shape(
            &mut Generic(&mut panel),
            &line.into_styled(PrimitiveStyle::with_stroke(EXACT, 1)),
        );
    }
}

/// Bresenham's lines, every other run in another colour.
fn runs<O: Order>(band: &mut Band<'_, Rgb565, O>, position: Point) {
    paper(band, "Bresenham, by runs", position);
    for (from, to) in LINES {
        let runs = Lines::runs(from, to, &WINDOW);
        for (run, color) in runs.zip([SAME, OTHER_RUN].into_iter().cycle()) {
            for pixel in run.to_rectangle().points() {
                cell(band, position, pixel, color);
            }
        }
    }
    exact_lines(band, position);
}

/// The lines of a sibling, held against Bresenham's.
fn sibling<O: Order, L: Iterator<Item = Point>>(
    band: &mut Band<'_, Rgb565, O>,
    name: &str,
    position: Point,
    line: impl Fn(Point, Point, &Window) -> L,
) {
    paper(band, name, position);
    let pixels = |from, to| line(from, to, &WINDOW);
    let expected = |from, to| Lines::bresenham(from, to, &WINDOW);
    for (from, to) in LINES {
        for pixel in expected(from, to) {
            let is_there = pixels(from, to).any(|other| other == pixel);
            cell(band, position, pixel, if is_there { SAME } else { MISSING });
        }
        for pixel in pixels(from, to) {
            if expected(from, to).all(|other| other != pixel) {
                cell(band, position, pixel, ADDED);
            }
        }
    }
    exact_lines(band, position);
}

fn legend<O: Order>(band: &mut Band<'_, Rgb565, O>, position: Point) {
    for (row, (color, text)) in (0..).zip(LEGEND) {
        let at = position + Point::new(0, 2 + 13 * row);
        let swatch = Rectangle::new(at, Size::new_equal(8));
        shape(band, &swatch.into_styled(PrimitiveStyle::with_fill(color)));
        label(
            band,
            text,
            at + Point::new(13, 0),
            Alignment::Left,
            &FONT_5X8,
            LABEL_COLOR,
        );
    }
}
