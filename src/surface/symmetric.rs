//! Shapes that are symmetric about their middle row and their middle column: which of their rows and columns are
//! visible.
//!
//! Guarantees: each visible row once; positions inside the box are `u32` wherever the box is, so that nothing overflows.

use core::ops::Range;

use embedded_graphics::geometry::Size;

use crate::{
    geometry::{WideRectangle, Window},
    surface::Ring,
};

/// The box of a symmetric shape, and its visible rows and columns, counted from its top left corner. Only this crate
/// makes one, for the window of the target that is drawn on.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SymmetricBox {
    /// Columns and rows of the box.
    pub(crate) size: Size,
    /// Columns that are visible; at least 1.
    pub(crate) columns: Range<u32>,
    /// Rows of the upper half that are visible, the middle row included.
    pub(crate) upper: Range<u32>,
    /// Rows of the upper half whose mirrored row is visible, without the middle row.
    pub(crate) lower: Range<u32>,
    /// Rows of the upper half that are to be drawn: those that are visible, or whose mirrored row is.
    pub(crate) rows: Range<u32>,
    /// Position of the box modulo 2^32: whatever is visible has exact coordinates again.
    left: i32,
    top: i32,
}

/// Where a shape begins and ends in a row and in its mirrored row, in columns of its box.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SymmetricSpan {
    /// Columns before the first pixel, and after the last one. At most half of the columns of the box.
    pub outer: u32,
    /// Columns before the hole, and after it: at least `outer`, at most half of the columns of the box;
    /// [`SymmetricSpan::NO_INNER`] without one.
    pub inner: u32,
}

impl SymmetricSpan {
    /// The row has no hole.
    pub const NO_INNER: u32 = u32::MAX;
}

/// A curve that is walked row by row, from the outside to the middle.
///
/// Rows are asked for in batches, so that walking and drawing are two short loops that keep their numbers in registers.
pub trait SymmetricCurve {
    /// Writes the spans of the rows that come next. Never asked for more rows than there are.
    fn next_rows(&mut self, spans: &mut [SymmetricSpan]);

    /// The ring in the row that comes next, if the curve is a ring and all its sides are short.
    #[doc(hidden)]
    fn ring(&self) -> Option<Ring> {
        None
    }
}

impl SymmetricBox {
    /// Rows in a batch: 8 bytes of stack each.
    pub const BATCH: usize = 32;

    /// The box of a shape and its part inside a window; `None` where no pixel of the box is visible.
    pub(crate) fn new(bounding_box: WideRectangle, window: &Window) -> Option<Self> {
        if window.is_empty() {
            return None;
        }
        let Size { width, height } = bounding_box.size;
        let columns = visible(bounding_box.left, width, window.left, window.right);
        let rows = visible(bounding_box.top, height, window.top, window.bottom);
        if columns.is_empty() || rows.is_empty() {
            return None;
        }
        let (half, other_half) = (height - height / 2, height / 2);
        let upper = rows.start..rows.end.min(half);
        let lower = height - rows.end..(height - rows.start).min(other_half);
        // A window is in one piece: where it has rows of both halves, both ranges end at the middle.
        let rows = if upper.is_empty() {
            lower.clone()
        } else if lower.is_empty() {
            upper.clone()
        } else {
            upper.start.min(lower.start)..upper.end
        };
        Some(Self {
            size: bounding_box.size,
            columns,
            upper,
            lower,
            rows,
            left: bounding_box.left as i32,
            top: bounding_box.top as i32,
        })
    }

    /// Calls `draw` with the number of a row and the spans of the rows from there on, until all rows are done.
    pub fn for_each_batch<E>(
        &self,
        curve: &mut dyn SymmetricCurve,
        mut draw: impl FnMut(u32, &[SymmetricSpan]) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut batch = [SymmetricSpan::default(); Self::BATCH];
        let mut rows = self.rows.clone();
        while !rows.is_empty() {
            let count = Self::BATCH.min(rows.len());
            if let Some(spans) = batch.get_mut(..count) {
                curve.next_rows(spans);
                draw(rows.start, spans)?;
            }
            rows.start += count as u32;
        }
        Ok(())
    }

    /// Converts a column of the box to one of the picture, clamped to the visible columns and the one after them.
    pub fn x(&self, column: u32) -> i32 {
        let column = column.max(self.columns.start).min(self.columns.end);
        // `left` is modulo 2^32, and visible columns have coordinates again.
        self.left.wrapping_add_unsigned(column)
    }

    /// The picture's column of the first column of the box, modulo 2^32.
    pub const fn left(&self) -> i32 {
        self.left
    }

    /// Converts a visible row of the box to one of the picture.
    pub const fn y(&self, row: u32) -> i32 {
        // `top` is modulo 2^32, and visible rows have coordinates again.
        self.top.wrapping_add_unsigned(row)
    }

    /// The mirror image of a column or row, in a box of `length` columns or rows.
    pub const fn mirrored(index: u32, length: u32) -> u32 {
        length - 1 - index
    }

    /// The picture's rows that a row of the upper half stands for: itself and its mirrored row, where they are visible.
    pub fn lines(&self, row: u32) -> [Option<i32>; 2] {
        let mirrored = Self::mirrored(row, self.size.height);
        [
            self.upper.contains(&row).then(|| self.y(row)),
            self.lower.contains(&row).then(|| self.y(mirrored)),
        ]
    }

    /// The columns where a row begins, where its hole begins and ends, and where the row ends, each clipped. Without a
    /// hole the row ends where its hole begins.
    pub fn bounds(&self, span: SymmetricSpan) -> [i32; 4] {
        let width = self.size.width;
        let end = self.x(width - span.outer);
        let start = self.x(span.outer).min(end);
        if span.inner == SymmetricSpan::NO_INNER {
            return [start, end, end, end];
        }
        [start, self.x(span.inner), self.x(width - span.inner), end]
    }
}

/// The part of `start..start + length` between `from` and `to`, counted from `start`.
fn visible(start: i64, length: u32, from: i32, to: i32) -> Range<u32> {
    let clamp = |position: i32| (i64::from(position) - start).clamp(0, i64::from(length)) as u32;
    clamp(from)..clamp(to)
}
