//! Flattening: a Bézier curve becomes straight lines that are nowhere further from it than a tolerance.
//!
//! Three siblings with one signature, `flatten(&curve, tolerance)`, an iterator over the ends of the lines; the first line
//! begins at the first control point.
//!
//! | sibling | how | take it when |
//! |---|---|---|
//! | [`adaptive_forward_difference`](crate::scan::adaptive_forward_difference) | the step grows and shrinks | always: the default, few lines and no stack |
//! | [`de_casteljau`](crate::scan::de_casteljau) | halves the curve until its parts are flat | both halves of a curve are wanted; it gives the same lines |
//! | [`uniform_subdivision`](crate::scan::uniform_subdivision) | equal steps, their number known before | the number of lines must be known, or curves bend evenly |
//!
//! All promise:
//! - each point of the curve has a point of the lines within the tolerance, and each of the lines one of the curve (their
//!   Fréchet distance); the rounding of the ends to 1/256 pixel is included. The smallest tolerance that can be kept is
//!   2/256 pixel, and smaller ones count as that;
//! - the last line ends exactly at the last control point;
//! - the reversed curve has the same lines, reversed;
//! - any curve in the domain of [`Sub8`](crate::geometry::Sub8): at most 4,096 lines, no number overflows.
//!
//! The bound: between two points of a curve, a step `h` of its parameter apart, it is within `max |B''| h^2 / 8` of the
//! line between them, point by point (Filip, Magedson and Markot 1986). It is attained by parabolas.

use fixed::types::U8F8;

/// Fractional bits of 1/256 pixel that make every number here exact: 12 halvings of a cubic take 3 each.
pub(super) const GUARD_BITS: u32 = 36;
/// So many halvings make any curve in the domain flat. Its second derivative is below `6 * sqrt(2) * 2^23` units, so what
/// is left of it after 12 is below 4.3 units; 10.3 are allowed at the smallest tolerance.
pub(super) const MOST_HALVINGS: u32 = 12;

/// How far the second derivative may go: of a part of the curve whose parameter runs from 0 to 1.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) struct Flatness {
    /// In 1/16 unit, squared.
    limit_squared: u64,
}

/// Second derivatives are compared in 1/16 of 1/256 pixel, rounded up.
const COMPARED_BITS: u32 = 4;

impl Flatness {
    pub(super) fn new(tolerance: U8F8) -> Self {
        let tolerance = u64::from(tolerance.to_bits().max(2));
        // Eight times the tolerance, without sqrt(1/2) for the rounding of the ends: 8 * 16 * 0.7072 is below 91.
        let limit = (8 << COMPARED_BITS) * tolerance - 91;
        Self {
            limit_squared: limit * limit,
        }
    }

    /// Whether a part is flat that bends that much along x and y, in units with [`GUARD_BITS`].
    #[inline]
    pub(super) fn allows(&self, bend: [i64; 2]) -> bool {
        let shift = GUARD_BITS - COMPARED_BITS;
        let squares = bend.map(|along| {
            // At most 2^30.
            let compared = (along as u64).wrapping_add((1 << shift) - 1) >> shift;
            compared * compared
        });
        let [x, y] = squares;
        x + y <= self.limit_squared
    }

    /// How often a curve that bends that much, in whole units, must be halved until all its parts are flat (Wang 1984).
    pub(super) fn halvings(&self, bend: [i64; 2]) -> u32 {
        let [x, y] = bend.map(|along| {
            let compared = (along as u64) << COMPARED_BITS;
            compared * compared
        });
        // Each halving takes a quarter of the second derivative, a sixteenth of its square; rounded up.
        let mut squared = x + y;
        let mut halvings = 0;
        while squared > self.limit_squared {
            squared = squared.wrapping_add(15) >> 4;
            halvings += 1;
        }
        halvings
    }
}

/// A coordinate with [`GUARD_BITS`], rounded to the nearest unit, halves up.
pub(super) fn round(coordinate: i64) -> i64 {
    coordinate.wrapping_add(1 << (GUARD_BITS - 1)) >> GUARD_BITS
}
