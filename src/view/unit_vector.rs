//! Vectors of length 1, from vectors of any length: in integers, by a 64-bit square root.
//!
//! Guarantees: each coordinate is within 2^-28 of the true one, for every vector but the one of length 0.

use core::num::NonZeroU64;

use fixed::types::I2F30;

/// Bits of the greatest coordinate of a vector once it is [`scaled`]: the squares of four of them fit 64 bits.
const BITS: u32 = 30;

/// A vector times the power of two for which its greatest coordinate is between 2^29 and 2^30 in size; `None` where it has no
/// length. Coordinates of more than 30 bits are rounded to the nearest.
pub(super) fn scaled<const N: usize>(vector: [i64; N]) -> Option<[i64; N]> {
    let greatest = vector
        .iter()
        .fold(0, |greatest, value| greatest.max(value.unsigned_abs()));
    if greatest == 0 {
        return None;
    }
    let bits = u64::BITS - greatest.leading_zeros();
    Some(vector.map(|value| {
        if bits > BITS {
            // The half comes in last, where there is room for it.
            ((value >> (bits - BITS - 1)) + 1) >> 1
        } else {
            value << (BITS - bits)
        }
    }))
}

/// The vector of length 1 in the direction of a [`scaled`] vector, in 2.30.
///
/// The length is rounded to a whole number, which is at least 2^29: it is within 2^-30 of itself.
pub(super) fn unit<const N: usize>(scaled: [i64; N]) -> [I2F30; N] {
    let square = scaled.iter().map(|value| (value * value) as u64).sum::<u64>();
    let root = square.isqrt();
    let rounded = root + u64::from(square - root * root > root);
    // At least 2^29.
    let length = NonZeroU64::new(rounded).unwrap_or(NonZeroU64::MIN);
    scaled.map(|value| {
        let size = ((value.unsigned_abs() << 30) + length.get() / 2) / length;
        I2F30::from_bits(if value < 0 { -(size as i32) } else { size as i32 })
    })
}

/// The product of two vectors that is at right angles to both. Coordinates up to 2^30 give 62 bits at most.
pub(super) fn cross([a, b, c]: [i64; 3], [x, y, z]: [i64; 3]) -> [i64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
