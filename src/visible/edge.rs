//! An edge walked exactly, row by row: quotient and remainder, one division.

use crate::view::{DepthWidth, ScreenPrecision, ScreenVertex};

/// The first pixel of each row whose centre is on the edge or right of it.
///
/// Used for the left side of a span as its start and for the right side as its end, this is the top-left rule, and two
/// faces that share an edge get the same integers, because both walk it from its top to its bottom.
///
/// `x = ceil(exact x)`; `error` is what was rounded up, in 1/`height` pixel, rounded down.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) struct Edge<S: ScreenPrecision> {
    x: S::Units,
    error: S::Units,
    step: S::Units,
    remainder: S::Units,
    height: S::Units,
}

impl<S: ScreenPrecision> Edge<S> {
    pub(super) const EMPTY: Self = Self {
        x: S::ZERO,
        error: S::ZERO,
        step: S::ZERO,
        remainder: S::ZERO,
        height: S::ZERO,
    };

    /// The edge at a row that it crosses: `top.y <= row < bottom.y`.
    ///
    /// No product exceeds 2^31: with 1/256 pixel, heights are at most 2 * 8191 * 256 and times 2 * 255 that is
    /// 2,138,833,920; with 1/16 pixel everything is smaller.
    #[inline(always)]
    pub(super) fn new<D: DepthWidth>(top: &ScreenVertex<S, D>, bottom: &ScreenVertex<S, D>, row: i32) -> Self {
        let bits = S::FRACTION_BITS;
        let unit = 1i32 << bits;
        let (top_x, top_y) = (top.x_units(), top.y_units());
        let height = bottom.y_units().wrapping_sub(top_y);
        let (step, remainder) = divide_floor(bottom.x_units().wrapping_sub(top_x), height);

        // From the top to the centre of the first row, and back from the first centre right of the top.
        let first_row = top_y.wrapping_add(unit - 1) >> bits;
        let down = (first_row << bits).wrapping_sub(top_y);
        let column = top_x.wrapping_add(unit - 1) >> bits;
        let right = (column << bits).wrapping_sub(top_x);

        // x = column + (units + remainder * down / height) / unit, in exact arithmetic.
        let units = step.wrapping_mul(down).wrapping_sub(right);
        let numerator = (units & (unit - 1))
            .wrapping_mul(height)
            .wrapping_add(remainder.wrapping_mul(down));
        let denominator = height << bits;
        let mut x = column.wrapping_add(units >> bits);
        // The numerator is below two denominators: rounding up needs no division.
        let mut error = numerator.wrapping_neg();
        if error < 0 {
            x = x.wrapping_add(1);
            error = error.wrapping_add(denominator);
            if error < 0 {
                x = x.wrapping_add(1);
                error = error.wrapping_add(denominator);
            }
        }
        let mut edge = Self {
            x: S::narrow(x),
            error: S::narrow(error >> bits),
            step: S::narrow(step),
            remainder: S::narrow(remainder),
            height: S::narrow(height),
        };
        let skipped = row.wrapping_sub(first_row);
        if skipped > 0 {
            edge.skip(skipped);
        }
        edge
    }

    #[inline(always)]
    pub(super) fn x(&self) -> i32 {
        self.x.into()
    }

    /// To the next row. What it makes of the row after the last one is not used, and may wrap.
    #[inline(always)]
    pub(super) fn step_down(&mut self) {
        let mut x = self.x.into().wrapping_add(self.step.into());
        let mut error = self.error.into().wrapping_sub(self.remainder.into());
        if error < 0 {
            error = error.wrapping_add(self.height.into());
            x = x.wrapping_add(1);
        }
        self.x = S::narrow(x);
        self.error = S::narrow(error);
    }

    /// Enters an edge in the middle: the same integers as that many steps, by one more division.
    #[cold]
    fn skip(&mut self, rows: i32) {
        // Below 2^22 * 2^14 with 1/256 pixel.
        let (rows, height) = (i64::from(rows), i64::from(self.height.into()));
        let behind = i64::from(self.remainder.into()) * rows - i64::from(self.error.into());
        let carries = if behind > 0 { (behind + height - 1) / height } else { 0 };
        let x = i64::from(self.x.into()) + i64::from(self.step.into()) * rows + carries;
        self.x = S::narrow(x as i32);
        self.error = S::narrow((carries * height - behind) as i32);
    }
}

/// Quotient rounded down and remainder; most edges are steep and need no division.
#[inline(always)]
fn divide_floor(numerator: i32, denominator: i32) -> (i32, i32) {
    if numerator >= 0 {
        if numerator < denominator {
            return (0, numerator);
        }
    } else {
        let raised = numerator.wrapping_add(denominator);
        if raised >= 0 {
            return (-1, raised);
        }
    }
    // A height of 0 is not an edge; the callers sort them out.
    let quotient = numerator.checked_div(denominator).unwrap_or(0);
    let remainder = numerator.wrapping_sub(quotient.wrapping_mul(denominator));
    if remainder < 0 {
        (quotient.wrapping_sub(1), remainder.wrapping_add(denominator))
    } else {
        (quotient, remainder)
    }
}
