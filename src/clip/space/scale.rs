//! Products of up to 128 bits that are cut or divided at once, in 64-bit arithmetic.

/// Fractional bits of a matrix whose elements are small.
pub(super) const FRACTION_BITS: u32 = 40;

/// `number * part / whole` to the nearest, ties upwards, and whether it was a tie; for `part <= whole` and a `whole` that is
/// not 0.
///
/// The product may have 128 bits. So quotient and remainder are built up over the bits of `number`, from the highest on: both
/// are doubled, and `part` is added to the remainder where the bit is set. The remainder is kept below `whole` without a sum
/// that exceeds it.
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

/// An element with 40 fractional bits, below 2^57, times a scale below 2^42, with the fractional bits of that scale: rounded
/// down.
///
/// The product has up to 99 bits, of which the lowest 40 are left out: it is put together from parts of 20 bits.
pub(super) fn scaled(element: i64, scale: i64) -> i64 {
    const PART: u32 = 20;
    let low = |number: i64| number & ((1 << PART) - 1);
    let (first, second) = (low(element), low(element >> PART));
    let tail = (first * scale) >> PART;
    let tail = (second * scale + tail) >> PART;
    // The whole bits of the element: below 2^17, times 2^42.
    (element >> FRACTION_BITS) * scale + tail
}
