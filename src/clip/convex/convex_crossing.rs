//! Where a segment crosses a side of a convex window, or an edge of another polygon: an exact fraction of its length,
//! compared exactly, rounded once.

use core::{
    cmp::Ordering,
    ops::{Add, Sub},
};

use crate::{
    clip::{convex::unit_cell::UnitCell, segment::crossing::products_fit_32_bits},
    geometry::{SubPixel, SubPoint, coordinate_after},
};

/// A position along a segment: `part / whole` of the way from its start to its end.
///
/// `part` is the distance of the segment's start from a side of a [`ConvexWindow`](crate::geometry::ConvexWindow), and
/// `whole` the sum of the distances of both ends: below 2^56, and below 2^32 between 16-bit coordinates.
#[derive(Debug, Copy, Clone, PartialEq)]
pub(crate) struct Fraction {
    part: u64,
    whole: u64,
}

impl Fraction {
    /// The position at which the segment crosses a side. `from` and `to` are the signed distances of its start and its end from
    /// the side, and have different signs.
    pub(crate) const fn of_crossing(from: i64, to: i64) -> Self {
        let part = from.unsigned_abs();
        Self {
            part,
            whole: part + to.unsigned_abs(),
        }
    }

    /// Compares two positions along one segment: `Less` where this one comes first.
    pub(crate) fn compare<S: SubPixel>(&self, other: &Self) -> Ordering {
        compare_products::<S>((self.part, other.whole), (other.part, self.whole))
    }

    /// Whether a value that changes evenly from `from` to `to` along the segment is 0 or more at this position.
    pub(crate) fn is_not_below_zero<S: SubPixel>(&self, from: i64, to: i64) -> bool {
        let rest = self.whole - self.part;
        match (from < 0, to < 0) {
            (false, false) => true,
            (true, true) => false,
            (below, _) => {
                let (from, to) = ((from.unsigned_abs(), rest), (to.unsigned_abs(), self.part));
                let (negative, positive) = if below { (from, to) } else { (to, from) };
                compare_products::<S>(positive, negative).is_ge()
            }
        }
    }

    /// The point at this position of a segment, rounded to the nearest unit, ties to the larger coordinate; `None` outside
    /// the domain.
    pub(crate) fn point<S: SubPixel>(&self, from: SubPoint<S>, to: SubPoint<S>) -> Option<SubPoint<S>> {
        let x = self.between::<S>(from.x_units(), to.x_units());
        let y = self.between::<S>(from.y_units(), to.y_units());
        SubPoint::from_units(x, y).ok()
    }

    /// The exact point at this position of a segment, as the cell of whole units that it lies in; `None` outside the domain.
    pub(crate) fn cell<S: SubPixel>(&self, from: SubPoint<S>, to: SubPoint<S>) -> Option<UnitCell<S>> {
        let (x, x_part) = self.exactly_between::<S>(from.x_units(), to.x_units());
        let (y, y_part) = self.exactly_between::<S>(from.y_units(), to.y_units());
        Some(UnitCell {
            top_left: SubPoint::from_units(x, y).ok()?,
            parts: (x_part, y_part),
            whole: self.whole,
        })
    }

    /// The coordinate at this position between those of the segment's start and end, rounded to the nearest unit. The segment
    /// from the end to the start has the same one at the same point.
    fn between<S: SubPixel>(&self, from: i32, to: i32) -> i32 {
        let (low, part) = self.part_from_lower(from, to);
        let scaled = if products_fit_32_bits::<S>() {
            scale_rounded(from.abs_diff(to), part as u32, self.whole as u32)
        } else {
            scale_rounded(from.abs_diff(to), part, self.whole)
        };
        // `scaled` is at most the distance, so the sum is at most the larger coordinate.
        coordinate_after(low, scaled)
    }

    /// The exact coordinate at this position between those of the segment's start and end: rounded down to a unit, and the
    /// remainder in units divided by `whole`.
    fn exactly_between<S: SubPixel>(&self, from: i32, to: i32) -> (i32, u64) {
        let (low, part) = self.part_from_lower(from, to);
        let (scaled, rest) = if products_fit_32_bits::<S>() {
            let (scaled, rest) = scale(from.abs_diff(to), part as u32, self.whole as u32);
            (scaled, u64::from(rest))
        } else {
            scale(from.abs_diff(to), part, self.whole)
        };
        (coordinate_after(low, scaled), rest)
    }

    /// The smaller of the coordinates of the segment's start and end, and `part` counted from that end on.
    const fn part_from_lower(&self, from: i32, to: i32) -> (i32, u64) {
        if from <= to {
            (from, self.part)
        } else {
            (to, self.whole - self.part)
        }
    }
}

/// Compares two products of two numbers each, exactly. Between 16-bit coordinates all numbers are below 2^32.
fn compare_products<S: SubPixel>(left: (u64, u64), right: (u64, u64)) -> Ordering {
    if products_fit_32_bits::<S>() {
        (left.0 * left.1).cmp(&(right.0 * right.1))
    } else {
        let product = |(one, other): (u64, u64)| u128::from(one) * u128::from(other);
        product(left).cmp(&product(right))
    }
}

/// `distance * part / whole` to the nearest, ties upwards.
fn scale_rounded<N>(distance: u32, part: N, whole: N) -> u32
where
    N: Copy + Ord + Default + Add<Output = N> + Sub<Output = N>,
{
    let (quotient, remainder) = scale(distance, part, whole);
    let round_up = remainder >= whole - remainder;
    quotient + u32::from(round_up)
}

/// `distance * part / whole` and its remainder, for `part <= whole` and a `whole` that is not 0.
///
/// The product may have 88 bits. So quotient and remainder are built up over the bits of `distance`, from the highest on:
/// both are doubled, and `part` is added to the remainder where the bit is set. The remainder is kept below `whole` without
/// a sum that exceeds it, because `whole` may need all bits of `N`.
#[inline]
fn scale<N>(distance: u32, part: N, whole: N) -> (u32, N)
where
    N: Copy + Ord + Default + Add<Output = N> + Sub<Output = N>,
{
    let (mut quotient, mut remainder) = (0u32, N::default());
    // Adds `more` to the remainder; where the sum would reach `whole`, that is taken off, and the quotient gains one.
    let add = |remainder: N, more: N, quotient: u32| {
        let to_carry = whole - more;
        if remainder >= to_carry {
            (remainder - to_carry, quotient + 1)
        } else {
            (remainder + more, quotient)
        }
    };
    for bit in (0..32u32 - distance.leading_zeros()).rev() {
        (remainder, quotient) = add(remainder, remainder, quotient << 1);
        if (distance >> bit) & 1 != 0 {
            (remainder, quotient) = add(remainder, part, quotient);
        }
    }
    (quotient, remainder)
}
