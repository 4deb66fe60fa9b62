//! How far a curve is inside its box, from one row to the next by forward differences.
//!
//! Guarantees: exact for a curve `b dx^2 + a dy^2 < limit`, with additions only; no number is ever larger than one step
//! along x or along y is worth, so that `u32` serves every circle and the ellipses of displays; a row that gains many
//! columns at once is entered afresh, so that no row costs more than its entry.

use core::{
    hint::black_box,
    ops::{Range, Shr},
};

use crate::surface::SymmetricSpan;

/// The numbers of a walk: `u32`, or `u128` for what does not fit.
pub(crate) trait CurveNumber: Copy + PartialOrd + Shr<u32, Output = Self> {
    /// The sum; callers stay in range, or do not use it.
    #[must_use]
    fn plus(self, other: Self) -> Self;
    /// The difference; callers stay in range, or do not use it.
    #[must_use]
    fn minus(self, other: Self) -> Self;
    /// The low 32 bits of the number.
    #[must_use]
    fn narrowed(self) -> u32;
}

macro_rules! curve_number {
    ($($number:ty),+) => {$(
        impl CurveNumber for $number {
            // What leaves the range behind the last row wraps, and is not used.
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }

            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }

            fn narrowed(self) -> u32 {
                self as u32
            }
        }
    )+};
}
curve_number!(u32, u128);

/// A curve in one row of the upper half of its box, and what leads to the next row below.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct ForwardDifference<N> {
    /// Columns of the box before the first pixel of the row.
    pub inset: u32,
    /// What the decision variable still lacks for one column more; at least 1.
    pub error_term: N,
    /// What one column more costs.
    pub column_increment: N,
    /// What each column costs more than the one before.
    pub column_increment_step: N,
    /// What the next row adds to the decision variable.
    pub row_increment: N,
    /// What each row adds less than the one before.
    pub row_increment_step: N,
}

impl<N: CurveNumber> ForwardDifference<N> {
    /// Whether the next row gains so many columns that entering it afresh takes less than a walk. Once a row is not
    /// flat, no row below it is.
    #[inline]
    pub fn is_flat(&self) -> bool {
        self.row_increment >> COLUMNS_WALKED_BITS > self.column_increment
    }

    /// Goes to the next row. Cost: constant for the row, and for each column that is gained.
    ///
    /// The row must not be beyond the middle one, from which on the decision variable shrinks.
    #[inline]
    pub fn advance(&mut self) {
        let mut row_increment = self.row_increment;
        self.row_increment = row_increment.minus(self.row_increment_step);
        while row_increment >= self.error_term {
            row_increment = row_increment.minus(self.error_term);
            // The decision variable never passes more columns than there are up to the middle.
            self.inset -= 1;
            self.column_increment = self.column_increment.plus(self.column_increment_step);
            self.error_term = self.column_increment;
            // Keeps this loop, of one round mostly, from being unrolled: that takes more registers than there are.
            black_box(());
        }
        self.error_term = self.error_term.minus(row_increment);
    }

    /// Writes the inset of the first of the rows that come, and those of the following rows, as many as there are `spans`;
    /// ends at the row after those, unless that is behind the last one.
    #[inline]
    pub(crate) fn walk(
        &mut self,
        rows: Range<u32>,
        enter: impl Fn(u32) -> Self,
        spans: &mut [SymmetricSpan],
        mut write: impl FnMut(&mut SymmetricSpan, u32),
    ) {
        let Some((last, mut others)) = spans.split_last_mut() else {
            return;
        };
        let mut walk = *self;
        // The flat rows come first, and few curves have one.
        let mut row = rows.start;
        while walk.is_flat() {
            let Some((first, rest)) = core::mem::take(&mut others).split_first_mut() else {
                break;
            };
            write(first, walk.inset);
            others = rest;
            row += 1;
            walk = enter(row);
        }
        row += others.len() as u32 + 1;
        for span in others {
            write(span, walk.inset);
            walk.advance();
        }
        write(last, walk.inset);
        if row < rows.end {
            if walk.is_flat() {
                walk = enter(row);
            } else {
                walk.advance();
            }
        }
        *self = walk;
    }
}

/// An integer square root is worth about so many columns.
const COLUMNS_WALKED_BITS: u32 = 4;
