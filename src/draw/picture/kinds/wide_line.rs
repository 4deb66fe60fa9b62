//! Lines of two pixels and more: the columns between two sides of a rectangle, each stepped by an addition and an error term.
//!
//! ```text
//!      a _____ b       | start | end | width, next change | steps | left side | right side |
//!     ___/_____/___
//!       /     /        Each row of pixel centres crosses a side on the left and one on the right: the pixels between both are
//!     d ----- c        inside. Where a side begins or ends, those of the row are set up from the ends of the line.
//! ```
//!
//! Guarantees: the pixels of the line's own [`wide_stroke`](crate::scan::stroke::wide_stroke). Cost of a row: four additions; of
//! one in which a side begins or ends, of which there are five at most, a square root and the divisions of two sides.

use core::ops::Range;

use embedded_graphics::{geometry::Point, primitives::Line};

use crate::{
    band::Band,
    draw::{
        StrokedShape,
        payload::Payload,
        picture::{
            item::{Extent, PictureItem, PictureSlot, each_row, fill_short_span, fill_span},
            kinds::replayed::{Words, visible_columns},
            pool::{Pool, packed},
            prepare::Draft,
        },
    },
    geometry::Window,
    scan::{
        polygon::{Edge, EdgeWalk, Part, ceil_pixel},
        stroke::wide_stroke::{Corner, FRACTION_BITS},
    },
    surface::{BandColor, Order, Target},
};

/// A line of two pixels and more in one colour. The cursor has the columns of both sides in the row that comes next.
struct WideLine;

/// Words of a line.
const WORDS: usize = 10;
/// The words that change from row to row, apart from the next change: the steps of both sides, 16 bits each, and for each
/// side its error term, what is added to that, and its height, as in [`EdgeWalk`].
const SIDES: Range<usize> = 3..WORDS;

/// The farthest column and row of an end from 0: so far from the ends of 16 bits that both lie in them with the line's pixels.
const FARTHEST: u32 = 1 << 14;

/// The item of a line with a stroke of two pixels or more that has its pixels in a window; `None` where its numbers do not fit.
pub(super) fn prepare<'a, C: BandColor, O: Order>(
    line: &Line,
    (color, width): (C, u32),
    window: &Window,
    payload: &mut Payload<'_>,
) -> Option<Draft<'a, C, O>> {
    let is_near = |point: Point| point.x.unsigned_abs() < FARTHEST && point.y.unsigned_abs() < FARTHEST;
    let extent = Extent::of_whole(window).filter(|_| is_near(line.start) && is_near(line.end))?;
    // Wider strokes than that are not generated.
    let width = width.min(u16::MAX.into());
    payload.push_all(&[
        packed(line.start.x, line.start.y),
        packed(line.end.x, line.end.y),
        width,
    ]);
    payload.push_all(&[0; SIDES.end - SIDES.start]);
    Some(Draft::new(extent, Band::<C, O>::word(color), &WideLine))
}

/// The line that the first three words tell, and the width of its stroke.
fn read([start, end, width, ..]: &[u32; WORDS]) -> (Line, u32) {
    let point = |word: &u32| Point::new((*word as i16).into(), (*word as i32) >> 16);
    (Line::new(point(start), point(end)), *width & 0xffff)
}

