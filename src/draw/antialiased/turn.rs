//! Angles in a turn, their sines, and the number of edges that stand for a whole turn.

use core::num::NonZeroU32;

use fixed::types::U0F16;

use crate::view::sine;

/// Units of an angle in a whole turn, measured clockwise on the screen from the x axis.
pub(crate) const TURN: i32 = 1 << TURN_BITS;

/// Bits of an angle.
pub(crate) const TURN_BITS: u32 = 24;

/// Bits of an angle below 1/65,536 of a turn, the angles that have a sine.
pub(super) const MORE_BITS: u32 = 8;

/// Bits of the angles in a quarter of a turn that have a sine.
pub(super) const QUARTER_BITS: u32 = TURN_BITS - MORE_BITS - 2;

/// The cosine and the sine of an angle in [`TURN`]ths of a turn, in 2.30 fixed point: straight lines between those that
/// are 1/65,536 of a turn apart, less than 2^-29 off.
pub(crate) fn direction(angle: i32) -> [i32; 2] {
    // Angles are modulo a whole turn.
    [sine_of(angle + TURN / 4), sine_of(angle)]
}

/// The sine of an angle, as [`direction`] gives it.
pub(super) fn sine_of(angle: i32) -> i32 {
    let low = angle & ((1 << MORE_BITS) - 1);
    let at = |steps: i32| sine(U0F16::from_bits(((angle >> MORE_BITS) + steps) as u16)).to_bits();
    let first = at(0);
    if low == 0 {
        return first;
    }
    first + (((at(1) - first) * low + (1 << (MORE_BITS - 1))) >> MORE_BITS)
}

/// A length, in any unit below 2^31, times a number in 2.30 fixed point, rounded to the nearest; the same on both sides of 0.
pub(crate) fn scaled(length: u32, factor: i32) -> i32 {
    // The factor is at most 1.
    let size = round_products(i64::from(length) * i64::from(factor.unsigned_abs())) as i32;
    if factor < 0 { -size } else { size }
}

/// A product with a number in 2.30 fixed point, or a sum of such products, rounded to the nearest whole number; ties upwards.
pub(crate) const fn round_products(sum: i64) -> i64 {
    (sum + (1 << 29)) >> 30
}

/// The number of edges of a whole turn, so that no edge is further than 1/64 pixel from a circle of that radius in
/// 1/256 pixel: a multiple of four, from 8 to 1,612.
pub(crate) fn edges_of_turn(radius: u32) -> NonZeroU32 {
    const LEAST: NonZeroU32 = NonZeroU32::new(8).unwrap();
    // A chord over 1/n of a turn is r (1 - cos(pi / n)) off, or about r pi^2 / (2 n^2): n^2 must be 316 times the
    // radius in pixels.
    let least = u64::from(radius) * 316 / 256;
    let edges = (least.isqrt() as u32 + 4) & !3;
    NonZeroU32::new(edges).map_or(LEAST, |edges| edges.max(LEAST))
}
