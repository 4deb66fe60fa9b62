//! The circle `dx^2 + dy^2 < d^2` in doubled coordinates, from the middle of its box.
//!
//! Guarantees: embedded-graphics' pixels, with its correction for diameters up to 4, for every diameter that a `u32` holds.
//! The first visible row is entered by an integer square root (as Kuzmin 1995 enters lines), the rows below it by
//! forward differences.

use crate::{clip::shape::circle_limit, scan::round::ForwardDifference};

/// The circle in a row of the upper half of its box, `row <= (diameter - 1) / 2`. The diameter is at least 1.
///
/// Cost: one integer square root, of 32 bits where diameters are below 2^16.
pub(crate) fn enter(diameter: u32, row: u32) -> ForwardDifference<u32> {
    let dy = diameter - 1 - 2 * row;
    // The largest dx^2, below 2^64. Each dy is less than the diameter, and the correction keeps it positive.
    let decision_variable = circle_limit(diameter) - 1 - u64::from(dy) * u64::from(dy);
    let root = square_root(decision_variable);
    // Doubled distances have the parity of diameter - 1.
    let dx = root - ((root ^ (diameter - 1)) & 1);
    let slack = (decision_variable - u64::from(dx) * u64::from(dx)) / 4;
    // (dx + 2)^2 - dx^2 = 4 (dx + 1): everything is divided by 4.
    let column_increment = dx + 1;
    ForwardDifference {
        inset: (diameter - 1 - dx) / 2,
        error_term: column_increment - slack as u32,
        column_increment,
        column_increment_step: 2,
        // Modulo 2^32: in the middle row of an odd diameter it is negative, and not used.
        row_increment: dy.wrapping_sub(1),
        row_increment_step: 2,
    }
}

/// The error term for a first pixel in a row above the box: what the decision variable lacks there. `dy` is the doubled
/// distance from the middle row.
///
/// For diameters below 2^15 and distances not much larger.
pub(crate) fn error_term_above(diameter: u32, dy: u32) -> u32 {
    // The smallest dx is 0 or 1. The result is divided by 4, as in `enter`, and rounded up.
    let dx = (diameter - 1) & 1;
    let needed = dy * dy + dx;
    let decision_variable = circle_limit(diameter) as u32 - 1;
    // A shift, because `div_ceil` adds 1 to the quotient where there is a rest, which takes 2 instructions more.
    (needed - decision_variable + 3) >> 2
}

fn square_root(number: u64) -> u32 {
    match u32::try_from(number) {
        Ok(number) => number.isqrt(),
        Err(_) => number.isqrt() as u32,
    }
}
