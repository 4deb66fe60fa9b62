//! Which columns of a row silhouettes touch, so that the others need no look when the row is mixed.

use core::ops::Range;

use crate::geometry::leading_zeros;

/// Which columns of a row are touched: a bit for each of them, the first one on top, or in a row of more than 256 a
/// bit for each 2^`shift` of them.
#[derive(Debug, Copy, Clone)]
pub(super) struct Touched {
    words: [u32; Self::WORDS],
    shift: u32,
    is_empty: bool,
}

impl Touched {
    const WORDS: usize = 8;

    /// No column of a row of so many.
    pub(super) fn none(width: usize) -> Self {
        let most_words = width.saturating_sub(1) as u32 / (32 * Self::WORDS as u32);
        let shift = 31 - leading_zeros((2 * most_words) | 1);
        Self {
            words: [0; Self::WORDS],
            shift,
            is_empty: true,
        }
    }

    /// Whether no column is touched.
    #[inline(always)]
    pub(super) fn is_empty(&self) -> bool {
        self.is_empty
    }

    /// Adds the columns from the first to the last.
    #[inline(always)]
    pub(super) fn add(&mut self, [first, last]: [i32; 2]) {
        self.is_empty = false;
        let (bit, more) = (first as u32 % 32, (last - first) as u32);
        if self.shift == 0 && bit + more < 32 {
            self.set(first as usize / 32, (i32::MIN >> (more % 32)) as u32 >> bit);
        } else {
            self.add_many([first, last]);
        }
    }

    /// [`add`](Self::add) for columns whose bits may lie in several words.
    #[inline(never)]
    fn add_many(&mut self, [first, last]: [i32; 2]) {
        let [first, last] = [first, last].map(|column| column as usize >> self.shift);
        let (from_first, up_to_last) = (u32::MAX >> (first % 32), (i32::MIN >> (last % 32)) as u32);
        if first / 32 == last / 32 {
            self.set(last / 32, from_first & up_to_last);
            return;
        }
        self.set(first / 32, from_first);
        for word in first / 32 + 1..last / 32 {
            self.set(word, u32::MAX);
        }
        self.set(last / 32, up_to_last);
    }

    #[inline(always)]
    fn set(&mut self, word: usize, bits: u32) {
        if let Some(word) = self.words.get_mut(word) {
            *word |= bits;
        }
    }

    /// Hands over the touched columns from left to right, as ranges of columns side by side. Where a bit stands for more
    /// than one column, a range also has untouched ones, and may go on past the end of the row.
    #[inline(always)]
    pub(super) fn for_each_run(&self, mut visit: impl FnMut(Range<usize>)) {
        for (word, &bits) in (0..).zip(&self.words) {
            let (mut bits, mut column) = (bits, 32 * word);
            while bits != 0 {
                let before = leading_zeros(bits);
                bits <<= before;
                // At most 31: of 32 columns the last one comes by itself.
                let count = leading_zeros(!bits | 1);
                bits <<= count;
                let first = column + before as usize;
                column = first + count as usize;
                visit(first << self.shift..column << self.shift);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::{collections::BTreeSet, vec::Vec};

    use super::*;

    /// Ranges of columns in rows of all widths, against a set of them.
    #[test]
    fn touched_columns_come_from_left_to_right() {
        for width in [1, 31, 32, 33, 128, 255, 256, 257, 512, 513, 2_000, 8_191] {
            let (mut touched, mut expected) = (Touched::none(width), BTreeSet::new());
            assert!(touched.is_empty);
            for step in 0..40_usize {
                let first = step * step * 37 % width;
                let last = (first + step % 7 * step).min(width - 1);
                touched.add([first, last].map(|column| column as i32));
                expected.extend(first..=last);
                let mut visited = Vec::new();
                touched.for_each_run(|columns| visited.extend(columns));
                assert!(
                    visited.is_sorted_by(|column, next| column < next),
                    "{width}: {visited:?}"
                );
                if width <= 256 {
                    assert!(visited.iter().eq(&expected), "{width}: {visited:?}, not {expected:?}");
                }
                // What is around a column, too, in a block of at most one 256th of the row, rounded up to a power of two.
                let block = width.div_ceil(256).next_power_of_two();
                let blocks = expected.iter().map(|column| column / block).collect::<BTreeSet<_>>();
                assert!(
                    visited.iter().all(|column| blocks.contains(&(column / block))),
                    "{width}"
                );
                let visited = visited.into_iter().collect();
                assert!(expected.is_subset(&visited), "{width}");
            }
            assert!(!touched.is_empty);
        }
    }
}
