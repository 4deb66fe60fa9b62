//! Polygons clipped against polygons: pairs with corners on edges, shared edges and touching holes, and what is left of
//! them by each operation. Outlines of holes have a colour of their own, and every corner has a dot.

use embedded_graphics::{
    mono_font::ascii::{FONT_5X8, FONT_6X10},
    pixelcolor::Rgb565,
    prelude::*,
    primitives::Rectangle,
    text::Alignment,
};
use fixed::types::I12F4;
use zrow::{
    band::{Band, Order},
    clip::{Clipper, Operation},
    draw::{FillRule, Polygon, PrimitiveStyle},
    geometry::{Sub4, SubPoint},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape},
};

type Corner = SubPoint<Sub4>;
type Shape = &'static [&'static [Corner]];

const TITLE_COLOR: Rgb565 = rgb(255, 255, 255);
const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
const SUBJECT: Rgb565 = rgb(58, 106, 190);
const CLIP: Rgb565 = rgb(255, 167, 38);
const RESULT: Rgb565 = rgb(46, 125, 70);
const OUTER: Rgb565 = rgb(200, 255, 210);
const HOLE: Rgb565 = rgb(255, 96, 120);

/// A point in pixels.
const fn at(x: i16, y: i16) -> Corner {
    SubPoint {
        x: I12F4::from_bits(x * 16),
        y: I12F4::from_bits(y * 16),
    }
}

/// Two polygons, and what is special about them.
struct Pair {
    name: [&'static str; 2],
    subject: Shape,
    clip: Shape,
}

const PAIRS: [Pair; 5] = [
    Pair {
        name: ["crossing,", "concave"],
        subject: &[
            &[at(2, 2), at(34, 2), at(44, 19), at(34, 36), at(2, 36)],
            &[at(10, 10), at(26, 10), at(26, 28), at(10, 28)],
        ],
        clip: &[&[at(18, 6), at(56, 4), at(36, 19), at(56, 34), at(18, 32), at(28, 19)]],
    },
    Pair {
        name: ["touching", "holes"],
        subject: &[
            &[at(2, 2), at(50, 2), at(50, 36), at(2, 36)],
            &[at(2, 19), at(18, 10), at(18, 28)],
            &[at(18, 10), at(36, 6), at(36, 19)],
        ],
        clip: &[&[at(10, 19), at(36, 19), at(56, 12), at(56, 30), at(10, 30)]],
    },
    Pair {
        name: ["corners", "on edges"],
        subject: &[&[at(2, 36), at(16, 4), at(26, 20), at(36, 4), at(50, 36)]],
        clip: &[&[at(9, 20), at(26, 20), at(56, 20), at(56, 28), at(26, 36), at(4, 28)]],
    },
    Pair {
        name: ["shared", "edges"],
        subject: &[&[at(2, 2), at(52, 2), at(52, 14), at(22, 14), at(22, 36), at(2, 36)]],
        clip: &[&[at(2, 20), at(22, 20), at(22, 14), at(40, 14), at(40, 36), at(2, 36)]],
    },
    Pair {
        name: ["the same", "twice"],
        subject: &[
            &[
                at(26, 0),
                at(34, 13),
                at(52, 19),
                at(34, 25),
                at(26, 38),
                at(18, 25),
                at(2, 19),
                at(18, 13),
            ],
            &[at(26, 12), at(34, 19), at(26, 26), at(18, 19)],
        ],
        clip: &[
            &[
                at(18, 25),
                at(26, 38),
                at(34, 25),
                at(52, 19),
                at(34, 13),
                at(26, 0),
                at(18, 13),
                at(2, 19),
            ],
            &[at(18, 19), at(26, 26), at(34, 19), at(26, 12)],
        ],
    },
];

const OPERATIONS: [(&str, Operation); 3] = [
    ("intersection", Operation::Intersection),
    ("union", Operation::Union),
    ("difference", Operation::Difference),
];

/// Left sides of the pairs and of the results, and the height of a row below the first.
const PAIR_X: i16 = 56;
const RESULT_X: [i16; 3] = [124, 190, 256];
const ROW_Y: i16 = 28;
const ROW_HEIGHT: i16 = 42;

const MOST_CORNERS: usize = 24;
const MOST_CONTOURS: usize = 6;

/// The contours of one polygon on the screen.
#[derive(Debug, Copy, Clone)]
struct Contours {
    corners: [Corner; MOST_CORNERS],
    /// Where each contour ends in the corners, and whether it is a hole.
    ends: [(usize, bool); MOST_CONTOURS],
    count: usize,
}

impl Contours {
    const NONE: Self = Self {
        corners: [at(0, 0); MOST_CORNERS],
        ends: [(0, false); MOST_CONTOURS],
        count: 0,
    };

    /// Adds a contour, moved; leaves out what there is no room for.
    fn add(&mut self, contour: impl Iterator<Item = Corner>, is_hole: bool, (x, y): (i16, i16)) {
        let mut end = self.end(self.count);
        for corner in contour {
            if let Some(slot) = self.corners.get_mut(end) {
                let moved = at(x, y);
                *slot = SubPoint {
                    x: corner.x + moved.x,
                    y: corner.y + moved.y,
                };
                end += 1;
            }
        }
        if let Some(slot) = self.ends.get_mut(self.count) {
            *slot = (end, is_hole);
            self.count += 1;
        }
    }

