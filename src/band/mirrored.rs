//! The rows of symmetric shapes, straight into the words of a band.
//!
//! Promises: one loop a word size serves every colour and every curve; a row and its mirrored row share what they can.

use core::{hint::black_box, ops::Range};

use crate::{
    geometry::Window,
    target::{Insets, MirroredBox, MirroredCurve, PixelWord},
};

/// The words of a band and where they lie.
pub(super) struct Rows<'a, W> {
    pub words: &'a mut [W],
    pub window: Window,
    pub stride: usize,
}

/// Fills the rows of a symmetric shape, and its hole in another ink or not at all.
// Not inlined: where there is one row, the stack has no room for the batch.
#[inline(never)]
pub(super) fn fill_mirrored<W: PixelWord>(
    rows: Rows<'_, W>,
    shape: &MirroredBox,
    curve: &mut dyn MirroredCurve,
    ink: W,
    hole_ink: Option<W>,
) {
    let Rows { words, window, stride } = rows;
    // A band without columns shows nothing.
    let stride = stride.max(1);
    let columns = Columns {
        first: shape.columns.start,
        end: shape.columns.end,
        width: shape.size.width,
        left: shape.left().wrapping_sub(window.left) as u32,
    };
    let brush = Brush { columns, ink, hole_ink };
    // Rows that are visible on both sides of the middle; before them one side is visible, after them the middle row.
    let pairs_start = shape
        .upper
        .start
        .max(shape.lower.start)
        .clamp(shape.rows.start, shape.rows.end);
    let pairs_end = shape.upper.end.min(shape.lower.end).max(pairs_start);
    // Not known to be zeros, which the compiler would write through the generic `memclr`, at several times the cost.
    let mut batch = [black_box(Insets::default()); MirroredBox::BATCH];
    for rows in [
        shape.rows.start..pairs_start,
        pairs_start..pairs_end,
        pairs_end..shape.rows.end,
    ] {
        if rows.is_empty() {
            continue;
        }
        let mut remaining = rows.len();
        let mut stripes = Stripes::of(words, &window, stride, shape, rows);
        while remaining > 0 {
            let count = remaining.min(batch.len());
            let Some(insets) = batch.get_mut(..count) else { return };
            curve.next_rows(insets);
            let (these, later) = stripes.split(count);
            brush.paint(these, insets);
            stripes = later;
            remaining = remaining.wrapping_sub(count);
        }
    }
}

/// Rows above the middle from top to bottom, and the same rows below it from bottom to top; either may be missing.
struct Stripes<'a, W> {
    above: &'a mut [W],
    below: &'a mut [W],
    stride: usize,
}

/// Calls a function with the rows from the outside to the middle, alone or in pairs.
macro_rules! with_rows {
    ($stripes:expr, $function:ident($($argument:expr),+)) => {{
        let Stripes { above, below, stride } = $stripes;
        if below.is_empty() {
            $function(above.chunks_exact_mut(stride).map(|row| [row]), $($argument),+);
        } else if above.is_empty() {
            $function(below.rchunks_exact_mut(stride).map(|row| [row]), $($argument),+);
        } else {
            let pairs = above.chunks_exact_mut(stride).zip(below.rchunks_exact_mut(stride));
            $function(pairs.map(|(above, below)| [above, below]), $($argument),+);
        }
    }};
}

impl<'a, W> Stripes<'a, W> {
    /// The words of rows of the upper half, and of their mirrored rows: each where the first of them is visible.
    fn of(words: &'a mut [W], window: &Window, stride: usize, shape: &MirroredBox, rows: Range<u32>) -> Self {
        let line = |row: u32| (shape.y(row).wrapping_sub(window.top) as usize).wrapping_mul(stride);
        let length = stride.wrapping_mul(rows.len());
        let (mut above, mut below): (&mut [W], &mut [W]) = (words, &mut []);
        if shape.lower.contains(&rows.start) {
            // The mirrored row of the first row is the last one.
            let end = line(MirroredBox::mirrored(rows.start, shape.size.height)).wrapping_add(stride);
            let (before, rest) = above.split_at_mut_checked(end.wrapping_sub(length)).unwrap_or_default();
            above = before;
            below = rest.get_mut(..length).unwrap_or_default();
        }
        if shape.upper.contains(&rows.start) {
            let start = line(rows.start);
            above = above.get_mut(start..start.wrapping_add(length)).unwrap_or_default();
        } else {
            above = &mut [];
        }
        Self { above, below, stride }
    }

    /// The first rows, and the others.
    fn split(self, rows: usize) -> (Self, Self) {
        let Self { above, below, stride } = self;
        let length = stride.wrapping_mul(rows);
        let (first_above, above) = above.split_at_mut_checked(length).unwrap_or_default();
        let kept = below.len().saturating_sub(length);
        let (below, first_below) = below.split_at_mut_checked(kept).unwrap_or_default();
        let first = Stripes {
            above: first_above,
            below: first_below,
            stride,
        };
        (first, Stripes { above, below, stride })
    }

    fn reborrow(&mut self) -> Stripes<'_, W> {
        Stripes {
            above: self.above,
            below: self.below,
            stride: self.stride,
        }
    }
}

