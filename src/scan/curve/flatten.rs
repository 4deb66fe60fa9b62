//! How far a part of a curve bends, and so how often it must be halved to be flat.
//!
//! The bound: between two points of a curve, a step `h` of its parameter apart, it is within `max |B''| h^2 / 8` of the
//! line between them, point by point (Filip, Magedson and Markot 1986). It is attained by parabolas.

use fixed::types::U8F8;

/// Fractional bits of 1/256 pixel that make every number here exact: 12 halvings of a cubic take 3 each.
pub(crate) const GUARD_BITS: u32 = 36;
/// How many halvings make any curve in the domain flat. Its second derivative is below `6 * sqrt(2) * 2^23` units, so what
/// is left of it after 12 is below 4.3 units; 10.1 are allowed at the smallest tolerance.
pub(crate) const MOST_HALVINGS: u32 = 12;

/// The limit of the second derivative up to which a part of a curve counts as flat, for a parameter from 0 to 1.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct Flatness {
    /// The square of the largest second derivative of a part that counts as flat, in 1/16 unit.
    limit_squared: u64,
}

/// Second derivatives are compared in 1/16 unit: what is left then is the upper half of the number.
const COMPARED_BITS: u32 = 4;

impl Flatness {
    pub(crate) fn new(tolerance: U8F8) -> Self {
        let tolerance = u64::from(tolerance.to_bits().max(2));
        // Eight times the tolerance, without sqrt(1/2) for the rounding of the ends (8 * 16 * 0.7072 is below 91) and
        // without sqrt(2) for what comparing leaves out.
        let limit = (8 << COMPARED_BITS) * tolerance - 93;
        Self {
            limit_squared: limit * limit,
        }
    }

    /// Whether a part of a curve is flat whose second derivatives along x and y have these sizes.
    #[inline]
    pub(crate) fn allows(&self, bend: [u32; 2]) -> bool {
        // At most 2^30 each.
        let [x, y] = bend.map(|along| u64::from(along) * u64::from(along));
        x + y <= self.limit_squared
    }

    /// How often a curve whose second derivatives have these sizes must be halved until all its parts are flat (Wang
    /// 1984).
    pub(crate) fn halvings(&self, mut bend: [u32; 2]) -> u32 {
        let mut halvings = 0;
        while !self.allows(bend) {
            // Each halving leaves a quarter of the second derivative.
            bend = bend.map(|along| along.div_ceil(4));
            halvings += 1;
        }
        halvings
    }
}

/// The size of a second derivative with [`GUARD_BITS`], in 1/16 unit: within 1 of the exact size, and never more for a
/// part of a curve than for the whole.
#[inline]
pub(crate) fn compared(second_derivative: i64) -> u32 {
    ((second_derivative >> (GUARD_BITS - COMPARED_BITS)) as i32).unsigned_abs()
}

/// What [`compared`] gives for a parabola after so many halvings, from the second difference of its control points in units.
#[inline(always)]
pub(crate) const fn compared_parabola(second_difference: i32, halvings: u32) -> u32 {
    // The second derivative is twice that, and each halving leaves a quarter. Below 2^30 in the domain.
    ((second_difference << (COMPARED_BITS + 1)) >> (2 * halvings)).unsigned_abs()
}

/// Rounds a coordinate with [`GUARD_BITS`] to the nearest unit, halves up.
pub(crate) fn round(coordinate: i64) -> i64 {
    (coordinate + (1 << (GUARD_BITS - 1))) >> GUARD_BITS
}