    /// Where the contours before this one end.
    fn end(&self, contour: usize) -> usize {
        let before = contour.checked_sub(1).and_then(|before| self.ends.get(before));
        before.map_or(0, |&(end, _)| end)
    }

    /// Each contour, and whether it is a hole.
    fn all(&self) -> impl Iterator<Item = (&[Corner], bool)> {
        let ends = self.ends.iter().take(self.count).enumerate();
        ends.map(|(index, &(end, is_hole))| (self.corners.get(self.end(index)..end).unwrap_or_default(), is_hole))
    }

    /// The corners of each contour, as a list whose last entries are empty.
    fn slices(&self) -> [&[Corner]; MOST_CONTOURS] {
        let mut slices: [&[Corner]; MOST_CONTOURS] = [&[]; MOST_CONTOURS];
        for (slice, (contour, _)) in slices.iter_mut().zip(self.all()) {
            *slice = contour;
        }
        slices
    }
}

/// A pair and its results.
#[derive(Debug, Copy, Clone)]
struct Row {
    subject: Contours,
    clip: Contours,
    results: [Contours; 3],
}

/// The scene: clipped anew for each frame.
#[derive(Debug)]
pub struct Booleans {
    clipper: Clipper<Sub4, 64>,
    rows: [Row; PAIRS.len()],
}

impl Default for Booleans {
    fn default() -> Self {
        let row = Row {
            subject: Contours::NONE,
            clip: Contours::NONE,
            results: [Contours::NONE; 3],
        };
        Self {
            clipper: Clipper::new(),
            rows: [row; PAIRS.len()],
        }
    }
}

impl Scene for Booleans {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "booleans";
    const TITLE: &'static str = "polygons against polygons";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        let Self { clipper, rows } = self;
        for ((pair, row), y) in PAIRS.iter().zip(rows).zip(row_tops()) {
            row.subject = placed(pair.subject, y);
            row.clip = placed(pair.clip, y);
            for ((result, (_, operation)), x) in row.results.iter_mut().zip(OPERATIONS).zip(RESULT_X) {
                *result = Contours::NONE;
                let clipped = clipper.greiner_hormann(pair.subject, pair.clip, operation)?;
                for contour in clipped {
                    result.add(contour.points(), contour.is_hole(), (x, y));
                }
            }
        }
        Ok(self)
    }
}

fn row_tops() -> impl Iterator<Item = i16> {
    (0..).map(|row| ROW_Y + row * ROW_HEIGHT)
}

fn placed(polygon: Shape, y: i16) -> Contours {
    let mut contours = Contours::NONE;
    for contour in polygon {
        contours.add(contour.iter().copied(), false, (PAIR_X, y));
    }
    contours
}

impl Prepared for Booleans {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let title = <Self as Scene>::TITLE;
        label(
            band,
            title,
            Point::new(160, 3),
            Alignment::Center,
            &FONT_6X10,
            TITLE_COLOR,
        );
        label(
            band,
            "pair",
            Point::new(82, 18),
            Alignment::Center,
            &FONT_5X8,
            LABEL_COLOR,
        );
        for ((name, _), x) in OPERATIONS.into_iter().zip(RESULT_X) {
            let over = Point::new(i32::from(x) + 28, 18);
            label(band, name, over, Alignment::Center, &FONT_5X8, LABEL_COLOR);
        }
        for ((pair, row), y) in PAIRS.iter().zip(&self.rows).zip(row_tops()) {
            for (name, y) in pair.name.into_iter().zip([y + 10, y + 20]) {
                label(
                    band,
                    name,
                    Point::new(4, y.into()),
                    Alignment::Left,
                    &FONT_5X8,
                    LABEL_COLOR,
                );
            }
            draw_row(band, row);
            for (result, x) in row.results.iter().zip(RESULT_X) {
                if result.count == 0 {
                    let middle = Point::new(i32::from(x) + 28, i32::from(y) + 15);
                    label(band, "empty", middle, Alignment::Center, &FONT_5X8, LABEL_COLOR);
                }
            }
        }
    }
}

fn draw_row<O: Order>(band: &mut Band<'_, Rgb565, O>, row: &Row) {
    draw_polygon(band, &row.subject.slices(), PrimitiveStyle::with_fill(SUBJECT));
    for (contour, _) in row.clip.all() {
        draw_outline(band, contour, CLIP);
    }
    for result in &row.results {
        draw_polygon(band, &result.slices(), PrimitiveStyle::with_fill(RESULT));
        for (contour, is_hole) in result.all() {
            draw_outline(band, contour, if is_hole { HOLE } else { OUTER });
        }
    }
}

fn draw_outline<O: Order>(band: &mut Band<'_, Rgb565, O>, contour: &[Corner], color: Rgb565) {
    draw_polygon(band, &[contour], PrimitiveStyle::with_stroke(color, 1));
    for corner in contour {
        let pixel = Point::new(corner.x.round().to_num(), corner.y.round().to_num());
        let dot = Rectangle::with_center(pixel, Size::new(3, 3));
        shape(band, &dot.into_styled(PrimitiveStyle::with_fill(color)));
    }
}

fn draw_polygon<O: Order>(band: &mut Band<'_, Rgb565, O>, contours: &[&[Corner]], style: PrimitiveStyle<Rgb565>) {
    // No polygon here has more edges than this: it always fits.
    if let Ok(ready) = Polygon::new(contours, FillRule::EvenOdd).prepare::<MOST_CORNERS, MOST_CORNERS>() {
        shape(band, &ready.into_styled(style));
    }
}
