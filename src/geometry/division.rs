//! Division for set-up code: cheap with a divider, and without one.
//!
//! What cannot be 0 says so in its type, so that nothing here can panic. Both ways give the same integers. A core without
//! compare-and-swap (Cortex-M0) has no divider either, and a division there is a loop of some 130 instructions.

use core::num::{NonZeroU32, NonZeroU64, NonZeroU128, NonZeroUsize};

/// Whether the processor divides by itself.
pub(crate) const HAS_DIVIDER: bool = cfg!(target_has_atomic = "32");

/// The quotient, rounded down, and the remainder; fastest where the quotient is 0 or -1.
///
/// The denominator must not be negative; for 0 the numbers mean nothing, but nothing panics.
#[inline]
pub(crate) fn divide_floor(numerator: i32, denominator: i32) -> (i32, i32) {
    if numerator >= 0 {
        if numerator < denominator {
            return (0, numerator);
        }
    } else {
        let raised = numerator + denominator;
        if raised >= 0 {
            return (-1, raised);
        }
    }
    if HAS_DIVIDER {
        divide_floor_large(numerator, denominator)
    } else {
        by_subtraction(numerator, denominator)
    }
}

/// The quotient, rounded down, and the remainder, by one division: for quotients that are mostly large. The denominator must
/// not be negative; for 0 the numbers mean nothing, but nothing panics.
#[inline]
pub(crate) fn divide_floor_large(numerator: i32, denominator: i32) -> (i32, i32) {
    debug_assert!(denominator >= 0, "{numerator} / {denominator}");
    let quotient = if denominator > 0 { numerator / denominator } else { 0 };
    let remainder = numerator - quotient * denominator;
    if remainder < 0 {
        (quotient - 1, remainder + denominator)
    } else {
        (quotient, remainder)
    }
}

/// Quotient rounded towards 0, and remainder. The denominator must be positive; for another one the quotient is 0.
#[inline]
pub(crate) fn divide_to_zero(numerator: i32, denominator: i32) -> (i32, i32) {
    let quotient = if denominator > 0 { numerator / denominator } else { 0 };
    (quotient, numerator - quotient * denominator)
}

#[inline]
fn by_subtraction(numerator: i32, denominator: i32) -> (i32, i32) {
    const MOST_STEPS: i32 = 12;
    let mut remainder = numerator;
    if numerator < 0 {
        for quotient in 1..=MOST_STEPS {
            remainder += denominator;
            if remainder >= 0 {
                return (-quotient, remainder);
            }
        }
    } else {
        for quotient in 0..MOST_STEPS {
            if remainder < denominator {
                return (quotient, remainder);
            }
            remainder -= denominator;
        }
    }
    divide_floor_large(numerator, denominator)
}

/// The quotient modulo 2^32, and the remainder. A numerator that fits 32 bits takes a 32-bit division.
#[inline]
pub(crate) fn divide_wide(numerator: u64, denominator: NonZeroU32) -> (u32, u32) {
    let quotient = match u32::try_from(numerator) {
        Ok(numerator) => numerator / denominator,
        Err(_) => (numerator / NonZeroU64::from(denominator)) as u32,
    };
    // The remainder is less than the denominator, so the lower 32 bits are enough, and what wraps above them cancels.
    let remainder = (numerator as u32).wrapping_sub(quotient.wrapping_mul(denominator.get()));
    (quotient, remainder)
}

/// The quotient, rounded down, which must fit 32 bits, such as a number of steps. A numerator that fits 32 bits takes a
/// 32-bit division.
pub(crate) fn quotient_down(numerator: u64, denominator: NonZeroU32) -> u32 {
    divide_wide(numerator, denominator).0
}

/// Quotient rounded up that fits 32 bits; the numerator is at most (2^32 - 1)^2, so that the sum fits.
pub(crate) fn quotient_up(numerator: u64, denominator: NonZeroU32) -> u32 {
    quotient_down(numerator + u64::from(denominator.get() - 1), denominator)
}

/// Quotient rounded to the nearest, halves away from 0, so that the opposite numerator has the opposite quotient.
pub(crate) fn quotient_nearest(numerator: i64, denominator: NonZeroU64) -> i64 {
    let quotient = ((numerator.unsigned_abs() + denominator.get() / 2) / denominator) as i64;
    if numerator < 0 { -quotient } else { quotient }
}

