//! Strokes of one pixel's width along contours of pixels: the vertices are words, and behind them lie the segments that the row meets.
//!
//! ```text
//!     colour | words of the contours | active segments, next scan | contours | segments ..
//!
//!     state, steps | column of the upper end, columns | rows, direction, row after the last one          a segment
//! ```
//!
//! A segment is set up when its first row comes, and leaves after its last one. A stroke with vertices so far apart that a segment does not
//! fit has no room for any: all of it is drawn anew in each band.
//!
//! Guarantees: the pixels of Bresenham's lines between the vertices. Cost of a row: a run of pixels for each segment that it meets; where
//! a segment begins, a division and a look at each vertex.

use core::{convert::Infallible, ops::Range};

use embedded_graphics::geometry::Point;

use crate::{
    band::Band,
    draw::{
        eg::polyline,
        payload::{Payload, Reader},
        picture::{
            item::{Extent, fill_short_span, set_pixel},
            kinds::{
                contour_stroke::StrokeWords,
                contours::{self, ContourWriter, Contours, vertex_of},
                strips::Strips,
                thin_line,
            },
            pool::packed,
        },
    },
    geometry::Window,
    surface::{BandColor, BatchTarget, Order, PixelWord, Target},
};

/// The number of words of a thin stroke before its offset, and the indices of the second one and the third one.
const HEADER_WORDS: usize = 3;
const LENGTH: usize = 1;
const ACTIVE: usize = 2;

/// Words of an active segment.
const SEGMENT_WORDS: usize = 4;

/// In the last word of a segment, beside the number of rows below the first one: whether it runs to the left from its upper end.
const RUNS_LEFT: u32 = 1 << 15;

type Segment = [u32; SEGMENT_WORDS];

/// A stroke of one pixel's width along contours of pixels.
pub(super) struct ThinStroke;

/// Writes a stroke and room for its active segments, and returns a box around its pixels.
pub(super) fn store<C: BandColor, O: Order>(
    color: C,
    write: &dyn Fn(&mut ContourWriter<'_, '_>),
    offset: Point,
    payload: &mut Payload<'_>,
) -> Window {
    payload.push_pixel(Band::<C, O>::word(color));
    store_contours(write, offset, payload)
}

#[inline(never)]
fn store_contours(write: &dyn Fn(&mut ContourWriter<'_, '_>), offset: Point, payload: &mut Payload<'_>) -> Window {
    let length = payload.needed();
    payload.push_all(&[0, 0]);
    let start = payload.needed();
    let window = Window::from(contours::write(write, offset, 0, payload).to_rectangle());
    // A pool has no more words than 16 bits tell.
    payload.set(length, (payload.needed() - start) as u32);
    let fits = window.width() <= thin_line::MOST && window.height() <= thin_line::MOST;
    if Extent::of_whole(&window).is_some() && fits {
        let mut strips = Strips::new(window.top..window.bottom);
        contours::write_segments(
            write,
            offset,
            0,
            &mut Payload::counting(0),
            &mut |[_, from], [_, to]| {
                // Within 16 bits with the offset.
                let [first, last] = [from.min(to), from.max(to)].map(|y| y.saturating_add(offset.y));
                strips.push(first..last + 1);
            },
        );
        for _ in 0..strips.most() * SEGMENT_WORDS {
            payload.push(0);
        }
    }
    window
}

/// The words of a stroke, taken apart.
struct Parts<'w> {
    header: &'w mut [u32; HEADER_WORDS],
    contours: &'w [u32],
    segments: &'w mut [u32],
}

impl<'w> Parts<'w> {
    #[inline(always)]
    fn of(words: &'w mut [u32]) -> Option<Self> {
        let (header, rest) = words.split_first_chunk_mut::<HEADER_WORDS>()?;
        let (contours, segments) = rest.split_at_mut_checked(header[LENGTH] as usize)?;
        Some(Self {
            header,
            contours,
            segments,
        })
    }

    /// The number of the stroke's segments that meet the row of the cursor: the active ones.
    #[inline(always)]
    fn active(&self) -> usize {
        usize::from(self.header[ACTIVE] as u16)
    }

    /// The first row in which a segment may begin.
    #[inline(always)]
    fn next_scan(&self) -> i32 {
        self.header[ACTIVE] as i32 >> 16
    }

    fn set_active(&mut self, count: usize, next_scan: i32) {
        // As many as there is room for in the words of an item; rows of a picture.
        self.header[ACTIVE] = u32::from(count as u16) | (next_scan as u32) << 16;
    }

    #[inline(always)]
    fn segment(&mut self, index: usize) -> Option<&mut Segment> {
        self.segments.get_mut(index * SEGMENT_WORDS..)?.first_chunk_mut()
    }

    /// Puts the last one of some segments in the place of another one. What has ended leaves nothing: strokes that are drawn to their ends
    /// have the same words if they are the same.
    fn end(&mut self, index: usize, count: usize) {
        let Some(last) = self.segment(count.saturating_sub(1)) else {
            return;
        };
        let moved = core::mem::take(last);
        if let (Some(room), true) = (self.segment(index), index + 1 < count) {
            *room = moved;
        }
    }

