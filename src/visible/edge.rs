//! An edge walked exactly, row by row: quotient and remainder, one division.

use crate::{
    geometry::{HAS_DIVIDER, divide_floor, divide_long, pixel_domain},
    view::{EdgeSum, Position, ScreenPrecision},
};

/// The first pixel of each row whose centre is on the edge or right of it.
///
/// Used for the left side of a span as its start and for the right side as its end, this is the top-left rule, and two
/// faces that share an edge get the same integers, because both walk it from its top to its bottom.
///
/// The column is the exact position rounded up; the fraction is what was rounded up, in 1/height pixel, rounded down.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) struct Edge<S: ScreenPrecision> {
    sum: S::EdgeSum,
    step: S::EdgeSum,
}

/// Height in units up to which an edge in 12.4 is short: it crosses 63 rows.
const SHORT: i32 = 63 * 16;

/// Width in units up to which two edges of a face are short: the third one may be twice as wide, which fits a step.
const NARROW: i32 = 1 << 10;

/// What an edge adds after a carry. Kept apart, so that two edges take no padding.
pub(super) type CarryCorrection<S> = <<S as ScreenPrecision>::EdgeSum as EdgeSum>::CarryCorrection;

/// What the left and the right edge add after their carries, packed into one number.
pub(super) type CarryCorrections<S> = <<S as ScreenPrecision>::EdgeSum as EdgeSum>::CarryCorrections;

impl<S: ScreenPrecision> Edge<S> {
    pub(super) const EMPTY: Self = Self {
        sum: EdgeSum::ZERO,
        step: EdgeSum::ZERO,
    };

    /// The greatest column of the domain, counted from its first one: right of every row, and the last one that a sum has room
    /// for.
    const LAST_COLUMN: i32 = {
        let (min, max) = pixel_domain::<S>();
        max - min
    };

    /// The edge at a row that it crosses, from its top. `size` is from there to its bottom. An edge that crosses no row
    /// gives some edge, whose sum may wrap.
    ///
    /// No product, and no sum of two, reaches 2^31: with 1/256 pixel, differences are at most 2 * 8191 * 256, and times 2 * 255
    /// that is 2,138,833,920; with 1/16 pixel it is less.
    ///
    /// `IN_LINE` is for edges that many faces have.
    // Always: with `inline` alone a frame of the torus and cube takes 2.7 % more instructions, 3.8 % more cycles (Cortex-M0+).
    #[inline(always)]
    pub(super) fn new<const IN_LINE: bool>(top: Position, size: Position, row: i32) -> (Self, CarryCorrection<S>) {
        if !IN_LINE {
            return Self::new_out_of_line(top, size, row);
        }
        let first = PixelAfter::of::<S>(top);
        let Position { x: width, y: height } = size;
        let (columns, rest) = divide_floor(width, height);
        // The exact position is `first.column + (units + rest * first.down / height) / unit`.
        let units = columns * first.down - first.right;
        let fraction = units & ((1 << S::FRACTION_BITS) - 1);
        let mut column = first.column + (units >> S::FRACTION_BITS);
        // Rounding up needs no division: this is more than minus two.
        let one = height << S::FRACTION_BITS;
        let mut error_term = -(fraction * height + (rest * first.down));
        for _ in 0..2 {
            // One more column where something is missing, without a branch.
            let negative = error_term >> 31;
            column -= negative;
            error_term += one & negative;
        }
        let mut error_term = error_term >> S::FRACTION_BITS;
        let skipped = row - first.row;
        if skipped > 0 {
            (column, error_term) = skip(column, error_term, [columns, rest, height], skipped);
        }
        let edge = Self {
            sum: EdgeSum::new(column, error_term),
            step: EdgeSum::step(columns, rest),
        };
        (edge, S::EdgeSum::carry_correction(height))
    }

    /// An edge of at most [`SHORT`] units in 12.4 from its first row on: the same columns from steps of 1/2^20 pixel.
    /// `x` is that of its top, `size` is from there to its bottom, `down` is how far its first row is below its top.
    ///
    /// An exact position is a multiple of 1/(16 height). Position and slope are rounded down, so at the 63rd row the
    /// position is too small by less than 64/2^20, which is less than 1/(16 * 1008): it never falls to or below the
    /// next smaller multiple, and rounding it up gives the exact column.
    #[inline]
    pub(super) fn short(x: i32, size: Position, down: i32) -> Self {
        let Position { x: width, y: height } = size;
        let bits = S::EdgeSum::FRACTION_BITS;
        // Widths are below 2^11. Rounded down, without a branch for negative ones: their complement is divided.
        let rise = width << bits;
        let negative = width >> 31;
        // An edge without height crosses no row. A height of 16 bits, because that is not 0 by itself: otherwise the compiler
        // asks whether the corners lie in the same row, which takes longer.
        let slope = ((rise ^ negative) as u32)
            .checked_div((height as u16).into())
            .unwrap_or(0) as i32
            ^ negative;
        // An edge that crosses no row may wrap here: nobody asks for its columns.
        let position = (x << (bits - S::FRACTION_BITS))
            .wrapping_add(slope.wrapping_mul(down) >> S::FRACTION_BITS)
            .wrapping_add((1 << bits) - 1);
        Self {
            sum: EdgeSum::fixed(position),
            step: EdgeSum::fixed(slope),
        }
    }