/// Quotient rounded to the nearest, halves up, in 128 bits.
pub(crate) fn quotient_nearest_long(numerator: i128, denominator: NonZeroU32) -> i128 {
    let numerator = numerator + i128::from(denominator.get() / 2);
    // Rounding down is rounding towards zero between the complements.
    let sign = numerator >> 127;
    let quotient = (numerator ^ sign) as u128 / NonZeroU128::from(denominator);
    quotient as i128 ^ sign
}

/// The quotient, rounded down, modulo 2^32, and the remainder.
pub(crate) fn divide_floor_cut(numerator: i64, denominator: NonZeroU32) -> (i32, u32) {
    let (quotient, remainder) = divide_wide(numerator.unsigned_abs(), denominator);
    let quotient = quotient as i32;
    match (numerator < 0, remainder) {
        (false, _) => (quotient, remainder),
        // Modulo 2^32, and so is the negative of -2^31.
        (true, 0) => (quotient.wrapping_neg(), 0),
        (true, _) => (!quotient, denominator.get() - remainder),
    }
}

/// The quotient, rounded down, and the remainder. A numerator that fits 32 bits takes a 32-bit division.
#[inline]
pub(crate) fn divide_floor_wide(numerator: i64, denominator: NonZeroU32) -> (i64, u32) {
    // Rounding down is rounding towards zero between the complements.
    let sign = numerator >> 63;
    let magnitude = (numerator ^ sign) as u64;
    let (quotient, remainder) = match u32::try_from(magnitude) {
        Ok(magnitude) => (u64::from(magnitude / denominator), magnitude % denominator),
        Err(_) => {
            let denominator = NonZeroU64::from(denominator);
            (magnitude / denominator, (magnitude % denominator) as u32)
        }
    };
    let remainder = if sign < 0 {
        denominator.get() - 1 - remainder
    } else {
        remainder
    };
    (quotient as i64 ^ sign, remainder)
}

/// `value * part / whole`, rounded down, for a part that is not greater than the whole.
pub(crate) fn scale_floor(value: i64, part: u64, whole: NonZeroU64) -> i64 {
    debug_assert!(part <= whole.get());
    let product = i128::from(value) * i128::from(part);
    // Rounding down is rounding towards zero between the complements.
    let sign = (product >> 127) as i64;
    let magnitude = (product ^ i128::from(sign)) as u128;
    (magnitude / NonZeroU128::from(whole)) as i64 ^ sign
}

/// `number - origin` modulo the period: from 0 to `period - 1`, also where the difference is negative.
#[inline]
pub(crate) fn remainder_floor(number: i32, origin: i32, period: NonZeroUsize) -> usize {
    let distance = number.abs_diff(origin) as usize;
    if number >= origin {
        distance % period
    } else {
        // Rounding down is rounding towards zero between the complements.
        period.get() - 1 - (distance - 1) % period
    }
}

/// The quotient, rounded down, modulo 2^32, and the remainder. The denominator must be positive.
///
/// Shift and subtract, up to 600 instructions, for rare cases: the 64-bit division of the compiler's library takes a
/// kilobyte of flash.
#[inline(never)]
pub(crate) fn divide_long(numerator: i64, denominator: i32) -> (i32, i32) {
    debug_assert!(denominator > 0, "{numerator} / {denominator}");
    // Rounding down is rounding towards zero between the complements.
    let sign = (numerator >> 63) as i32;
    let magnitude = (numerator ^ i64::from(sign)) as u64;
    let denominator = denominator as u32;
    // The leading bits of the numerator, one fewer than the denominator has, are below the denominator and need no
    // step. The magnitude has at most 63 bits.
    let length = 64 - (magnitude | 1).leading_zeros();
    let steps = length.saturating_sub(31u32.saturating_sub(denominator.leading_zeros()));
    let mut rest = (magnitude >> steps) as u32;
    // The bits of the quotient enter where those of the numerator leave. The rest is below the denominator and that
    // below 2^31, so no shift loses a bit.
    let mut bits = (magnitude << 1) << (63 - steps);
    for _ in 0..steps {
        rest = rest << 1 | (bits >> 63) as u32;
        bits <<= 1;
        if rest >= denominator {
            rest -= denominator;
            bits |= 1;
        }
    }
    let complemented = denominator - 1 - rest;
    let rest = if sign < 0 { complemented } else { rest };
    (bits as i32 ^ sign, rest as i32)
}

