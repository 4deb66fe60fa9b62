//! The depth row on its way down: the faces of its active list, and the depths of the row, seen from above.

use core::fmt::Write;

use embedded_graphics::{
    mono_font::ascii::FONT_5X8,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Rectangle, Triangle},
    text::Alignment,
};
use heapless::Vec;
use zrow::{
    band::{Band, BandColor, Order},
    draw::PrimitiveStyle,
    scene::DepthWidth,
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{TITLE_COLOR, label, rgb, shape},
    visibility::{
        panel::{self, CELL, Panel, Text},
        solids::{ACTIVE, Frame},
        work::{BEHIND, COLUMNS, PIXELS, ROWS, Subject},
    },
};

/// Frames that show the whole picture at the end.
const PAUSE: u32 = 10;
const FRAMES: u32 = ROWS as u32 + PAUSE;
/// The upper left corner of the picture on the page.
const PICTURE: Point = Point::new(8, 18);
/// The part of the page in which the depths of the row are drawn.
const DEPTHS: Rectangle = Rectangle::new(Point::new(8, 186), Size::new(COLUMNS as u32 * CELL, 44));
/// The upper left corner of the active list on the page.
const LIST: Point = Point::new(222, 18);
/// From an entry of the list to the next one.
const ENTRY: i32 = 8;

const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
const OUTLINE: Rgb565 = rgb(240, 236, 214);
/// 1/16 pixel.
const UNITS: i32 = 16;

/// The solids, and what is shown of a row.
#[derive(Debug)]
pub struct ScanLine {
    subject: Subject,
    panel: Panel,
    row: Row,
}

impl Default for ScanLine {
    fn default() -> Self {
        Self {
            subject: Subject::default(),
            panel: Panel::EMPTY,
            row: Row::EMPTY,
        }
    }
}

/// A face that crosses the row.
#[derive(Debug, Copy, Clone)]
struct Active {
    face: usize,
    /// Its corners on the page.
    corners: [Point; 3],
    /// The two ends of the face's span in the row, each with its column in 1/16 pixel and its depth.
    ends: [[i32; 2]; 2],
}

/// What is shown of a row.
#[derive(Debug)]
struct Row {
    number: i32,
    active: Vec<Active, ACTIVE>,
    /// The face that is seen in each column.
    seen: [Option<usize>; COLUMNS],
    /// The farthest and the nearest depth of the picture.
    depths: [i32; 2],
}

impl Row {
    const EMPTY: Self = Self {
        number: 0,
        active: Vec::new(),
        seen: [None; COLUMNS],
        depths: [0, 1],
    };

    fn of(frame: &Frame<'_>, number: i32) -> Self {
        let mut row = Self { number, ..Self::EMPTY };
        let (mut farthest, mut nearest) = (i32::MAX, 0);
        for face in frame.faces() {
            let corners = face.corners.map(|corner| {
                let [x, y] = [corner.point.x_units(), corner.point.y_units()];
                [x, y, corner.depth.units()]
            });
            if !is_front(corners) {
                continue;
            }
            for [_, _, depth] in corners {
                (farthest, nearest) = (farthest.min(depth), nearest.max(depth));
            }
            if let Some(active) = Active::of(face.order, corners, number) {
                // There is room for all: the scene names the most that cross a row.
                let _ = row.active.push(active);
            }
        }
        row.depths = [farthest, nearest.max(farthest.saturating_add(1))];
        for (seen, column) in row.seen.iter_mut().zip(0..) {
            *seen = frame.face_at(Point::new(column, number));
        }
        row
    }

    /// Where a depth at a column, in 1/16 pixel, is on the page. What is nearer is lower: the eye is below.
    fn position(&self, [column, depth]: [i32; 2]) -> Point {
        let [farthest, nearest] = self.depths;
        let height = DEPTHS.size.height as i32 - 3;
        let down = i64::from(height) * i64::from(depth - farthest) / i64::from(nearest - farthest);
        DEPTHS.top_left + Point::new(on_page(column), 1 + down as i32)
    }
}

/// The middle of a pixel on the page.
fn on_page(units: i32) -> i32 {
    (units * CELL as i32).div_euclid(UNITS) + CELL as i32 / 2
}

/// A corner on the screen: column and row in 1/16 pixel, and the depth.
type Corner = [i32; 3];

/// Whether the corners of a face run clockwise on the screen.
fn is_front([a, b, c]: [Corner; 3]) -> bool {
    (b[0] - a[0]) * (c[1] - a[1]) > (c[0] - a[0]) * (b[1] - a[1])
}

impl Active {
    /// A face in a row; `None` where it does not cross the row.
    fn of(face: usize, corners: [Corner; 3], row: i32) -> Option<Self> {
        let [a, b, c] = corners;
        let mut ends = [(a, b), (b, c), (c, a)]
            .into_iter()
            .filter_map(|(from, to)| crossing(from, to, row));
        let [one, other] = [ends.next()?, ends.next()?];
        Some(Self {
            face,
            corners: corners.map(|[x, y, _]| PICTURE + Point::new(on_page(x), on_page(y))),
            ends: if one <= other { [one, other] } else { [other, one] },
        })
    }

