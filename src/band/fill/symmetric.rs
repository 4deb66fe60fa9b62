//! The rows of symmetric shapes, straight into the words of a band.
//!
//! Guarantees: one loop a word size serves every colour and every curve; a row and its mirrored row are walked once.

use core::{hint::black_box, num::Wrapping, ops::Range};

use crate::{
    band::{fill::ring::fill_ring, rows::BandRows},
    surface::{PixelWord, SymmetricBox, SymmetricCurve, SymmetricSpan},
};

/// Fills the rows of a symmetric shape, and its hole in another raw colour or not at all.
// Not inlined, like what it calls: where there is one row, the stack has no room for a ring or a batch.
#[inline(never)]
pub(crate) fn fill_symmetric<W: PixelWord>(
    rows: BandRows<'_, W>,
    shape: &SymmetricBox,
    curve: &mut dyn SymmetricCurve,
    raw: W,
    inner_raw: Option<W>,
) {
    match curve.ring() {
        Some(ring) if inner_raw.is_none() => fill_ring(rows, shape, ring, raw),
        _ => fill_batches(rows, shape, curve, raw, inner_raw),
    }
}

/// Fills the rows of a symmetric shape, batch by batch.
#[inline(never)]
fn fill_batches<W: PixelWord>(
    rows: BandRows<'_, W>,
    shape: &SymmetricBox,
    curve: &mut dyn SymmetricCurve,
    raw: W,
    inner_raw: Option<W>,
) {
    let mut halves = Halves {
        columns: Columns {
            first: shape.columns.start,
            end: shape.columns.end,
            width: shape.size.width,
            left: Wrapping(shape.left() as u32) - Wrapping(rows.window.left as u32),
        },
        rows,
        shape,
    };
    // Not known to be zeros, which the compiler would write through the generic `memclr`, at several times the cost.
    let mut batch = [black_box(SymmetricSpan::default()); SymmetricBox::BATCH];
    let mut rows = shape.rows.clone();
    while !rows.is_empty() {
        let count = rows.len().min(batch.len());
        let Some(spans) = batch.get_mut(..count) else { return };
        curve.next_rows(spans);
        halves.paint(rows.start, spans, raw, inner_raw);
        rows.start += count as u32;
    }
}

/// The upper half of a shape and the lower one.
struct Halves<'a, W> {
    rows: BandRows<'a, W>,
    shape: &'a SymmetricBox,
    columns: Columns,
}

/// Rows of one half, from the outside to the middle.
struct HalfRows<'a, W> {
    words: &'a mut [W],
    stride: usize,
    /// Index of the first row in the words.
    start: Wrapping<usize>,
    /// Difference between the index of a row and that of the next one, modulo `usize`.
    step: Wrapping<usize>,
}

/// Fills rows of one half, as many as there are spans.
type FillHalf<W> = fn(HalfRows<'_, W>, &[SymmetricSpan], &Columns, W);

impl<W: PixelWord> Halves<'_, W> {
    /// Paints rows of the upper half from the given one on, and their mirrored rows. Writes over the spans.
    fn paint(&mut self, row: u32, spans: &mut [SymmetricSpan], raw: W, inner_raw: Option<W>) {
        let whole = count_while(spans, |span| span.inner == SymmetricSpan::NO_INNER);
        let (whole, holed) = spans.split_at_mut_checked(whole).unwrap_or_default();
        self.columns.set_spans(whole, |span| span.outer);
        self.fill(row, whole, fill_spans, raw);
        if holed.is_empty() {
            return;
        }
        let row = row + whole.len() as u32;
        // Sides become shorter towards the middle.
        let is_long = |span: &SymmetricSpan| span.inner - span.outer > SHORT;
        let long = if self.columns.width < 1 << 31 {
            count_while(holed, is_long)
        } else {
            holed.len()
        };
        let (long, short) = holed.split_at_checked(long).unwrap_or_default();
        self.fill(row, long, fill_long_sides, raw);
        self.fill(row + long.len() as u32, short, fill_short_sides, raw);
        if let Some(raw) = inner_raw {
            self.columns.set_spans(holed, |span| span.inner);
            self.fill(row, holed, fill_spans, raw);
        }
    }

    /// Fills the visible rows of either half.
    fn fill(&mut self, row: u32, spans: &[SymmetricSpan], fill_half: FillHalf<W>, raw: W) {
        let BandRows { words, window, stride } = &mut self.rows;
        let stride = *stride;
        let end = row + spans.len() as u32;
        for (visible, is_lower) in [(&self.shape.upper, false), (&self.shape.lower, true)] {
            let visible = visible.start.max(row)..visible.end.min(end);
            if visible.is_empty() {
                continue;
            }
            let first = visible.start;
            let (line, step) = if is_lower {
                let line = SymmetricBox::mirrored(first, self.shape.size.height);
                (line, -Wrapping(stride))
            } else {
                (first, Wrapping(stride))
            };
            // Up to 2^32 - 1.
            let below_top = Wrapping(self.shape.y(line) as u32) - Wrapping(window.top as u32);
            let rows = HalfRows {
                words,
                stride,
                start: Wrapping(below_top.0 as usize * stride),
                step,
            };
            if let Some(spans) = spans.get((first - row) as usize..(visible.end - row) as usize) {
                fill_half(rows, spans, &self.columns, raw);
            }
        }
    }
}