/// (2^31 - 1 + rounding) / value, rounded down, for a value from 2^15 to 2^16: a reciprocal of 16 bits. `rounding` is 0, or
/// half the value.
#[inline]
pub(crate) fn reciprocal_16(value: NonZeroU32, rounding: u32) -> u32 {
    if HAS_DIVIDER {
        // At most 2^15 is added: it fits.
        (0x7fff_ffff + rounding) / value
    } else {
        reciprocal_16_by_newton(value.get(), rounding)
    }
}

/// [`reciprocal_16`] without a divider: a linear estimate (error 1/17), two Newton steps, and the last unit by
/// comparison.
#[inline(never)]
fn reciprocal_16_by_newton(value: u32, rounding: u32) -> u32 {
    // The product is near 2^31, on either side: as an `i32` the difference is exact, although it wraps as a `u32`.
    let error = |estimate: u32| (1u32 << 31).wrapping_sub(estimate * value) as i32;
    // 48/17 - 32/17 x, where x is the value in 1/2^16 and the result is in 1/2^15.
    let linear = 92_521 - ((value * 61_681) >> 16);
    let step = |estimate: u32, shift: u32| {
        let correction = (estimate as i32 * (error(estimate) >> shift)) >> (31 - shift);
        (estimate as i32 + correction) as u32
    };
    // What is missing is below 2^28, then below 2^24: products with 2^17 stay below 2^31.
    let mut estimate = step(step(linear, 14), 10);
    let mut rest = error(estimate) - 1 + rounding as i32;
    while rest < 0 {
        estimate -= 1;
        rest += value as i32;
    }
    while rest >= value as i32 {
        estimate += 1;
        rest -= value as i32;
    }
    estimate
}

/// 2^62 / value for a value of 32 bits whose top bit is set: one 32-bit division gives 15 bits, one Newton step doubles
/// them.
#[inline]
pub(crate) fn reciprocal_32(value: u32) -> i32 {
    let (high, low) = (value >> 16, value & 0xffff);
    // The top bit is set anyway, but so that the type says that this is not 0.
    const TOP_BIT: NonZeroU32 = NonZeroU32::new(1 << 15).unwrap();
    let estimate = reciprocal_16(TOP_BIT | high, 0);
    // What estimate * value misses of 2^47, in 2^16: between -2^16 and 2^16.
    let error = ((1 << 31) - estimate * high) as i32 - ((estimate * low) >> 16) as i32;
    let correction = ((estimate >> 1) as i32 * error) >> 15;
    (estimate << 15) as i32 + correction
}

/// value * factor / 2^16, rounded down: |value| < 2^30 and factor <= 2^16.
#[inline]
pub(crate) fn multiply_high_16(value: i32, factor: u32) -> i32 {
    debug_assert!(
        value.unsigned_abs() < 1 << 30 && factor <= 1 << 16,
        "{value} * {factor}"
    );
    if HAS_DIVIDER {
        multiply_shift(value, factor as i32, 16)
    } else {
        multiply_high_16_by_halves(value, factor)
    }
}

/// [`multiply_high_16`] by two 32-bit products, for processors where a 64-bit product is a function call.
#[inline]
fn multiply_high_16_by_halves(value: i32, factor: u32) -> i32 {
    let high = (value >> 16) * factor as i32;
    let low = ((value as u32 & 0xffff) * factor) >> 16;
    high + low as i32
}

/// left * right / 2^shift, rounded down, for a `right` that is not negative, a shift from 1 to 62, and a result of 32 bits.
#[inline]
pub(crate) fn multiply_shift(left: i32, right: i32, shift: u32) -> i32 {
    debug_assert!(right >= 0, "{left} * {right}");
    if HAS_DIVIDER {
        ((i64::from(left) * i64::from(right)) >> shift) as i32
    } else {
        multiply_shift_by_halves(left, right, shift)
    }
}