    /// The edge in one row that it crosses, without a step to the next one: one division. `top` and `size` are as in
    /// [`new`](Self::new).
    #[inline]
    pub(super) fn in_row(top: Position, size: Position, row: i32) -> Self {
        let down = (row << S::FRACTION_BITS) - top.y;
        // In 12.4, differences are at most 32,752, so that the product fits.
        let (left, _) = if S::FRACTION_BITS <= 4 {
            divide_floor(-size.x * down, size.y)
        } else {
            divide_long(-i64::from(size.x) * i64::from(down), size.y)
        };
        // A sample left of the centre of its pixel sees the end of the domain one column farther right.
        let column = row_after::<S>(top.x - left).min(Self::LAST_COLUMN);
        Self {
            sum: EdgeSum::new(column, 0),
            step: EdgeSum::ZERO,
        }
    }

    /// Whether short edges are set up by a faster method of their own.
    pub(super) const MAY_BE_SHORT: bool = S::FRACTION_BITS == 4 && HAS_DIVIDER;

    /// Whether all three edges of a face are short, two of which have these sizes from its top.
    #[inline(always)]
    pub(super) fn are_short([one, other]: [Position; 2]) -> bool {
        let beyond_narrow = |size: Position| (size.x + NARROW) as u32;
        one.y <= SHORT && other.y <= SHORT && (beyond_narrow(one) | beyond_narrow(other)) < 2 * NARROW as u32
    }

    #[inline(never)]
    fn new_out_of_line(top: Position, size: Position, row: i32) -> (Self, CarryCorrection<S>) {
        Self::new::<true>(top, size, row)
    }
}

/// The left and the right edge of a face. Side by side, because both are read and stepped at once.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) struct EdgePair<S: ScreenPrecision> {
    left: S::EdgeSum,
    right: S::EdgeSum,
    left_step: S::EdgeSum,
    right_step: S::EdgeSum,
}

impl<S: ScreenPrecision> EdgePair<S> {
    pub(super) const EMPTY: Self = Self {
        left: EdgeSum::ZERO,
        right: EdgeSum::ZERO,
        left_step: EdgeSum::ZERO,
        right_step: EdgeSum::ZERO,
    };

    #[inline]
    pub(super) fn set_left(&mut self, edge: Edge<S>) {
        (self.left, self.left_step) = (edge.sum, edge.step);
    }

    #[inline]
    pub(super) fn set_right(&mut self, edge: Edge<S>) {
        (self.right, self.right_step) = (edge.sum, edge.step);
    }

    /// Where the span of the row starts, and where it ends.
    #[inline]
    pub(super) fn columns(&self) -> [i32; 2] {
        [self.left.column(), self.right.column()]
    }

    /// The middle of the span, and twice its step from row to row.
    #[inline]
    pub(super) fn middle(&self) -> [S::EdgeSum; 2] {
        [self.left.mean(self.right), self.left_step.plus(self.right_step)]
    }

    /// Steps to the next row, without what is added after a carry. What it makes of the row after the last one is not used,
    /// and may wrap.
    #[inline]
    pub(super) fn step_down(&mut self) {
        let Self {
            left,
            right,
            left_step,
            right_step,
        } = *self;
        (self.left, self.right) = (left.plus(left_step), right.plus(right_step));
    }

    /// Completes a step: adds the carry corrections of the edges whose error term carried.
    #[inline]
    pub(super) fn carry_correction(&mut self, carry_corrections: CarryCorrections<S>) {
        self.left = self
            .left
            .corrected(S::EdgeSum::left_carry_correction(carry_corrections));
        self.right = self
            .right
            .corrected(S::EdgeSum::right_carry_correction(carry_corrections));
    }
}

/// The first row whose pixel centres are not above a coordinate in units.
#[inline]
pub(super) fn row_after<S: ScreenPrecision>(units: i32) -> i32 {
    (units + ((1 << S::FRACTION_BITS) - 1)) >> S::FRACTION_BITS
}

/// The last row whose pixel centres are above a coordinate in units.
#[inline]
pub(super) fn row_before<S: ScreenPrecision>(units: i32) -> i32 {
    (units - 1) >> S::FRACTION_BITS
}

/// The first pixel whose centre is neither left of a position nor above it, and how far away that centre is in units.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) struct PixelAfter {
    pub(super) column: i32,
    pub(super) row: i32,
    pub(super) right: i32,
    pub(super) down: i32,
}

