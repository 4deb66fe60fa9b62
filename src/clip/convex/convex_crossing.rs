//! Where a segment crosses a side of a convex window, or an edge of another polygon: an exact fraction of its length,
//! compared exactly, rounded once.

use core::{
    cmp::Ordering,
    ops::{Add, Sub},
};

use crate::{
    clip::{convex::unit_cell::UnitCell, segment::crossing::products_fit_32_bits},
    geometry::{SubPixel, SubPoint},
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
    /// The part of the way at which the distance to a side, which is `from` at the start and `to` at the end, is 0. Both have
    /// different signs.
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

    /// The exact point at this position of a segment, as the units around it; `None` outside the domain.
    pub(crate) fn cell<S: SubPixel>(&self, from: SubPoint<S>, to: SubPoint<S>) -> Option<UnitCell<S>> {
        let (x, x_part) = self.exactly_between::<S>(from.x_units(), to.x_units());
        let (y, y_part) = self.exactly_between::<S>(from.y_units(), to.y_units());
        Some(UnitCell {
            top_left: SubPoint::from_units(x, y).ok()?,
            parts: (x_part, y_part),
            whole: self.whole,
        })
    }

    /// The unit nearest to this fraction of the way between two coordinates, the same for both orders of them.
    fn between<S: SubPixel>(&self, from: i32, to: i32) -> i32 {
        let (low, part) = self.part_from_lower(from, to);
        let scaled = if products_fit_32_bits::<S>() {
            scale_rounded(from.abs_diff(to), part as u32, self.whole as u32)
        } else {
            scale_rounded(from.abs_diff(to), part, self.whole)
        };
        // At most the distance, so the sum is at most the larger one.
        low.wrapping_add_unsigned(scaled)
    }

    /// The coordinate at this fraction of the way between two others: rounded down, and what is left over, as a numerator of
    /// the fraction's denominator.
    fn exactly_between<S: SubPixel>(&self, from: i32, to: i32) -> (i32, u64) {
        let (low, part) = self.part_from_lower(from, to);
        let (scaled, rest) = if products_fit_32_bits::<S>() {
            let (scaled, rest) = scale(from.abs_diff(to), part as u32, self.whole as u32);
            (scaled, u64::from(rest))
        } else {
            scale(from.abs_diff(to), part, self.whole)
        };
        (low.wrapping_add_unsigned(scaled), rest)
    }

    /// The smaller of two coordinates, and the part from there on.
    const fn part_from_lower(&self, from: i32, to: i32) -> (i32, u64) {
        if from <= to {
            (from, self.part)
        } else {
            (to, self.whole - self.part)
        }
    }
}

/// Compares the product of one pair with that of another, exactly.
fn compare_products<S: SubPixel>(left: (u64, u64), right: (u64, u64)) -> Ordering {
    if products_fit_32_bits::<S>() {
        // Numbers below 2^32: the products fit.
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
/// Bit by bit, as `distance` has them, because the product may have 88 bits. The remainder stays below `whole`, and no
/// sum is made that would not.
#[inline]
fn scale<N>(distance: u32, part: N, whole: N) -> (u32, N)
where
    N: Copy + Ord + Default + Add<Output = N> + Sub<Output = N>,
{
    let (mut quotient, mut remainder) = (0u32, N::default());
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
