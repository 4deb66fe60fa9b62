//! A straight piece of an edge, cut where it passes from pixel to pixel.

use core::ops::Range;

use crate::scan::UNIT;

/// What of a piece lies in one pixel.
#[derive(Copy, Clone)]
pub(super) struct Part {
    pub(super) column: i32,
    /// Of the height of the piece.
    pub(super) height: i32,
    /// The places in the pixel where the piece enters and leaves it, added up.
    pub(super) places: i32,
}

impl Part {
    /// A piece that lies in one pixel.
    #[inline(always)]
    pub(super) fn within([start, end]: [i32; 2], height: i32) -> Self {
        Self {
            column: start >> 8,
            height,
            places: (start & (UNIT - 1)).wrapping_add(end & (UNIT - 1)),
        }
    }

    /// What the part adds to each pixel right of its own, in half square units.
    #[inline(always)]
    pub(super) fn whole(&self) -> i32 {
        self.height.wrapping_mul(2 * UNIT)
    }

    /// What of that its own pixel misses, because it lies left of the part.
    #[inline(always)]
    pub(super) fn left(&self) -> i32 {
        self.height.wrapping_mul(self.places)
    }
}

/// Cuts a piece from `start` to `end`, left to right: calls `visit` for its part in each pixel but the last, and returns
/// that one.
///
/// The parts are rounded, but add up to `height`. Cost: a division where it lies in two pixels, two where it lies in
/// more, and none within a pixel.
///
/// # Errors
/// The first of `visit`.
#[inline(always)]
pub(super) fn each_pixel<E>(
    [start, end]: [i32; 2],
    mut height: i32,
    mut visit: impl FnMut(Part) -> Result<(), E>,
) -> Result<Part, E> {
    let (mut column, last) = (start >> 8, end >> 8);
    let (mut from, to) = (start & (UNIT - 1), end & (UNIT - 1));
    if column < last {
        let length = end.wrapping_sub(start);
        // Heights are at most 2^8 units.
        let (part, rest) = divide(height.wrapping_mul(UNIT.wrapping_sub(from)), length);
        visit(Part {
            column,
            height: part,
            places: from.wrapping_add(UNIT),
        })?;
        let steps = Steps { height, length, rest };
        (height, from, column) = (height.wrapping_sub(part), 0, column.wrapping_add(1));
        if column < last {
            height = steps.each_pixel(column..last, height, visit)?;
        }
    }
    Ok(Part {
        column: last,
        height,
        places: from.wrapping_add(to),
    })
}

/// The parts of a piece that is shorter than a pixel and lies in two, the same ones. Cost: a division and no branch.
#[inline(always)]
pub(super) fn short_parts([start, end]: [i32; 2], height: i32) -> [Part; 2] {
    let (column, from, to) = (start >> 8, start & (UNIT - 1), end & (UNIT - 1));
    let (part, _) = divide(height.wrapping_mul(UNIT.wrapping_sub(from)), end.wrapping_sub(start));
    [
        Part {
            column,
            height: part,
            places: from.wrapping_add(UNIT),
        },
        Part {
            column: column.wrapping_add(1),
            height: height.wrapping_sub(part),
            places: to,
        },
    ]
}

/// A piece that passes whole pixels.
struct Steps {
    height: i32,
    length: i32,
    /// What the rounding of the part before leaves over.
    rest: i32,
}

impl Steps {
    /// Visits the pixels that are passed whole, and returns what is left of the height.
    #[inline(always)]
    fn each_pixel<E>(
        self,
        columns: Range<i32>,
        mut left_over: i32,
        mut visit: impl FnMut(Part) -> Result<(), E>,
    ) -> Result<i32, E> {
        let Self { height, length, rest } = self;
        let sign = height >> 31 | 1;
        let (step, rest_step) = divide(height.wrapping_mul(UNIT), length);
        let (mut rest, rest_step) = (rest.wrapping_mul(sign), rest_step.wrapping_mul(sign));
        for column in columns {
            let mut part = step;
            rest = rest.wrapping_add(rest_step);
            if rest >= length {
                (part, rest) = (part.wrapping_add(sign), rest.wrapping_sub(length));
            }
            visit(Part {
                column,
                height: part,
                places: UNIT,
            })?;
            left_over = left_over.wrapping_sub(part);
        }
        Ok(left_over)
    }
}

/// Quotient rounded towards 0, and remainder; some numbers for a divisor that is not positive.
#[inline(always)]
fn divide(numerator: i32, divisor: i32) -> (i32, i32) {
    let quotient = if divisor > 0 {
        numerator.wrapping_div(divisor)
    } else {
        0
    };
    (quotient, numerator.wrapping_sub(quotient.wrapping_mul(divisor)))
}