/// The number of spans at the start of `spans` for which `is_such` holds: the index of the first span for which it does not.
fn count_while(spans: &[SymmetricSpan], is_such: impl Fn(&SymmetricSpan) -> bool) -> usize {
    // Mostly all of them.
    if spans.last().is_some_and(&is_such) {
        return spans.len();
    }
    spans.iter().position(|span| !is_such(span)).unwrap_or(spans.len())
}

/// The columns of a shape's box: which are visible, how many there are, and where in a row they begin.
struct Columns {
    first: u32,
    end: u32,
    width: u32,
    /// Difference between a column of the box and its index in a row, modulo 2^32.
    left: Wrapping<u32>,
}

impl Columns {
    /// Turns symmetric spans into visible ones, from an inset on the left to the same on the right: `outer` becomes the
    /// column where the visible span begins, `inner` the one where it ends.
    fn set_spans(&self, spans: &mut [SymmetricSpan], inset: impl Fn(&SymmetricSpan) -> u32) {
        for span in spans {
            let inset = inset(span);
            let visible = self.visible(inset..self.width - inset);
            *span = SymmetricSpan {
                outer: visible.start,
                inner: visible.end,
            };
        }
    }

    /// The indices of those columns that are visible.
    #[inline(always)]
    fn visible(&self, columns: Range<u32>) -> Range<u32> {
        let Range { mut start, mut end } = columns;
        // Often all columns are visible: a branch takes less than four limits.
        if start < self.first || end > self.end {
            // Keeps the compiler from computing the limits in any case.
            black_box(());
            start = start.max(self.first).min(self.end);
            end = end.max(self.first).min(self.end);
        }
        (Wrapping(start) + self.left).0..(Wrapping(end) + self.left).0
    }
}

/// Fills the visible spans that symmetric ones were turned into.
#[inline(never)]
fn fill_spans<W: PixelWord>(rows: HalfRows<'_, W>, spans: &[SymmetricSpan], _: &Columns, raw: W) {
    let HalfRows {
        words, mut start, step, ..
    } = rows;
    let repeated = raw.repeated();
    for span in spans {
        let (first, end) = (span.outer as usize, span.inner as usize);
        if let Some(words) = words.get_mut(start.0 + first..start.0 + end) {
            W::fill_repeated(words, repeated);
        }
        start += step;
    }
}

/// Fills the pixels on both sides of the hole, column by column; a column that is not visible has an index beyond the
/// row.
///
/// Boxes of 2^31 columns and more are drawn otherwise: there the index of a column that is not visible may be the one of a
/// visible column.
#[inline(never)]
fn fill_short_sides<W: PixelWord>(rows: HalfRows<'_, W>, spans: &[SymmetricSpan], columns: &Columns, raw: W) {
    let HalfRows {
        words,
        stride,
        mut start,
        step,
    } = rows;
    let right = columns.left + Wrapping(columns.width);
    let mut spans = spans.iter();
    let mut row: &mut [W] = &mut [];
    let (mut column, mut end, mut mirrored) = (Wrapping(0), Wrapping(0), Wrapping(0));
    // One loop, not one in the other, of one round mostly: the compiler would prepare it for many.
    loop {
        if column == end {
            let Some(span) = spans.next() else { return };
            let Some(next) = words.get_mut(start.0..start.0 + stride) else {
                return;
            };
            row = next;
            start += step;
            column = columns.left + Wrapping(span.outer);
            end = columns.left + Wrapping(span.inner);
            mirrored = right - Wrapping(span.outer);
        } else {
            mirrored -= 1;
            for index in [column, mirrored] {
                if let Some(word) = row.get_mut(index.0 as usize) {
                    *word = raw;
                }
            }
            column += 1;
        }
        black_box(());
    }
}

/// Fills the pixels on both sides of the hole, a run on each side.
#[inline(never)]
fn fill_long_sides<W: PixelWord>(rows: HalfRows<'_, W>, spans: &[SymmetricSpan], columns: &Columns, raw: W) {
    let HalfRows {
        words, mut start, step, ..
    } = rows;
    let width = columns.width;
    for span in spans {
        let left = columns.visible(span.outer..span.inner);
        let right = columns.visible(width - span.inner..width - span.outer);
        for side in [left, right] {
            let (first, end) = (side.start as usize, side.end as usize);
            if let Some(words) = words.get_mut(start.0 + first..start.0 + end) {
                W::fill(words, raw);
            }
        }
        start += step;
    }
}

/// The most columns that a short side has.
const SHORT: u32 = 8;