/// The colours of a shape.
struct Brush<W> {
    columns: Columns,
    ink: W,
    hole_ink: Option<W>,
}

impl<W: PixelWord> Brush<W> {
    fn paint(&self, stripes: Stripes<'_, W>, insets: &[Insets]) {
        let whole = count_while(insets, |insets| insets.hole == Insets::NO_HOLE);
        let (whole, holed) = insets.split_at_checked(whole).unwrap_or_default();
        let (whole_stripes, stripes) = stripes.split(whole.len());
        if !whole.is_empty() {
            with_rows!(
                whole_stripes,
                fill_rows(whole.iter().map(|insets| insets.outer), self.columns, self.ink)
            );
        }
        if !holed.is_empty() {
            self.paint_holed(stripes, holed);
        }
    }

    fn paint_holed(&self, mut stripes: Stripes<'_, W>, insets: &[Insets]) {
        // Sides become shorter towards the middle.
        let is_long = |insets: &Insets| insets.hole.wrapping_sub(insets.outer) > SHORT;
        let long = if self.columns.width < 1 << 31 {
            count_while(insets, is_long)
        } else {
            insets.len()
        };
        let (long, short) = insets.split_at_checked(long).unwrap_or_default();
        let (long_stripes, short_stripes) = stripes.reborrow().split(long.len());
        if !long.is_empty() {
            with_rows!(long_stripes, fill_long_sides(long, self.columns, self.ink));
        }
        if !short.is_empty() {
            with_rows!(short_stripes, fill_short_sides(short, self.columns, self.ink));
        }
        if let Some(ink) = self.hole_ink {
            with_rows!(
                stripes,
                fill_rows(insets.iter().map(|insets| insets.hole), self.columns, ink)
            );
        }
    }
}

/// How many insets there are before the first one that is not such.
fn count_while(insets: &[Insets], is_such: impl Fn(&Insets) -> bool) -> usize {
    // Mostly all of them.
    if insets.last().is_some_and(&is_such) {
        return insets.len();
    }
    insets
        .iter()
        .position(|insets| !is_such(insets))
        .unwrap_or(insets.len())
}

/// The columns of a shape's box: which are visible, how many there are, and where in a row they begin.
#[derive(Copy, Clone)]
struct Columns {
    first: u32,
    end: u32,
    width: u32,
    /// What leads from a column of the box to its place in a row, modulo 2^32.
    left: u32,
}

impl Columns {
    /// The places of those columns that are visible.
    fn visible(&self, columns: Range<u32>) -> Range<usize> {
        if self.first == 0 && self.end == self.width {
            // All columns are visible.
            let place = |column: u32| column.wrapping_add(self.left) as usize;
            return place(columns.start)..place(columns.end);
        }
        let place = |column: u32| column.max(self.first).min(self.end).wrapping_add(self.left) as usize;
        place(columns.start)..place(columns.end)
    }
}

/// Fills rows from side to side.
#[inline(never)]
fn fill_rows<'a, W: PixelWord, const N: usize>(
    rows: impl Iterator<Item = [&'a mut [W]; N]>,
    insets: impl Iterator<Item = u32>,
    columns: Columns,
    ink: W,
) {
    for (rows, inset) in rows.zip(insets) {
        let span = columns.visible(inset..columns.width.wrapping_sub(inset));
        for row in rows {
            if let Some(words) = row.get_mut(span.clone()) {
                W::fill(words, ink);
            }
        }
    }
}

/// Fills what lies on both sides of the hole, column by column: what is not visible is beyond the row.
///
/// Not for boxes of 2^31 columns and more, where the place of a column that is not visible may be that of one that is.
#[inline(never)]
fn fill_short_sides<'a, W: PixelWord, const N: usize>(
    rows: impl Iterator<Item = [&'a mut [W]; N]>,
    insets: &[Insets],
    columns: Columns,
    ink: W,
) {
    let right = columns.left.wrapping_add(columns.width).wrapping_sub(1);
    for (mut rows, insets) in rows.zip(insets) {
        for column in insets.outer..insets.hole {
            for row in &mut rows {
                if let Some(word) = row.get_mut(columns.left.wrapping_add(column) as usize) {
                    *word = ink;
                }
                if let Some(word) = row.get_mut(right.wrapping_sub(column) as usize) {
                    *word = ink;
                }
            }
            // Keeps this loop, of one round mostly, from being unrolled: that takes more registers than there are.
            black_box(());
        }
    }
}

/// Fills what lies on both sides of the hole.
#[inline(never)]
fn fill_long_sides<'a, W: PixelWord, const N: usize>(
    rows: impl Iterator<Item = [&'a mut [W]; N]>,
    insets: &[Insets],
    columns: Columns,
    ink: W,
) {
    let width = columns.width;
    for (rows, insets) in rows.zip(insets) {
        let left = columns.visible(insets.outer..insets.hole);
        let right = columns.visible(width.wrapping_sub(insets.hole)..width.wrapping_sub(insets.outer));
        for row in rows {
            for side in [left.clone(), right.clone()] {
                if let Some(words) = row.get_mut(side) {
                    W::fill(words, ink);
                }
            }
        }
    }
}

/// Sides of at most so many columns are short.
const SHORT: u32 = 8;