impl PixelAfter {
    #[inline]
    pub(super) fn of<S: ScreenPrecision>(position: Position) -> Self {
        let before = |units: i32| (-units) & ((1 << S::FRACTION_BITS) - 1);
        let (right, down) = (before(position.x), before(position.y));
        Self {
            column: (position.x + right) >> S::FRACTION_BITS,
            row: (position.y + down) >> S::FRACTION_BITS,
            right,
            down,
        }
    }
}

/// Steps an edge down by several rows at once: the same integers as single steps, by one more division.
#[cold]
#[inline(never)]
fn skip(column: i32, error_term: i32, [columns, rest, height]: [i32; 3], rows: i32) -> (i32, i32) {
    // Below 2^22 * 2^14 with 1/256 pixel.
    let behind = i64::from(rest) * i64::from(rows) - i64::from(error_term);
    let (carries, error_term) = if height <= 0 {
        // An edge without height crosses no row.
        (0, 0)
    } else if behind > 0 {
        // Rounded up.
        let (carries, over) = divide_long(behind + i64::from(height) - 1, height);
        (carries, height - 1 - over)
    } else {
        (0, -behind as i32)
    };
    // An edge that ends before the row is reached may wrap here: nobody asks for its columns.
    let column = column.wrapping_add(columns.wrapping_mul(rows));
    (column.wrapping_add(carries), error_term)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Sub4;

    type S4 = Edge<Sub4>;

    /// The first column whose centre is not left of an edge in a row, by exact numbers.
    fn column(top: Position, size: Position, row: i32) -> i32 {
        let [x, y, width, height] = [top.x, top.y, size.x, size.y].map(i64::from);
        let numerator = x * height + width * (16 * i64::from(row) - y);
        -(-numerator).div_euclid(16 * height) as i32
    }

    /// Steep and level edges of all short heights, with tops of all fractions of a pixel.
    #[test]
    fn a_short_edge_has_the_exact_columns() {
        const { assert!(S4::MAY_BE_SHORT) };
        let widths = [
            0, 1, 2, 3, 15, 16, 17, 241, 495, 496, 497, 833, 1000, 1023, 1024, 1979, 2046, 2047,
        ];
        for height in 1..=SHORT {
            for (fraction, width) in (0..).zip(widths.into_iter().flat_map(|width| [width, -width])) {
                let top = Position {
                    x: 5 * fraction - 16 * height,
                    y: (7 * fraction + height) % 16 - 160,
                };
                let size = Position { x: width, y: height };
                let first = PixelAfter::of::<Sub4>(top);
                let mut edge = S4::short(top.x, size, first.down);
                for row in first.row..row_after::<Sub4>(top.y + height) {
                    assert_eq!(edge.sum.column(), column(top, size, row), "{top:?} {size:?} {row}");
                    edge.sum = edge.sum.plus(edge.step);
                }
            }
        }
    }

    /// A corner at one end of the domain, in a row that begins at the other end, as samples half a pixel away see it.
    #[test]
    fn an_edge_of_a_sample_stays_right_of_every_row() {
        let right = Position {
            x: (1023 + 1024) * 16 + 8,
            y: -100,
        };
        for (width, seen) in [(0, 2047), (-1, 2047), (-40, 2047), (-400, 2035)] {
            let size = Position { x: width, y: 160 };
            let edge = S4::in_row(right, size, -1);
            assert_eq!(edge.sum.column(), seen, "{width}");
            assert_eq!(seen, column(right, size, -1).min(2047), "{width}");
        }
    }

    /// A level edge has no columns, but rows below it are entered with it, too.
    #[test]
    fn an_edge_without_height_is_entered_in_any_row() {
        for width in [-32_000, -1, 0, 1, 32_000] {
            for row in [-1000, 0, 1000] {
                let top = Position { x: -16_000, y: -16_000 };
                S4::new::<true>(top, Position { x: width, y: 0 }, row);
            }
        }
    }

    /// With carry corrections an edge has the same columns, whatever its size.
    #[test]
    fn a_long_edge_has_the_exact_columns() {
        for height in [1, 2, 15, 16, 17, 240, 495, 496, 497, 511, 1023, 4097, 16_001, 32_000] {
            for width in [0, 1, 5, 16, 77, 495, 4096, 8192, 20_011, 32_000]
                .map(|width: i32| [width, -width])
                .as_flattened()
            {
                let top = Position {
                    x: 1234 - width / 2,
                    y: 7,
                };
                let size = Position { x: *width, y: height };
                let first = PixelAfter::of::<Sub4>(top);
                let (mut edge, correction) = S4::new::<true>(top, size, first.row);
                for row in first.row..row_after::<Sub4>(top.y + height) {
                    assert_eq!(edge.sum.column(), column(top, size, row), "{top:?} {size:?} {row}");
                    edge.sum = edge.sum.plus(edge.step).corrected(correction);
                }
            }
        }
    }
}