/// Sets up the sides that a row crosses, if there are any, and the row in which others begin or end. Below the row before `end` there
/// are none.
#[inline(never)]
fn set_up(words: &mut [u32; WORDS], cursor: &mut [u32; 2], row: i32, end: i32) {
    let (line, width) = read(words);
    let (mut sides, mut next_change) = ([[0; EdgeWalk::WORDS]; 2], i32::MAX);
    let mut add = |from: Corner, to: Corner| {
        let ends = [from.1, to.1].map(|y| ceil_pixel(y, FRACTION_BITS));
        let (first, end) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        // Before the divisions of an edge.
        if first == end || end <= row {
            return;
        }
        if row < first {
            next_change = next_change.min(first);
            return;
        }
        next_change = next_change.min(end);
        if let Some(edge) = Edge::from_units(from, to, FRACTION_BITS, Part::Stroke) {
            // The polygons of strokes run down on the left and up on the right.
            let [left, right] = &mut sides;
            let side = if from.1 < to.1 { left } else { right };
            *side = edge.walk_from(row).to_words();
        }
    };
    if row < end {
        add_sides(&line, width, &mut add);
    }
    // Once the line has ended, the words are those that it began with: two equal lines are equal again. Its last rows may have no
    // pixels, and are none of the item's.
    let next_change = if next_change == i32::MAX {
        0
    } else {
        next_change.min(end)
    };
    // A side with a longer step than 16 bits tell is crossed by one row.
    let clamped = |step: u32| (step as i32).clamp(i16::MIN.into(), i16::MAX.into());
    let [left, right] = sides;
    *cursor = [left[0], right[0]];
    let [_, _, change, steps, rest @ ..] = words;
    // The rows of an item fit 16 bits.
    *change = packed(width as i32, next_change);
    *steps = packed(clamped(left[2]), clamped(right[2]));
    *rest = [left[1], left[3], left[4], right[1], right[3], right[4]];
}

/// Calls with both ends of each side of the rectangle that a line is.
fn add_sides(line: &Line, width: u32, add: &mut dyn FnMut(Corner, Corner)) {
    line.paths(2 * u64::from(width), &mut |path| {
        path.polygons(None, &mut |corners| {
            let Some(mut from) = corners.last().copied() else {
                return;
            };
            for corner in corners {
                add(from, *corner);
                from = *corner;
            }
        });
    });
}

/// Goes on to a side's column in the next row; returns that in the row before.
#[inline(always)]
fn step(column: &mut u32, error: &mut u32, step: i32, [error_step, height]: [u32; 2]) -> i32 {
    let mut walk = EdgeWalk::of_words([*column, *error, step as u32, error_step, height]);
    let before = walk.x();
    walk.step();
    [*column, *error, ..] = walk.to_words();
    before
}

impl<C: BandColor, O: Order> PictureItem<C, O> for WideLine {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        if let Some(words) = pool.array(slot.at) {
            set_up(words, &mut slot.cursor, row, slot.extent.end.into());
        }
    }

    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, pool: &Pool<'_>, rows: Range<i32>) -> (i32, i32) {
        let columns = pool.slice(slot.at, slot.words).first_chunk().and_then(|words| {
            let (line, width) = read(words);
            line.columns_in(width, rows)
        });
        visible_columns(slot.extent, columns)
    }

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        let Some(words) = pool.array::<WORDS>(slot.at) else {
            return;
        };
        let (line, width) = read(words);
        let [start, end] = [line.start, line.end].map(|point| {
            let Point { x, y } = point + by;
            packed(x, y)
        });
        // As it was prepared.
        *words = [start, end, width, 0, 0, 0, 0, 0, 0, 0];
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let Some(words) = pool.array::<WORDS>(slot.at) else {
            return;
        };
        let [_, _, change, steps, rest @ ..] = words;
        let [
            left_error,
            left_error_step,
            left_height,
            right_error,
            right_error_step,
            right_height,
        ] = rest;
        let [left, right] = &mut slot.cursor;
        let (left_step, right_step) = (i32::from(*steps as i16), *steps as i32 >> 16);
        let start = step(left, left_error, left_step, [*left_error_step, *left_height]);
        let end = step(right, right_error, right_step, [*right_error_step, *right_height]);
        let next_row = band.window().top + 1;
        if next_row >= *change as i32 >> 16 {
            set_up(words, &mut slot.cursor, next_row, slot.extent.end.into());
        }
        /// Up to this many pixels, writing them one by one takes less than filling a span.
        const SHORT: i32 = 12;
        if end - start <= SHORT {
            fill_short_span(band, (start, end), slot.word);
        } else {
            fill_span(band, (start, end), slot.word);
        }
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        each_row(slot, band, |slot, row| self.draw_row(slot, pool, row));
    }
}
