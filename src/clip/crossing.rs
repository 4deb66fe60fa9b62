//! Where a segment crosses a side of a window: an exact quotient, rounded once.
//!
//! Promises: computed from the end points of the whole segment, so that nothing adds up over several cuts; the same for
//! both orders of the end points; no overflow for any numbers that the coordinate types hold.

use core::num::NonZeroU32;

use crate::{
    clip::Outcode,
    geometry::{SubPixel, SubPoint, divide_wide},
};

/// The place of a segment on its `other` axis where it meets a value of the axis that is cut, in units.
///
/// The exact place is `floor + remainder / divisor`.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) struct Crossing {
    floor: i32,
    remainder: u32,
    divisor: u32,
}

impl Crossing {
    /// Where the segment has that `x`, which lies between those of its end points.
    ///
    /// Cost: one division; 32-bit for 16-bit coordinates and wherever the product fits.
    pub(super) fn at_x<S: SubPixel>(from: SubPoint<S>, to: SubPoint<S>, x: i32) -> Self {
        Self::of::<S>((from.x_units(), from.y_units()), (to.x_units(), to.y_units()), x)
    }

    /// Where the segment has that `y`, which lies between those of its end points.
    pub(super) fn at_y<S: SubPixel>(from: SubPoint<S>, to: SubPoint<S>, y: i32) -> Self {
        Self::of::<S>((from.y_units(), from.x_units()), (to.y_units(), to.x_units()), y)
    }

    /// `from` and `to` are (axis that is cut, other axis).
    fn of<S: SubPixel>(from: (i32, i32), to: (i32, i32), side: i32) -> Self {
        // Upwards on the other axis: both orders of the end points compute the same.
        let ((start, low), (end, high)) = if from.1 <= to.1 { (from, to) } else { (to, from) };
        let divisor = start.abs_diff(end).max(1);
        let (quotient, remainder) = scale::<S>(start.abs_diff(side), low.abs_diff(high), divisor);
        Self {
            // At most `high`: the side lies between the end points.
            floor: low.wrapping_add_unsigned(quotient),
            remainder,
            divisor,
        }
    }

    /// The nearest unit, ties to the larger one.
    pub(super) const fn rounded(self) -> i32 {
        // The remainder is less than the divisor. Where it is not 0, one more unit is at most the segment's end.
        let round_up = self.remainder >= self.divisor.wrapping_sub(self.remainder);
        self.floor.wrapping_add(round_up as i32)
    }

    /// The outcode of the exact place: whether it lies below the first limit or above the last.
    pub(super) const fn beyond(self, first: (i32, Outcode), last: (i32, Outcode)) -> Outcode {
        if self.floor < first.0 {
            first.1
        } else if self.floor > last.0 || self.floor == last.0 && self.remainder != 0 {
            last.1
        } else {
            Outcode::INSIDE
        }
    }
}

/// `offset * distance / divisor` with its remainder; the quotient is at most `distance`. The divisor is not 0.
///
/// Its type does not say so: with `NonZeroU32` the compiler spent up to 4 % more instructions on cuts (Cortex-M4).
fn scale<S: SubPixel>(offset: u32, distance: u32, divisor: u32) -> (u32, u32) {
    let (product, quotient) = if products_fit_32_bits::<S>() {
        let product = offset.wrapping_mul(distance);
        (product, product.checked_div(divisor).unwrap_or(0))
    } else {
        // Two 32-bit numbers: fits.
        let product = u64::from(offset).wrapping_mul(u64::from(distance));
        (product as u32, divide(product, divisor))
    };
    // Less than the divisor, so the lower halves are enough.
    (quotient, product.wrapping_sub(quotient.wrapping_mul(divisor)))
}

/// `(offset * distance + part) / divisor`. The part is at most half of the largest distance, so that the sum fits, too, and
/// the offset at most the divisor, so that the quotient does.
pub(super) fn scaled<S: SubPixel>(offset: u32, distance: u32, part: u32, divisor: NonZeroU32) -> u32 {
    if products_fit_32_bits::<S>() {
        return (offset * distance + part) / divisor;
    }
    divide_wide(u64::from(offset) * u64::from(distance) + u64::from(part), divisor).0
}

/// A quotient that fits 32 bits; in 32 bits where the dividend does, too.
fn divide(dividend: u64, divisor: u32) -> u32 {
    match u32::try_from(dividend) {
        Ok(dividend) => dividend.checked_div(divisor).unwrap_or(0),
        Err(_) => dividend.checked_div(u64::from(divisor)).unwrap_or(0) as u32,
    }
}

/// Two distances between 16-bit coordinates are at most 65,535 each, and 65,535 * 65,535 < 2^32.
pub(super) const fn products_fit_32_bits<S: SubPixel>() -> bool {
    size_of::<S::Coordinate>() <= 2
}
