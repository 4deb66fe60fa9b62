//! A row of a circle or an ellipse in a picture, stepped from the row above by forward differences.
//!
//! With doubled distances x and y from the middle, a pixel is inside while `b x^2 + a y^2 < limit`. The slack of a row is the
//! largest number by which the sum may fall without one more column on each side being inside. In the next row nearer to the
//! middle, the sum is smaller by the row's increment: where that exceeds the slack, new columns pay for it, each of which raises
//! the sum by its own increment. In the next row further away the sum is larger by the row's increment, and columns are given up:
//!
//! ```text
//!   upper half:  slack -= row's;  while slack < 0: one column more, slack += its increment
//!   lower half:  slack += row's;  while slack >= the last column's increment: slack -= that, one column less
//! ```
//!
//! The increment of a row is a times the doubled distance between the middle and the row's upper edge, that of a column b times
//! the number of columns. A row is kept as what leads to it from above, so that its columns are the ones that are drawn, and no
//! others have to be kept meanwhile.

use core::{hint::black_box, num::Wrapping};

/// A row of a curve: the columns that are inside, and the slack up to the columns beside them.
#[derive(Clone, Copy)]
pub(super) struct CurveRow {
    /// First column.
    pub(super) start: i32,
    /// The column after the last one.
    pub(super) end: i32,
    /// By how much the sum of squares may fall without one more column on each side being inside.
    pub(super) slack: u32,
}

impl CurveRow {
    /// The row as two words: the first one has both columns, 16 bits each.
    #[inline]
    pub(super) const fn words(self) -> [u32; 2] {
        [(self.start as u32 & 0xffff) | (self.end as u32) << 16, self.slack]
    }

    #[inline]
    pub(super) const fn of([columns, slack]: [u32; 2]) -> Self {
        Self {
            start: columns as i16 as i32,
            end: columns as i32 >> 16,
            slack,
        }
    }

    /// First column, and the one after the last.
    #[inline]
    pub(super) const fn columns(self) -> (i32, i32) {
        (self.start, self.end)
    }

    /// Columns that are inside.
    #[inline]
    pub(super) const fn width(self) -> u32 {
        (self.end - self.start) as u32
    }

    /// What [`next`](Self::next) takes for the row above, to get this row: the same columns and a slack from which the row's
    /// increment leads to this one. `edge` is twice the distance of this row's upper edge below the middle.
    pub(super) fn above(self, edge: i32, row_unit: u32) -> Self {
        let slack = Wrapping(self.slack) - Wrapping(edge as u32) * Wrapping(row_unit);
        Self { slack: slack.0, ..self }
    }

    /// The row below this one, whose upper edge is half of `edge` below the middle.
    #[inline(always)]
    pub(super) fn next(self, edge: i32, (column_unit, row_unit): (u32, u32)) -> Self {
        if edge < 0 {
            self.wider(edge.unsigned_abs() * row_unit, column_unit)
        } else {
            let slack = Wrapping(self.slack) + Wrapping(edge as u32) * Wrapping(row_unit);
            Self { slack: slack.0, ..self }.narrower(column_unit)
        }
    }

    /// The row below this one in the upper half, by the row's increment.
    #[inline(always)]
    pub(super) fn wider(mut self, row_increment: u32, column_unit: u32) -> Self {
        // That of the next column. Behind the last one of the curve it may wrap around, and is not used.
        let mut column_increment = Wrapping(self.width() + 2) * Wrapping(column_unit);
        let mut is_negative;
        (self.slack, is_negative) = self.slack.overflowing_sub(row_increment);
        while is_negative {
            self.start -= 1;
            self.end += 1;
            let is_positive;
            (self.slack, is_positive) = self.slack.overflowing_add(column_increment.0);
            is_negative = !is_positive;
            column_increment += 2 * column_unit;
            // Keeps the compiler from unrolling this loop, which mostly runs once.
            black_box(());
        }
        self
    }

    /// The row below this one in the lower half, whose increment is in the slack already.
    #[inline(always)]
    pub(super) fn narrower(mut self, column_unit: u32) -> Self {
        // A row of the curve keeps a column: the increment stays above 0.
        let mut column_increment = self.width() * column_unit;
        while let Some(slack) = self.slack.checked_sub(column_increment) {
            self.slack = slack;
            column_increment -= 2 * column_unit;
            self.start += 1;
            self.end -= 1;
            black_box(());
        }
        self
    }
}
