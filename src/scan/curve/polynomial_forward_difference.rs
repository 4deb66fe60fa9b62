//! Polynomials of any degree by forward differences (Newton 1687; Foley, van Dam et al. 1990, section 11.2.9): each value
//! by as many additions as the degree, in fixed point.
//!
//! Guarantees: where the step is a power of two ([`dyadic`](PolynomialForwardDifference::dyadic)) every value is exact. For
//! any other number of steps ([`rounded`](PolynomialForwardDifference::rounded)) each difference is rounded once, and
//! after `k` steps of a polynomial of degree `n` the value is wrong by at most
//!
//! `0.51 * (C(k, 1) + C(k, 2) + ... + C(k, n)) / 2^guard_bits`
//!
//! units, and half a unit more for the rounding of what is read. `C(k, j)` are the binomial coefficients; the bound holds
//! up to degree 8. Outside the range of the values numbers wrap, and are right again behind it.
//!
//! Cost: one 64-bit addition a degree and a step. Set-up is quadratic in the degree; a `rounded` one divides 128-bit
//! numbers. Take it when a polynomial is wanted at equal steps; a Bézier curve that bends here and is straight there takes
//! fewer steps by [`Bezier::adaptive_forward_difference`](crate::scan::Bezier::adaptive_forward_difference).

use core::num::NonZeroU32;

use crate::geometry::{InputError, quotient_nearest_long};

/// A walk along a polynomial at equal steps: its value where the walk is, and the differences that lead to the next value.
/// `TERMS` is the degree of the polynomial plus one.
///
/// The coefficients are integers in any unit, a fixed-point format for example; values have the same unit.
///
/// ```
/// use zrow::scan::PolynomialForwardDifference;
///
/// // 100 - 64 t + 64 t^2 at quarters of 0..=1.
/// let mut walk = PolynomialForwardDifference::dyadic(&[100, -64, 64], 2)?;
/// let values = [(); 5].map(|()| {
///     let value = walk.value();
///     walk.advance();
///     value
/// });
/// assert_eq!(values, [100, 88, 84, 88, 100]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PolynomialForwardDifference<const TERMS: usize> {
    /// The value and its differences of order 1, 2 and so on, in units of 1 / 2^`guard_bits`. They wrap where the values of the
    /// caller's polynomial do not fit.
    differences: [i64; TERMS],
    guard_bits: u32,
}

impl<const TERMS: usize> PolynomialForwardDifference<TERMS> {
    /// Walks `c[0] + c[1] t + c[2] t^2 + ...` along `t = k / 2^log2_steps` from `t = 0`, exactly.
    ///
    /// Values take `degree * log2_steps` guard bits; they must fit the other bits of an `i64`.
    ///
    /// # Errors
    /// [`InputError::StepTooFine`] where there are more than 62 guard bits.
    pub fn dyadic(coefficients: &[i32; TERMS], log2_steps: u32) -> Result<Self, InputError> {
        let degree = u32::try_from(TERMS.saturating_sub(1)).unwrap_or(u32::MAX);
        let guard_bits = degree.saturating_mul(log2_steps);
        if guard_bits > MOST_GUARD_BITS {
            return Err(InputError::StepTooFine {
                // A constant takes no guard bits: the degree is not 0 here.
                log2_steps: MOST_GUARD_BITS / degree.max(1),
            });
        }
        let mut shift = guard_bits;
        let scaled = coefficients.map(|coefficient| {
            // Never below 0: there are as many steps down as terms behind the first.
            let scaled = i64::from(coefficient) << shift;
            shift = shift.saturating_sub(log2_steps);
            scaled
        });
        let differences = difference_table(&scaled, |sum_of, order| {
            sum_of.0.wrapping_add(sum_of.1).wrapping_mul(order as i64)
        });
        Ok(Self {
            differences,
            guard_bits,
        })
    }

    /// Walks `c[0] + c[1] t + c[2] t^2 + ...` along `t = k / steps` from `t = 0`, with `guard_bits` guard bits (at most
    /// 62) and the drift of the module documentation. Values must fit the other bits of an `i64`. No steps count as
    /// one.
    pub fn rounded(coefficients: &[i32; TERMS], steps: u32, guard_bits: u32) -> Self {
        let guard_bits = guard_bits.min(MOST_GUARD_BITS);
        // What wraps above 128 bits is no part of the 64 that are left once these bits are shifted out.
        let shift = MOST_SETUP_BITS.saturating_sub(guard_bits).min(64);
        let setup_bits = guard_bits + shift;
        let steps = NonZeroU32::new(steps).unwrap_or(NonZeroU32::MIN);
        let mut power = 0u32;
        let scaled = coefficients.map(|coefficient| {
            let whole = i128::from(coefficient) << setup_bits;
            let scaled = (0..power).fold(whole, |part, _| quotient_nearest_long(part, steps));
            power = power.saturating_add(1);
            scaled
        });
        let differences = difference_table(&scaled, |sum_of, order| {
            sum_of.0.wrapping_add(sum_of.1).wrapping_mul(order as i128)
        });
        let half = 1i128 << (shift - 1);
        Self {
            differences: differences.map(|difference| (difference.wrapping_add(half) >> shift) as i64),
            guard_bits,
        }
    }

    /// The value at the current step, rounded to the nearest unit, halves up. Where values do not fit, this is some number.
    #[inline]
    pub fn value(&self) -> i64 {
        let value = self.differences.first().copied().unwrap_or_default();
        let half = (1i64 << self.guard_bits) >> 1;
        value.wrapping_add(half) >> self.guard_bits
    }

    /// Moves on to the next value: adds to each difference the one of the next order.
    #[inline]
    pub fn advance(&mut self) {
        let mut differences = self.differences.iter_mut();
        let Some(mut lower) = differences.next() else { return };
        for higher in differences {
            *lower = lower.wrapping_add(*higher);
            lower = higher;
        }
    }
}

/// The most guard bits: the value keeps one bit and its sign.
const MOST_GUARD_BITS: u32 = 62;
/// The most fractional bits while differences are found: a coefficient has 32 bits more. They are at least 34 above the guard
/// bits, so that each difference is rounded once.
const MOST_SETUP_BITS: u32 = 96;

/// The differences at 0, of order 0, 1 and so on, of `c[0] + c[1] k + c[2] k^2 + ...`, by Horner's rule.
///
/// With `q` the polynomial so far, those of `k q(k)` are `j * (D[j - 1] + D[j])`, which is what `combine` computes from
/// the pair and `j`.
fn difference_table<T: Copy + Default, const TERMS: usize>(
    coefficients: &[T; TERMS],
    combine: impl Fn((T, T), usize) -> T,
) -> [T; TERMS] {
    let mut table = [T::default(); TERMS];
    for &coefficient in coefficients.iter().rev() {
        let mut lower = T::default();
        for (order, difference) in table.iter_mut().enumerate() {
            let own = *difference;
            *difference = combine((lower, own), order);
            lower = own;
        }
        // That of order 0 was left at 0: the value of `k q(k)` there.
        if let Some(value) = table.first_mut() {
            *value = coefficient;
        }
    }
    table
}
