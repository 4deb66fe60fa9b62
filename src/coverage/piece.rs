//! A straight piece of an edge, cut where it passes from pixel to pixel.

use crate::scan::UNIT;

/// Calls `visit` for each pixel from left to right that a piece from `start` to `end` passes: its column, which part of
/// `height` lies in it, and the places in the pixel where the piece enters and leaves it, added up.
///
/// What of the part's area lies right of the piece is the part times `2 * UNIT` less that sum, in half square units.
/// The parts are rounded, but add up to `height`. Cost: two divisions, and none within a pixel.
///
/// # Errors
/// The first of `visit`.
#[inline(always)]
pub(super) fn each_pixel<E>(
    [start, end]: [i32; 2],
    height: i32,
    mut visit: impl FnMut(i32, i32, i32) -> Result<(), E>,
) -> Result<(), E> {
    let (mut column, last) = (start >> 8, end >> 8);
    let (mut from, mut left_over) = (start & (UNIT - 1), height);
    if column < last {
        let (length, sign) = (end.wrapping_sub(start), height >> 31 | 1);
        let size = height.wrapping_mul(sign);
        // Heights are at most 2^8 units.
        let (mut part, mut rest) = divide(size.wrapping_mul(UNIT.wrapping_sub(from)), length);
        let mut steps = None;
        loop {
            let signed = part.wrapping_mul(sign);
            visit(column, signed, from.wrapping_add(UNIT))?;
            left_over = left_over.wrapping_sub(signed);
            (from, column) = (0, column.wrapping_add(1));
            if column == last {
                break;
            }
            let (step, rest_step) = *steps.get_or_insert_with(|| divide(size.wrapping_mul(UNIT), length));
            (part, rest) = (step, rest.wrapping_add(rest_step));
            if rest >= length {
                (part, rest) = (part.wrapping_add(1), rest.wrapping_sub(length));
            }
        }
    }
    visit(last, left_over, from.wrapping_add(end & (UNIT - 1)))
}

/// Quotient and remainder of numbers that are not negative; some numbers for a divisor of 0.
#[inline(always)]
fn divide(numerator: i32, divisor: i32) -> (i32, i32) {
    let quotient = (numerator as u32).checked_div(divisor as u32).unwrap_or(0) as i32;
    (quotient, numerator.wrapping_sub(quotient.wrapping_mul(divisor)))
}
