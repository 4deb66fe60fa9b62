//! The ring between two circles about one centre, from row to row by forward differences.
//!
//! Guarantees: the pixels of two circles that are walked one by one. The state is small enough for the registers,
//! because the increment of a row depends only on its distance from the centre, and that of a column only on the
//! column.

use core::num::Wrapping;

/// The state of a walk down a ring, through the rows of the upper half of its box; it begins above the first row.
///
/// Columns may be counted from anywhere, modulo 2^32.
///
/// Only this crate makes rings: drawing one trusts that its hole begins right of its outer edge in each row down to the
/// middle, as it does between a circle and a smaller one in its middle.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ring {
    /// The outer circle: where the row begins.
    pub(crate) outer: RingEdge,
    /// The inner circle: where the hole of the row begins, at least one column later; right of the middle in a row
    /// without a hole.
    pub(crate) inner: RingEdge,
    /// The sum of a column and its mirrored column, and 1.
    pub(crate) sum: Wrapping<u32>,
    /// What the next row adds to the decision variables of both circles.
    pub(crate) row_increment: Wrapping<u32>,
}

/// Where one of the two circles of a ring begins in a row.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RingEdge {
    /// The first column.
    pub(crate) column: Wrapping<u32>,
    /// What the decision variable still lacks for the column before that one, less 1.
    pub(crate) error_term: u32,
}

impl Ring {
    /// The ring with its columns counted from an origin that lies `by` columns further to the left.
    #[must_use]
    pub fn shifted(mut self, by: u32) -> Self {
        self.outer.column += by;
        self.inner.column += by;
        self.sum += Wrapping(by) * Wrapping(2);
        self
    }

    /// Goes to the next row, which is not below the middle row. Cost: constant for the row, and for each column gained.
    #[inline(always)]
    pub fn advance(&mut self) {
        self.outer.advance(self.row_increment, self.sum);
        self.inner.advance(self.row_increment, self.sum);
        self.row_increment -= 2;
    }
}

impl RingEdge {
    #[inline(always)]
    fn advance(&mut self, row_increment: Wrapping<u32>, sum: Wrapping<u32>) {
        // Below 0 the error term has carried: columns are passed until it is positive again.
        let (error_term, mut is_short) = self.error_term.overflowing_sub(row_increment.0);
        self.error_term = error_term;
        while is_short {
            self.column -= 1;
            let column_increment = sum - self.column * Wrapping(2);
            let (error_term, is_paid) = self.error_term.overflowing_add(column_increment.0);
            self.error_term = error_term;
            is_short = !is_paid;
        }
    }
}