/// [`multiply_shift`] by four products of 16 by 16 bits, for processors where a 64-bit product is a function call.
#[inline(never)]
fn multiply_shift_by_halves(left: i32, right: i32, shift: u32) -> i32 {
    let (left_high, left_low) = (left >> 16, left & 0xffff);
    let (right_high, right_low) = (right >> 16, right & 0xffff);
    let low = left_low as u32 * right_low as u32;
    // Each product is below 2^31 in size, because `right` is not negative, and so is its sum with a carry below 2^16.
    let middle = left_high * right_low + (low >> 16) as i32;
    let other = left_low * right_high + (middle & 0xffff);
    let high = left_high * right_high + (middle >> 16) + (other >> 16);
    let low = (other as u32) << 16 | (low & 0xffff);
    if shift < 32 {
        (((high << 1) as u32) << (31 - shift) | low >> shift) as i32
    } else {
        high >> (shift - 32)
    }
}

/// Zero bits before the first one bit of a number that is not 0.
#[inline]
pub(crate) fn leading_zeros(value: u32) -> u32 {
    if HAS_DIVIDER {
        value.leading_zeros()
    } else {
        leading_zeros_by_halving(value)
    }
}

#[inline]
fn leading_zeros_by_halving(value: u32) -> u32 {
    // Two halvings, then one bit after the other: most numbers here have few bits left.
    let (mut value, mut zeros) = (value, 0);
    for half in [16, 8] {
        if value >> (32 - half) == 0 {
            value <<= half;
            zeros += half;
        }
    }
    while value as i32 > 0 {
        value <<= 1;
        zeros += 1;
    }
    zeros
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn newton_gives_every_quotient() {
        for value in 1 << 15..=1 << 16 {
            for rounding in [0, value / 2] {
                let expected = (0x7fff_ffff + rounding) / value;
                assert_eq!(reciprocal_16_by_newton(value, rounding), expected, "{value}");
                let value = NonZeroU32::new(value).unwrap();
                assert_eq!(reciprocal_16(value, rounding), expected, "{value}");
            }
        }
    }

    #[test]
    fn halving_counts_zeros() {
        for bit in 0..32 {
            for value in [1 << bit, (1 << bit) | 1, u32::MAX >> bit] {
                assert_eq!(leading_zeros_by_halving(value), value.leading_zeros());
                assert_eq!(leading_zeros(value), value.leading_zeros());
            }
        }
    }

    #[test]
    fn long_quotients_are_rounded_down() {
        let ends = [
            0,
            1,
            2,
            65_535,
            4_294_967_295,
            4_294_967_296,
            9_876_543_210_123,
            i64::MAX,
        ];
        for numerator in ends.into_iter().flat_map(|end| [end, !end]) {
            for denominator in [1, 2, 3, 65_536, 1_234_567_891, i32::MAX] {
                let wide = i64::from(denominator);
                let (whole, rest) = (numerator.div_euclid(wide), numerator.rem_euclid(wide));
                assert_eq!(divide_long(numerator, denominator), (whole as i32, rest as i32));
            }
        }
    }

    #[test]
    fn wide_quotients_are_cut_to_their_lower_half() {
        let numerators = [
            0,
            1,
            2,
            254,
            65_535,
            4_294_967_295,
            4_294_967_296,
            9_876_543_210_123,
            u64::MAX,
        ];
        for numerator in numerators {
            for denominator in [1, 2, 3, 65_536, 1 << 31, u32::MAX] {
                let wide = u64::from(denominator);
                let expected = ((numerator / wide) as u32, (numerator % wide) as u32);
                let denominator = NonZeroU32::new(denominator).unwrap();
                assert_eq!(divide_wide(numerator, denominator), expected);
            }
        }
    }

    #[test]
    fn wide_quotients_are_rounded_down() {
        let numerators = [
            0,
            1,
            2,
            254,
            65_535,
            4_294_967_295,
            4_294_967_296,
            9_876_543_210_123,
            i64::MAX,
        ];
        for numerator in numerators.into_iter().flat_map(|end| [end, !end]) {
            for denominator in [1, 2, 3, 65_536, 1 << 30, u32::MAX] {
                let wide = i64::from(denominator);
                let expected = (numerator.div_euclid(wide), numerator.rem_euclid(wide) as u32);
                let denominator = NonZeroU32::new(denominator).unwrap();
                assert_eq!(divide_floor_wide(numerator, denominator), expected);
            }
        }
    }

    #[test]
    fn scaled_numbers_are_rounded_down() {
        let values = [0, 1, 2, 3, 254, 4_294_967_296, 123_456_789_012, i64::MAX];
        let wholes = [1, 2, 3, 7, 1 << 35, u64::MAX];
        for value in values.into_iter().flat_map(|end| [end, !end]) {
            for whole in wholes {
                for part in [0, 1, 2, whole / 2, whole - 1, whole]
                    .into_iter()
                    .filter(|&part| part <= whole)
                {
                    let expected = (i128::from(value) * i128::from(part)).div_euclid(i128::from(whole));
                    let whole = NonZeroU64::new(whole).unwrap();
                    assert_eq!(i128::from(scale_floor(value, part, whole)), expected);
                }
            }
        }
    }

    #[test]
    fn the_reciprocal_is_right_to_28_bits() {
        // xorshift32 (Marsaglia 2003).
        let mut state = 0x0123_4567u32;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            state
        };
        for _ in 0..200_000 {
            let value = next() | 1 << 31;
            let exact = (1u128 << 62) as f64 / f64::from(value);
            let error = (f64::from(reciprocal_32(value)) - exact).abs() / exact;
            assert!(error <= 1.0 / f64::from(1 << 28), "{value}: {error}");
        }
    }

    #[test]
    fn remainders_repeat_on_both_sides_of_the_origin() {
        let ends = [i32::MIN, -1000, -7, -1, 0, 1, 6, 7, 1000, i32::MAX];
        for number in ends {
            for origin in ends {
                for period in [1, 2, 7, 1000, 1 << 31, usize::MAX] {
                    let distance = i128::from(number) - i128::from(origin);
                    let expected = distance.rem_euclid(period as i128) as usize;
                    let period = NonZeroUsize::new(period).unwrap();
                    assert_eq!(remainder_floor(number, origin, period), expected);
                }
            }
        }
    }

    #[test]
    fn halves_give_the_same_product() {
        let ends = [
            i32::MIN + 1,
            -65_537,
            -65_536,
            -65_535,
            -1,
            0,
            1,
            65_535,
            65_536,
            123_456_789,
            i32::MAX,
        ];
        for left in ends {
            for right in [1, 65_535, 65_536, 1 << 30, 1_987_654_321, i32::MAX] {
                for shift in 1..=62 {
                    let expected = (i64::from(left) * i64::from(right)) >> shift;
                    if let Ok(expected) = i32::try_from(expected) {
                        assert_eq!(
                            multiply_shift_by_halves(left, right, shift),
                            expected,
                            "{left} {right} {shift}"
                        );
                        assert_eq!(multiply_shift(left, right, shift), expected);
                    }
                }
            }
        }
    }

    #[test]
    fn halves_give_the_same_high_bits() {
        let most = (1 << 30) - 1;
        for value in (-most..=most)
            .step_by(99_991)
            .chain([-65_537, -65_536, -1, 0, 1, 65_535, most])
        {
            for factor in [1 << 15, 40_001, 65_535, 1 << 16] {
                let expected = (i64::from(value) * i64::from(factor)).div_euclid(1 << 16) as i32;
                assert_eq!(multiply_high_16_by_halves(value, factor), expected, "{value} {factor}");
                assert_eq!(multiply_high_16(value, factor), expected, "{value} {factor}");
            }
        }
    }

    #[test]
    fn quotients_are_rounded_to_zero() {
        let numbers = [i32::MIN, -65_537, -300, -1, 0, 1, 299, 300, 1 << 28, i32::MAX];
        for numerator in numbers {
            for denominator in numbers {
                let expected = if denominator > 0 {
                    (numerator / denominator, numerator % denominator)
                } else {
                    (0, numerator)
                };
                assert_eq!(divide_to_zero(numerator, denominator), expected);
            }
        }
    }

    #[test]
    fn subtraction_gives_the_same_as_division() {
        for denominator in [1i32, 2, 7, 300, 4_193_792] {
            for numerator in (-4_193_792i32..4_193_792).step_by(997).chain(-100..100) {
                let expected = (numerator.div_euclid(denominator), numerator.rem_euclid(denominator));
                assert_eq!(by_subtraction(numerator, denominator), expected);
                assert_eq!(divide_floor_large(numerator, denominator), expected);
                assert_eq!(divide_floor(numerator, denominator), expected);
            }
        }
    }
}
