//! A straight piece of an edge, cut where it passes from pixel to pixel.

use core::ops::Range;

use crate::coverage::edges::{FINE, FINE_BITS, HEIGHT_BITS};

/// The bits of a pixel's area: few enough for the sum of 8,191 pixels.
pub(crate) const AREA_BITS: u32 = 18;

/// Shift from a height, 2^14 for a whole pixel, to the area of a pixel that high.
const WHOLE_SHIFT: u32 = AREA_BITS - 8 - HEIGHT_BITS;
/// Shift from a height times the sum of two x to an area. A whole pixel's product is 2^28.
const LEFT_SHIFT: u32 = 8 + HEIGHT_BITS + FINE_BITS + 1 - AREA_BITS;

/// What of a piece lies in one pixel. A pixel has the area 2^18.
#[derive(Copy, Clone)]
pub(crate) struct Part {
    pub(crate) column: i32,
    /// What the part adds to each pixel right of its own.
    pub(crate) whole: i32,
    /// What of that its own pixel misses, because it lies left of the part.
    pub(crate) left: i32,
}

impl Part {
    /// A piece that lies in one pixel.
    #[inline(always)]
    pub(crate) fn within([start, end]: [i32; 2], height: i32) -> Self {
        let places = (start & (FINE - 1)).wrapping_add(end & (FINE - 1));
        Self::new(start >> FINE_BITS, height, places)
    }

    /// Adds its areas to the differences of its pixel and of the next one.
    #[inline(always)]
    pub(crate) fn put(&self, here: &mut i32, next: &mut i32) {
        *here = here.wrapping_add(self.whole).wrapping_sub(self.left);
        *next = next.wrapping_add(self.left);
    }

    /// `places` are where the part enters the pixel and where it leaves it, added up: less than 2^14. Heights are at most
    /// 2^14.
    #[inline(always)]
    fn new(column: i32, height: i32, places: i32) -> Self {
        Self {
            column,
            whole: height << WHOLE_SHIFT,
            left: height.wrapping_mul(places) >> LEFT_SHIFT,
        }
    }
}

/// Cuts a piece from `start` to `end`, left to right, in fine units: calls `visit` for its part in each pixel but the last,
/// and returns that one.
///
/// `height` is in 1/64 unit. The parts are rounded to one of those, but add up to it. Cost: a division where it lies in
/// two pixels, two where it lies in more, and none within a pixel.
///
/// # Errors
/// The first of `visit`.
#[inline(always)]
pub(crate) fn each_pixel<E>(
    [start, end]: [i32; 2],
    mut height: i32,
    mut visit: impl FnMut(Part) -> Result<(), E>,
) -> Result<Part, E> {
    let (mut column, last) = (start >> FINE_BITS, end >> FINE_BITS);
    let (mut from, to) = (start & (FINE - 1), end & (FINE - 1));
    if column < last {
        let length = end.wrapping_sub(start);
        // At most 2^14 times 2^13.
        let (part, rest) = divide(height.wrapping_mul(FINE.wrapping_sub(from)), length);
        visit(Part::new(column, part, from.wrapping_add(FINE)))?;
        let steps = Steps { height, length, rest };
        (height, from, column) = (height.wrapping_sub(part), 0, column.wrapping_add(1));
        if column < last {
            height = steps.each_pixel(column..last, height, visit)?;
        }
    }
    Ok(Part::new(last, height, from.wrapping_add(to)))
}

/// The parts of a piece that lies in two pixels, the same ones. Cost: a division and no branch.
#[inline(always)]
pub(crate) fn two_parts([start, end]: [i32; 2], height: i32) -> [Part; 2] {
    let (column, from, to) = (start >> FINE_BITS, start & (FINE - 1), end & (FINE - 1));
    let (part, _) = divide(height.wrapping_mul(FINE.wrapping_sub(from)), end.wrapping_sub(start));
    [
        Part::new(column, part, from.wrapping_add(FINE)),
        Part::new(column.wrapping_add(1), height.wrapping_sub(part), to),
    ]
}

/// Splits a part of an edge that lies in three neighbouring pixels of a row into one part for each pixel. Cost: two divisions and no branch.
#[inline(always)]
pub(crate) fn three_parts([start, end]: [i32; 2], height: i32) -> [Part; 3] {
    let (column, from, to) = (start >> FINE_BITS, start & (FINE - 1), end & (FINE - 1));
    let length = end.wrapping_sub(start);
    let (first, _) = divide(height.wrapping_mul(FINE.wrapping_sub(from)), length);
    let (both, _) = divide(height.wrapping_mul((2 * FINE).wrapping_sub(from)), length);
    [
        Part::new(column, first, from.wrapping_add(FINE)),
        Part::new(column.wrapping_add(1), both.wrapping_sub(first), FINE),
        Part::new(column.wrapping_add(2), height.wrapping_sub(both), to),
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
        let (step, rest_step) = divide(height.wrapping_mul(FINE), length);
        let (mut rest, rest_step) = (rest.wrapping_mul(sign), rest_step.wrapping_mul(sign));
        for column in columns {
            let mut part = step;
            rest = rest.wrapping_add(rest_step);
            if rest >= length {
                (part, rest) = (part.wrapping_add(sign), rest.wrapping_sub(length));
            }
            visit(Part {
                column,
                whole: part << WHOLE_SHIFT,
                left: part << (WHOLE_SHIFT - 1),
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
