//! Buckets by first row: which items begin in which rows.

use core::ops::Range;

use crate::{draw::picture::item::NONE, geometry::Window};

/// The first item of each bucket. A bucket has as many rows, a power of two, as it takes to have one for each row of
/// the picture; the last one has all rows below, too.
#[derive(Debug)]
pub(super) struct Buckets<'m> {
    heads: &'m mut [u16],
    /// First row of the first bucket.
    top: i32,
    /// Rows of a bucket, as a power of two.
    shift: u32,
    /// The rows that have a bucket of their own: not the last one, whose bucket has all rows below, too.
    exact: Range<i32>,
    /// The bucket whose items begin next.
    next: usize,
    /// Its first row, or `i32::MIN` for the first bucket, which has all rows above, too; `i32::MAX` behind the last
    /// one.
    next_row: i32,
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
        let exact = if shift == 0 && used > 0 {
            area.top..area.bottom - 1
        } else {
            0..0
        };
        Self {
            exact,
            heads: heads.get_mut(..used).unwrap_or_default(),
            top: area.top,
            shift,
            next: 0,
            next_row: i32::MAX,
        }
    }

    /// Empties all buckets, for bands from a row on.
    pub(super) fn restart(&mut self, row: i32) {
        self.heads.fill(NONE);
        self.next = self.index(row);
        self.next_row = match self.next {
            _ if self.heads.is_empty() => i32::MAX,
            0 => i32::MIN,
            next => self.top + ((next as i32) << self.shift),
        };
    }

    /// Whether the items of the row's bucket begin in that row, and in no other one.
    #[inline(always)]
    pub(super) fn are_exact_at(&self, row: i32) -> bool {
        self.exact.contains(&row)
    }

    /// The bucket of a row, the nearest one where there is none.
    fn index(&self, row: i32) -> usize {
        let below = i64::from(row) - i64::from(self.top);
        ((below.max(0) >> self.shift) as usize).min(self.heads.len().saturating_sub(1))
    }

    /// The list of the bucket of a row; `None` where there are no buckets.
    pub(super) fn head_of(&mut self, row: i32) -> Option<&mut u16> {
        let index = self.index(row);
        self.heads.get_mut(index)
    }

    /// The list of the next bucket that begins above a row, and on to the one after it.
    #[inline(always)]
    pub(super) fn next_above(&mut self, bottom: i32) -> Option<u16> {
        if self.next_row >= bottom {
            return None;
        }
        let head = *self.heads.get(self.next)?;
        self.next += 1;
        self.next_row = if self.next < self.heads.len() {
            self.top + ((self.next as i32) << self.shift)
        } else {
            i32::MAX
        };
        Some(head)
    }
}
