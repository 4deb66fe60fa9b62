//! What a method has drawn, and the work that it has reported for it, pixel by pixel.

use core::convert::Infallible;

use embedded_graphics::{pixelcolor::Rgb565, primitives::PointsIter};
use heapless::Vec;
use zrow::{
    band::{Band, BandColor, Span},
    geometry::Window,
    scan::Polygons,
    visible::{Visibility, Work},
};

use crate::{
    PrepareError,
    paint::rgb,
    visibility::solids::{FACES, Frame, Solids},
};

/// Pixels of the pictures that are drawn with their work.
pub const COLUMNS: usize = 68;
pub const ROWS: usize = 51;
pub const PIXELS: usize = COLUMNS * ROWS;
/// The most rectangles and splits that are kept.
const MOST: usize = 64;

/// What is behind the solids.
pub const BEHIND: Rgb565 = rgb(24, 30, 42);

pub type Subject = Solids<COLUMNS, ROWS>;

/// A line at the left or the upper side of a pixel.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
pub struct Sides {
    pub left: bool,
    pub top: bool,
}

/// A pixel that was painted last in one of the faces, by its index, as the number that it has in the order of painting, from 1 on.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
pub struct Painted {
    pub face: usize,
    pub number: u16,
}

/// What a method has drawn and reported.
#[derive(Debug)]
pub struct Record {
    pub words: [u16; PIXELS],
    /// How many faces were tested in each pixel, and in all.
    pub tests: [u16; PIXELS],
    pub tested: u32,
    pub painted: [Painted; PIXELS],
    /// Faces that were painted one after the other: a face that was painted in parts counts more than once.
    pub numbers: u16,
    pub spans: u32,
    /// Where spans begin.
    pub starts: [bool; PIXELS],
    /// The sides of rectangles, and how many there were.
    pub sides: [Sides; PIXELS],
    pub areas: u32,
    /// The first of the rectangles, with their faces.
    pub first_areas: Vec<(Window, usize), MOST>,
    /// Which face was split by which one.
    pub splits: Vec<[usize; 2], MOST>,
    last: Option<usize>,
}

impl Record {
    const EMPTY: Self = Self {
        words: [0; PIXELS],
        tests: [0; PIXELS],
        tested: 0,
        painted: [Painted { face: 0, number: 0 }; PIXELS],
        numbers: 0,
        spans: 0,
        starts: [false; PIXELS],
        sides: [Sides {
            left: false,
            top: false,
        }; PIXELS],
        areas: 0,
        first_areas: Vec::new(),
        splits: Vec::new(),
        last: None,
    };

    /// Of the solids, drawn by a method.
    pub fn by(frame: &mut Frame<'_>, method: &mut impl Visibility<u16>) -> Result<Self, PrepareError> {
        let (mut record, mut words) = (Self::EMPTY, [BEHIND.to_word(); PIXELS]);
        let mut band = Band::<Rgb565>::new(Subject::AREA, &mut words)?;
        frame.draw_by_with(method, &mut band, |work| record.take(work))?;
        record.words = words;
        Ok(record)
    }

    /// Of the solids, drawn by the depth row: each face is tested in its spans.
    pub fn by_rows(frame: &mut Frame<'_>) -> Result<Self, PrepareError> {
        let (mut record, mut words) = (Self::EMPTY, [BEHIND.to_word(); PIXELS]);
        frame.draw(&mut Band::<Rgb565>::new(Subject::AREA, &mut words)?);
        record.words = words;
        for face in frame.faces() {
            let corners = face.corners.map(|corner| corner.point);
            let Ok(()) = Polygons::incremental_edge_triangle(corners, &Subject::AREA.into(), |span| {
                record.take(Work::Tested { face: face.order, span });
                record.start(span);
                Ok::<(), Infallible>(())
            });
        }
        Ok(record)
    }

    fn take(&mut self, work: Work) {
        match work {
            Work::Painted { face, span } => self.paint(face, span),
            Work::Tested { span, .. } => {
                self.tested += (span.end - span.start) as u32;
                for tests in pixels(&mut self.tests, span) {
                    *tests += 1;
                }
            }
            Work::Area { window, faces } => {
                self.areas += 1;
                // Some are shown with their faces; all of them with their sides.
                let _ = self.first_areas.push((window, faces));
                self.outline(&window);
            }
            Work::Split { face, by } => {
                let _ = self.splits.push([face, by]);
            }
            _ => {}
        }
    }

    fn paint(&mut self, face: usize, span: Span) {
        debug_assert!(face < FACES, "a face of the solids");
        if self.last != Some(face) {
            self.numbers += 1;
        }
        self.last = Some(face);
        let painted = Painted {
            face,
            number: self.numbers,
        };
        pixels(&mut self.painted, span).fill(painted);
        self.start(span);
    }

    fn start(&mut self, span: Span) {
        self.spans += 1;
        let first = Span {
            end: span.start + 1,
            ..span
        };
        pixels(&mut self.starts, first).fill(true);
    }

    /// Lines around a rectangle. Its lower and its right side are those of the pixels beyond.
    fn outline(&mut self, window: &Window) {
        for row in window.top..window.bottom {
            for column in [window.left, window.right] {
                for sides in pixels(&mut self.sides, Span::new(row, column, column + 1)) {
                    sides.left = true;
                }
            }
        }
        for row in [window.top, window.bottom] {
            for sides in pixels(&mut self.sides, Span::new(row, window.left, window.right)) {
                sides.top = true;
            }
        }
    }

    /// The middle of the pixels that were painted last under a number, and how many they are; twice the middle.
    pub fn middle_of(&self, number: u16) -> Option<([i32; 2], u32)> {
        let (mut sum, mut count) = ([0; 2], 0);
        let area = Subject::AREA.points();
        for (point, _) in area.zip(&self.painted).filter(|(_, painted)| painted.number == number) {
            sum = [sum[0] + 2 * point.x + 1, sum[1] + 2 * point.y + 1];
            count += 1;
        }
        (count > 0).then(|| (sum.map(|sum| sum / count), count as u32))
    }
}

/// What of a table with an entry for each pixel belongs to a span.
fn pixels<T>(table: &mut [T; PIXELS], span: Span) -> &mut [T] {
    let part = span.clipped_to(&Subject::AREA.into());
    let first = part.y * COLUMNS as i32;
    table
        .get_mut((first + part.start) as usize..(first + part.end) as usize)
        .unwrap_or_default()
}
