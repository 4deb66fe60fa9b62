//! Sine and cosine of a binary angle: one odd polynomial for a quarter turn, in 2.30 fixed point.
//!
//! Guarantees, for each of the 65,536 angles: an error below 2^-27; quarter turns exactly; sin(-a) = -sin(a) and
//! cos(a) = sin(a + 1/4) exactly; between two quarter turns the values never go back. Cost: five multiplications.
//!
//! The polynomial is the one of its degree with the smallest largest error among those that are 1 at the quarter turn,
//! found by the exchange of Remez (1934), for the argument in quarter turns as Hart et al. (Computer Approximations, 1968)
//! have it.

use fixed::{
    Wrapping,
    types::{I2F30, U0F16},
};

use crate::geometry::multiply_shift;

/// Units of the angle in a quarter turn.
const QUARTER: u32 = 1 << 14;

/// The coefficients of x, x^3, x^5, x^7, x^9 in 2.30, for x in quarter turns. Their sum is 1. The error is 3.8e-9, which is
/// 2^-28.
const COEFFICIENTS: [i32; 5] = [1_686_629_669, -693_597_809, 85_564_576, -5_016_346, 161_734];

/// The sine of an angle, in 2.30 fixed point.
#[inline(never)]
pub(crate) fn sine(angle: U0F16) -> I2F30 {
    let bits = u32::from(angle.to_bits());
    let position = bits & (QUARTER - 1);
    let falls = bits & QUARTER != 0;
    let x = if falls { QUARTER - position } else { position };
    let size = of_first_quarter(x as i32);
    // The sign comes last: rounding is the same on both sides of 0.
    let is_negative = bits & (2 * QUARTER) != 0;
    I2F30::from_bits(if is_negative { -size } else { size })
}

/// The cosine of an angle, in 2.30 fixed point.
pub(crate) fn cosine(angle: U0F16) -> I2F30 {
    // Angles are modulo a whole turn.
    let quarter = Wrapping(U0F16::from_bits(QUARTER as u16));
    sine((Wrapping(angle) + quarter).0)
}

/// The sine in 2.30 for an angle from 0 to a quarter turn.
#[inline]
fn of_first_quarter(x: i32) -> i32 {
    // 2.14 squared is 4.28, exactly. At the quarter turn it is 1, and the sum is that of the coefficients.
    let square = x * x;
    let [lower @ .., highest] = COEFFICIENTS;
    let sum = lower.iter().rev().fold(highest, |sum, &coefficient| {
        coefficient + multiply_shift(sum, square, 28)
    });
    multiply_shift(sum, x, 14)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::COEFFICIENTS;

    /// How far the polynomial is from the sine, in units of 2.30.
    fn error(x: f64) -> f64 {
        let value = COEFFICIENTS
            .iter()
            .rev()
            .fold(0.0, |sum, &coefficient| sum * x * x + f64::from(coefficient));
        value * x - (x * core::f64::consts::FRAC_PI_2).sin() * f64::from(1 << 30)
    }

    /// Once the sum is 1, four coefficients are free. An error that alternates five times between the same size of both
    /// signs is then the smallest possible; where the five sizes differ, the smallest possible lies between them (de la
    /// Vallée Poussin 1919). Here they differ by the rounding of the coefficients.
    #[test]
    fn the_polynomial_is_the_best_of_its_degree() {
        assert_eq!(COEFFICIENTS.iter().sum::<i32>(), 1 << 30);
        let steps = 1 << 14;
        let errors = (1..steps).map(|step| error(f64::from(step) / f64::from(steps)));
        let mut extremes = [0f64; 6];
        let mut wave = 0;
        for error in errors {
            if extremes[wave] * error < 0.0 {
                wave += 1;
            }
            if error.abs() > extremes[wave].abs() {
                extremes[wave] = error;
            }
        }
        let [extremes @ .., none] = extremes.map(f64::abs);
        let (least, most) = extremes.iter().fold((f64::MAX, 0f64), |(least, most), &extreme| {
            (least.min(extreme), most.max(extreme))
        });
        assert!(none == 0.0 && least > 3.7 && most < 4.3, "{extremes:?} {none}");
    }
}
