//! Buckets by first row: which items begin in which rows.

use core::{hint::black_box, num::Wrapping, ops::Range};

use crate::{
    draw::picture::item::NONE,
    geometry::{Window, distance},
};

/// The first item of each bucket. A bucket has as many rows, a power of two, as it takes to have one for each row of
/// the picture; the first one has all rows above, too, and the last one all rows below.
#[derive(Debug)]
pub(super) struct Buckets<'m> {
    heads: &'m mut [u16],
    /// First row of the first bucket.
    top: i32,
    /// Rows of a bucket, as a power of two.
    shift: u32,
    /// How many buckets behind the first one have one row; 0 where all have several.
    exact: u32,
}

/// All columns of the rows from -32,768 to 32,766, in which a picture's items lie.
const ROWS_OF_ITEMS: Window = Window {
    left: i32::MIN,
    top: i16::MIN as i32,
    right: i32::MAX,
    bottom: i16::MAX as i32,
};

impl<'m> Buckets<'m> {
    /// Buckets for the rows of an area from -32,768 to 32,766: items have no others, and no bucket's first row overflows.
    /// There are none where there is no memory for one, or no such row.
    pub(super) fn new(area: &Window, heads: &'m mut [u16]) -> Self {
        let area = area.intersection(&ROWS_OF_ITEMS);
        let rows = area.height() as usize;
        let used = heads.len().min(rows);
        let mut shift = 0;
        while (rows >> shift) > used {
            shift += 1;
        }
        let exact = if shift == 0 { used.saturating_sub(2) as u32 } else { 0 };
        Self {
            exact,
            heads: heads.get_mut(..used).unwrap_or_default(),
            top: area.top,
            shift,
        }
    }

    /// Empties all buckets.
    pub(super) fn empty(&mut self) {
        self.heads.fill(NONE);
    }

    /// The list of the items that begin in a row; `None` where the row has no bucket of its own. For rows that lie
    /// below rows of which all buckets are open.
    #[inline]
    pub(super) fn of_one_row(&self, row: i32) -> Option<u16> {
        // As unsigned numbers, rows above the first one are beyond the last one.
        let index = (Wrapping(row) - Wrapping(self.top)).0 as u32;
        if (Wrapping(index) - Wrapping(1)).0 < self.exact {
            self.heads.get(index as usize).copied()
        } else {
            None
        }
    }

    /// The first row below one, and not below `end`, in which items begin, or which has no bucket of its own.
    pub(super) fn next_begin(&self, row: i32, end: i32) -> i32 {
        let index = |row: i32| (Wrapping(row) - Wrapping(self.top)).0 as u32;
        let mut next = row + 1;
        let (mut bucket, end) = (index(next), index(end).min(self.exact + 1));
        while bucket < end && self.heads.get(bucket as usize) == Some(&NONE) {
            next += 1;
            bucket += 1;
            // The compiler would unroll this loop.
            black_box(());
        }
        next
    }

    /// The list of a bucket.
    pub(super) fn list(&self, index: usize) -> Option<u16> {
        self.heads.get(index).copied()
    }

    /// The buckets of the items that begin in some rows, but for those that the rows above have opened; for the first
    /// rows of a walk none are.
    pub(super) fn opened_by(&self, rows: Range<i32>, is_first: bool) -> Range<usize> {
        if self.heads.is_empty() {
            return 0..0;
        }
        let start = if is_first {
            self.index(rows.start)
        } else {
            self.index(rows.start - 1) + 1
        };
        start..self.index(rows.end - 1) + 1
    }

    /// The bucket of a row, the nearest one where there is none.
    fn index(&self, row: i32) -> usize {
        let below = if row > self.top { distance(self.top, row) } else { 0 };
        ((below >> self.shift) as usize).min(self.heads.len().saturating_sub(1))
    }

    /// The list of the bucket of a row; `None` where there are no buckets.
    pub(super) fn head_of(&mut self, row: i32) -> Option<&mut u16> {
        let index = self.index(row);
        self.heads.get_mut(index)
    }
}
