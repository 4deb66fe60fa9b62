//! A number times a fraction, in 64-bit arithmetic.

/// `number * part / whole` to the nearest, ties upwards, and whether it was a tie; for `part <= whole` and a `whole` that is not 0.
///
/// The product may have 128 bits. So quotient and remainder are built up over the bits of `number`, from the highest on: both are
/// doubled, and `part` is added to the remainder where the bit is set. The remainder is kept below `whole` without a sum that
/// exceeds it.
pub(super) fn scale_nearest(number: u64, part: u64, whole: u64) -> (u64, bool) {
    let (mut quotient, mut remainder) = (0u64, 0u64);
    // Where the sum would reach `whole`, that is taken off, and the quotient gains one.
    let add = |remainder: u64, more: u64, quotient: u64| {
        let to_carry = whole - more;
        if remainder >= to_carry {
            (remainder - to_carry, quotient + 1)
        } else {
            (remainder + more, quotient)
        }
    };
    for bit in (0..64u32 - number.leading_zeros()).rev() {
        (remainder, quotient) = add(remainder, remainder, quotient << 1);
        if (number >> bit) & 1 != 0 {
            (remainder, quotient) = add(remainder, part, quotient);
        }
    }
    let rest = whole - remainder;
    (quotient + u64::from(remainder >= rest), remainder == rest)
}
