//! An edge on its way from row to row, without its ends: where it crosses a row, and what the next row adds.
//!
//! Guarantees: the crossings of [`Edge`](crate::scan::polygon::Edge). Cost of a row: two additions, and a third one where the error
//! term carries.

use core::num::Wrapping;

/// Column and error term of an edge in a row, and what each row adds to both.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct EdgeWalk {
    /// First pixel whose centre is on the edge or right of it.
    pub(super) x: Wrapping<i32>,
    /// Error term, less the edge's height, modulo 2^32: adding to it overflows when a column more is due.
    pub(super) error: Wrapping<u32>,
    /// Columns from row to row, rounded down.
    pub(super) step: Wrapping<i32>,
    /// Remainder of `step`, in columns / `height`.
    pub(super) error_step: u32,
    /// Height of the edge in units of its vertices.
    pub(super) height: Wrapping<u32>,
}

impl EdgeWalk {
    /// Words of a walk.
    pub(crate) const WORDS: usize = 5;

    /// First pixel of the row whose centre is on the edge or right of it.
    #[inline(always)]
    pub(crate) const fn x(&self) -> i32 {
        self.x.0
    }

    /// Goes on to the next row. Below the edge's last row, x may leave the number range, and wraps.
    #[inline(always)]
    pub(crate) fn step(&mut self) {
        self.x += self.step;
        let (error, carry) = self.error.0.overflowing_add(self.error_step);
        self.error = Wrapping(error);
        if carry {
            self.x += 1;
            self.error -= self.height;
        }
    }

    /// The walk as words, from which [`of_words`](Self::of_words) makes it again.
    #[inline(always)]
    pub(crate) const fn to_words(self) -> [u32; Self::WORDS] {
        [
            self.x.0 as u32,
            self.error.0,
            self.step.0 as u32,
            self.error_step,
            self.height.0,
        ]
    }

    /// The walk that [`to_words`](Self::to_words) wrote.
    #[inline(always)]
    pub(crate) const fn of_words([x, error, step, error_step, height]: [u32; Self::WORDS]) -> Self {
        Self {
            x: Wrapping(x as i32),
            error: Wrapping(error),
            step: Wrapping(step as i32),
            error_step,
            height: Wrapping(height),
        }
    }
}