    /// The column in 1/16 pixel and the depth at a column between the ends.
    fn at(&self, column: i32) -> [i32; 2] {
        let [[left, start], [right, end]] = self.ends;
        let across = UNITS * column;
        let depth = start + part(end - start, across - left, right - left);
        [across, depth]
    }
}

/// Where an edge crosses a row: the column, and the depth.
fn crossing(from: Corner, to: Corner, row: i32) -> Option<[i32; 2]> {
    let ([x1, y1, z1], [x2, y2, z2]) = if from[1] < to[1] { (from, to) } else { (to, from) };
    let y = UNITS * row;
    (y1 <= y && y < y2).then(|| [x1 + part(x2 - x1, y - y1, y2 - y1), z1 + part(z2 - z1, y - y1, y2 - y1)])
}

/// So many of some steps of a length.
fn part(length: i32, step: i32, steps: i32) -> i32 {
    (i64::from(length) * i64::from(step) / i64::from(steps.max(1))) as i32
}

impl Scene for ScanLine {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "scan-line";
    const TITLE: &'static str = "the depth row and its active faces";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = 24;
    const DEPTH_ROW_BYTES: usize = size_of::<[u16; COLUMNS]>();

    fn prepare(&mut self, frame: u32) -> Result<&mut Self, PrepareError> {
        let number = (frame % FRAMES).min(ROWS as u32 - 1);
        let mut frame = self.subject.prepare()?;
        self.row = Row::of(&frame, number as i32);
        let mut words = [BEHIND.to_word(); PIXELS];
        frame.draw(&mut Band::<Rgb565>::new(Subject::AREA, &mut words)?);
        let drawn = COLUMNS * (number as usize + 1);
        self.panel = Panel::of(|pixel| {
            let word = words.get(pixel).filter(|_| pixel < drawn);
            word.map_or(BEHIND, |word| Rgb565::from_word(*word))
        });
        // Around the row.
        for (pixel, cell) in self.panel.cells.iter_mut().enumerate() {
            if pixel / COLUMNS == number as usize || pixel / COLUMNS == number as usize + 1 {
                cell.top = panel::Line::Special;
            }
        }
        self.panel.name = "depths of the row; the eye is below";
        Ok(self)
    }
}

impl Prepared for ScanLine {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let title = <Self as Scene>::TITLE;
        label(band, title, Point::new(8, 6), Alignment::Left, &FONT_5X8, TITLE_COLOR);
        self.panel.draw(band, PICTURE);
        for active in &self.row.active {
            let [a, b, c] = active.corners;
            let outline = Triangle::new(a, b, c).into_styled(PrimitiveStyle::with_stroke(OUTLINE, 1));
            shape(band, &outline);
        }
        draw_depths(band, &self.row);
        draw_list(band, &self.row);
    }
}

/// The faces that cross the row as lines, and over them what is seen.
fn draw_depths<O: Order>(band: &mut Band<'_, Rgb565, O>, row: &Row) {
    shape(band, &DEPTHS.into_styled(PrimitiveStyle::with_fill(BEHIND)));
    for active in &row.active {
        let [start, end] = active.ends.map(|end| row.position(end));
        let style = PrimitiveStyle::with_stroke(Subject::color(active.face), 1);
        shape(band, &Line::new(start, end).into_styled(style));
    }
    for (face, column) in row.seen.iter().zip(0..) {
        let active = row.active.iter().find(|active| Some(active.face) == *face);
        if let Some(active) = active {
            let at = row.position(active.at(column)) - Point::new(1, 1);
            let style = PrimitiveStyle::with_fill(Subject::color(active.face));
            shape(band, &Rectangle::new(at, Size::new_equal(CELL)).into_styled(style));
        }
    }
}

/// The active list: each face with its columns, bright where it is seen.
fn draw_list<O: Order>(band: &mut Band<'_, Rgb565, O>, row: &Row) {
    let mut text = Text::new();
    // Long enough for any number, as the texts below.
    let _ = write!(text, "row {}: {} active", row.number, row.active.len());
    label(band, &text, LIST, Alignment::Left, &FONT_5X8, TITLE_COLOR);
    let head = LIST + Point::new(12, 11);
    label(band, "face: columns", head, Alignment::Left, &FONT_5X8, LABEL_COLOR);
    for (active, index) in row.active.iter().zip(0..) {
        let at = LIST + Point::new(0, 22 + ENTRY * index);
        let swatch = Rectangle::new(at, Size::new(8, 6));
        let color = Subject::color(active.face);
        shape(band, &swatch.into_styled(PrimitiveStyle::with_fill(color)));
        let mut text = Text::new();
        let [start, end] = active.ends.map(|[column, _]| (column + UNITS - 1).div_euclid(UNITS));
        let _ = write!(text, "{:2}: {start}..{end}", active.face);
        let is_seen = row.seen.contains(&Some(active.face));
        let color = if is_seen { TITLE_COLOR } else { LABEL_COLOR };
        label(band, &text, at + Point::new(12, -1), Alignment::Left, &FONT_5X8, color);
    }
}
