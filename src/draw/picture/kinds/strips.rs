//! Counts how many parts of an item, as the segments of a stroke, lie in one row of pixels at most: for each strip of some rows.
//!
//! Guarantees: never less than there are, and exact where the item has at most 64 rows. Cost: 128 bytes of stack, and a step for each
//! strip that a part meets.

use core::ops::Range;

/// The number of an item's parts that meet each of up to 64 strips of rows, all of which are as high.
pub(super) struct Strips {
    first: i32,
    height_bits: u32,
    parts: [u16; Self::MOST],
}

impl Strips {
    const MOST: usize = 64;

    /// No parts yet, in some rows.
    pub(super) fn new(rows: Range<i32>) -> Self {
        let height = rows.end.saturating_sub(rows.start);
        Self {
            first: rows.start,
            height_bits: (0..16).find(|bits| (height >> bits) < Self::MOST as i32).unwrap_or(16),
            parts: [0; Self::MOST],
        }
    }

    /// Adds a part that has some of the rows.
    pub(super) fn push(&mut self, rows: Range<i32>) {
        let strip = |row: i32| (row.saturating_sub(self.first) >> self.height_bits) as usize;
        let met = self.parts.get_mut(strip(rows.start)..=strip(rows.end - 1));
        for parts in met.unwrap_or_default() {
            *parts = parts.saturating_add(1);
        }
    }

    /// The most parts in a strip.
    pub(super) fn most(&self) -> usize {
        self.parts.iter().copied().max().unwrap_or(0).into()
    }
}