    /// Begins the segments that meet a row, but neither the row `after` nor one above it.
    #[inline(never)]
    fn begin(&mut self, row: i32, after: i32) {
        let (mut count, mut next_scan) = (self.active(), i32::from(i16::MAX));
        let contours = Contours::read(Reader::new(self.contours), 0);
        let offset = contours.offset();
        let Ok(()) = contours.each(|vertices, is_closed| {
            each_segment(vertices, is_closed, |from, to| {
                let (upper, lower) = if from.1 < to.1 { (from, to) } else { (to, from) };
                let [first, last] = [upper, lower].map(|(_, y)| y.saturating_add(offset.y));
                if first > row {
                    next_scan = next_scan.min(first);
                } else if after < first && row <= last {
                    let room = self.segments.get_mut(count * SEGMENT_WORDS..);
                    if let Some(room) = room.and_then(<[u32]>::first_chunk_mut) {
                        *room = segment(
                            upper.0.saturating_add(offset.x),
                            lower.0 - upper.0,
                            first..last + 1,
                            row,
                        );
                        count += 1;
                    } else {
                        debug_assert!(false, "there is room for every segment of a row");
                    }
                }
            });
            Ok::<(), Infallible>(())
        });
        self.set_active(count, next_scan);
    }
}

/// Calls with both ends of each segment of a contour.
#[inline(always)]
fn each_segment(vertices: &[u32], is_closed: bool, mut call: impl FnMut((i32, i32), (i32, i32))) {
    if vertices.is_empty() {
        return;
    }
    let first = vertex_of(vertices, 0);
    let mut from = first;
    for vertex in vertices.chunks_exact(2).skip(1) {
        let to = vertex_of(vertex, 0);
        call(from, to);
        from = to;
    }
    if is_closed {
        call(from, first);
    }
}

/// The segment between an upper end and a lower one, `columns` to the right of it, in a row.
fn segment(column: i32, columns: i32, rows: Range<i32>, row: i32) -> Segment {
    let (height, width) = (rows.end - rows.start - 1, columns.abs());
    let runs_left = columns < 0;
    let [state, steps] = thin_line::cursor(width, height, (height > width, runs_left), row - rows.start);
    let direction = if runs_left { RUNS_LEFT } else { 0 };
    [
        state,
        steps,
        packed(column, width),
        packed(height, rows.end) | direction,
    ]
}

/// Draws the pixels of a segment in a row, and goes on to the next one. Returns whether that is behind its last row.
#[inline(always)]
fn draw_segment<C: BandColor, O: Order>(
    [state, steps, columns, rows]: &mut Segment,
    row: i32,
    word: C::Word,
    band: &mut Band<'_, C, O>,
) -> bool {
    let (column, width) = (i32::from(*columns as i16), (*columns >> 16) as i32);
    let (height, runs_left, end_row) = (
        (*rows & (RUNS_LEFT - 1)) as i32,
        *rows & RUNS_LEFT != 0,
        *rows as i32 >> 16,
    );
    let (above, end) = thin_line::next([state, steps], height.max(1));
    if height > width {
        let column = if runs_left { column - end } else { column + end };
        let left = band.window().left;
        set_pixel(band.words_mut(), column - left, word);
    } else {
        let (start, end) = ((above + 1).max(0), end.min(width) + 1);
        let run = if runs_left {
            (column + 1 - end, column + 1 - start)
        } else {
            (column + start, column + end)
        };
        fill_short_span(band, run, word);
    }
    row + 1 == end_row
}

impl StrokeWords for ThinStroke {
    const OFFSET: usize = HEADER_WORDS;

    fn enter(words: &mut [u32], row: i32) {
        let Some(mut stroke) = Parts::of(words) else { return };
        if !stroke.segments.is_empty() {
            stroke.segments.fill(0);
            stroke.set_active(0, 0);
            stroke.begin(row, i32::MIN);
        }
    }

    #[inline(always)]
    fn draw_row<C: BandColor, O: Order>(words: &mut [u32], extent: Extent, band: &mut Band<'_, C, O>) {
        let Some(mut stroke) = Parts::of(words) else { return };
        let word = C::Word::from_repeated(stroke.header[0]);
        if stroke.segments.is_empty() {
            let Ok(()) = draw_anew(Contours::read(Reader::new(stroke.contours), 0), word, band);
            return;
        }
        let row = band.window().top;
        let (mut index, mut count) = (0, stroke.active());
        while index < count {
            let Some(segment) = stroke.segment(index) else { break };
            if draw_segment(segment, row, word, band) {
                stroke.end(index, count);
                count -= 1;
            } else {
                index += 1;
            }
        }
        let next_scan = stroke.next_scan();
        if row + 1 == i32::from(extent.end) {
            stroke.set_active(count, 0);
        } else {
            stroke.set_active(count, next_scan);
            if row + 1 >= next_scan {
                stroke.begin(row + 1, row);
            }
        }
    }

    fn draw_rows<C: BandColor, O: Order>(words: &mut [u32], extent: Extent, band: &mut Band<'_, C, O>) {
        if Parts::of(words).is_some_and(|stroke| stroke.segments.is_empty()) {
            Self::draw_row(words, extent, band);
            return;
        }
        for row in extent.rows(&band.window()) {
            if let Some(mut band) = band.one_row(row) {
                Self::draw_row(words, extent, &mut band);
            }
        }
    }
}

/// Draws Bresenham's lines along contours into a band of any rows.
fn draw_anew<C: BandColor, O: Order>(
    contours: Contours<'_>,
    word: C::Word,
    band: &mut Band<'_, C, O>,
) -> Result<(), Infallible> {
    let (window, offset) = (band.window(), contours.offset());
    // The rows of the window before the contours were moved; at the ends of the number range a few more.
    let [top, last] = [window.top, window.bottom.saturating_sub(1)].map(|row| row.saturating_sub(offset.y));
    contours.each(|vertices, is_closed| {
        each_segment(vertices, is_closed, |from, to| {
            if from.1.max(to.1) < top || last < from.1.min(to.1) {
                return;
            }
            if let Some(steps) = polyline::segment(from.into(), to.into(), offset, false, &window) {
                let Ok(()) = BatchTarget::draw_steps(band, &steps, word);
            }
        });
        Ok(())
    })
}
