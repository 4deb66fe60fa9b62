//! Perspective projection: one division per vertex, then multiplications.

use fixed::types::I16F16;

use crate::view::{Camera, DepthWidth, EyePoint, ScreenPrecision};

/// A vertex on the screen: position in units of the precision, and depth. 6 bytes with `Sub4` and `u16`.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
pub(crate) struct ScreenVertex<S: ScreenPrecision, D: DepthWidth> {
    pub(crate) x: S::Units,
    pub(crate) y: S::Units,
    pub(crate) z: D,
}

impl<S: ScreenPrecision, D: DepthWidth> ScreenVertex<S, D> {
    #[inline(always)]
    pub(crate) fn position(&self) -> Position {
        Position {
            x: self.x.into(),
            y: self.y.into(),
        }
    }

    #[inline(always)]
    pub(crate) fn x_units(&self) -> i32 {
        self.x.into()
    }

    #[inline(always)]
    pub(crate) fn y_units(&self) -> i32 {
        self.y.into()
    }
}

/// A place on the screen in units of its precision.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct Position {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

/// A projected vertex that may lie outside the guard band.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct WideVertex {
    pub(crate) x: i64,
    pub(crate) y: i64,
    /// Depth units.
    pub(crate) z: i32,
}

/// The numbers that a camera and a precision fix for a frame.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Projection<S, D> {
    /// Near plane in 1/4096 unit.
    pub(crate) near: i32,
    /// The same as 16 bits and a shift.
    near_mantissa: u32,
    near_exponent: u32,
    /// Units of the precision.
    focal_length: i32,
    /// Greatest x/z whose product with the focal length fits 30 bits.
    greatest_ratio: u32,
    center_x: i32,
    center_y: i32,
    formats: core::marker::PhantomData<(S, D)>,
}

impl<S: ScreenPrecision, D: DepthWidth> Projection<S, D> {
    /// Whether 16-bit reciprocals are too coarse: with 1/256 pixel or 24-bit depth.
    const WIDE: bool = S::FRACTION_BITS > 4 || D::FRACTION_BITS < 16;
    /// Fractional bits of x/z.
    const RATIO_BITS: u32 = if Self::WIDE { 24 } else { 15 };

    pub(crate) fn new(camera: &Camera) -> Self {
        let viewport = camera.viewport();
        let half_unit = 1 << (S::FRACTION_BITS - 1);
        // Twice the centre of the viewport, minus the half pixel from u to x; below 2^15 times 2^8.
        let center = |start: i32, end: i32| (start + end - 1) * half_unit;
        // The camera checked it: at least 8 units, which is 2^15 here.
        let near = camera.near().to_bits() >> 4;
        let near_exponent = exponent(near);
        let focal_length = camera.focal_length().to_bits() >> (16 - S::FRACTION_BITS);
        Self {
            near,
            // Rounded down, so that it times a reciprocal stays below 2^32.
            near_mantissa: near as u32 >> near_exponent,
            near_exponent,
            focal_length,
            // At least one pixel, so no division by zero.
            greatest_ratio: (1 << 30) / focal_length as u32,
            center_x: center(viewport.left, viewport.right),
            center_y: center(viewport.top, viewport.bottom),
            formats: core::marker::PhantomData,
        }
    }

    /// The vertex, which must not be in front of the near plane, rounded once to units of the precision.
    ///
    /// `Sub4` with `u16` takes a 16-bit reciprocal: x/z is right to 2^-15 of itself. Otherwise the reciprocal has 32
    /// bits and one 64-bit division. Neither wraps: |x| < 2^30 and z >= 2^15.
    #[inline(always)]
    pub(crate) fn project(&self, eye: EyePoint) -> WideVertex {
        let (ratio_x, ratio_y, near_over_z) = self.ratios(eye);
        WideVertex {
            x: i64::from(self.center_x) + self.screen_units(ratio_x),
            y: i64::from(self.center_y) - self.screen_units(ratio_y),
            z: D::from_near_over_z(near_over_z).units(),
        }
    }

    /// The same integers where they lie in the domain of the precision.
    #[inline(always)]
    pub(crate) fn project_inside(&self, eye: EyePoint) -> Option<ScreenVertex<S, D>> {
        let (x, y, z) = if Self::WIDE {
            let WideVertex { x, y, z } = self.project(eye);
            (i32::try_from(x).ok()?, i32::try_from(y).ok()?, D::from_units(z))
        } else {
            let (ratio_x, ratio_y, near_over_z) = self.narrow_ratios(eye);
            if ratio_x.unsigned_abs().max(ratio_y.unsigned_abs()) > self.greatest_ratio {
                return None;
            }
            let screen_units = |ratio: i32| {
                let half = 1 << (Self::RATIO_BITS - 1);
                ratio.wrapping_mul(self.focal_length).wrapping_add(half) >> Self::RATIO_BITS
            };
            let x = self.center_x.wrapping_add(screen_units(ratio_x));
            let y = self.center_y.wrapping_sub(screen_units(ratio_y));
            (x, y, D::from_near_over_z(near_over_z))
        };
        let greatest = S::MAX_UNITS.wrapping_sub(S::MIN_UNITS) as u32;
        let from_least = |units: i32| units.wrapping_sub(S::MIN_UNITS) as u32;
        (from_least(x) <= greatest && from_least(y) <= greatest).then(|| ScreenVertex {
            x: S::narrow(x),
            y: S::narrow(y),
            z,
        })
    }

    /// Depth of a plane at that distance; the near plane's for anything nearer.
    pub(crate) fn depth_at(&self, distance: I16F16) -> D {
        let z = (distance.to_bits() >> 4).max(self.near);
        D::from_near_over_z(self.ratios(EyePoint { x: 0, y: 0, z }).2)
    }

    /// x/z and y/z with `RATIO_BITS`, near/z with 31 bits.
    #[inline(always)]
    fn ratios(&self, eye: EyePoint) -> (i64, i64, u32) {
        if Self::WIDE {
            let shift = (eye.z as u32).leading_zeros();
            // z normalised to 32 bits: the reciprocal lies between 2^31 and 2^32.
            let reciprocal = (1u64 << 63) / u64::from((eye.z as u32) << shift);
            let ratio = |value: i32| (i64::from(value) * reciprocal as i64) >> (39 - shift);
            let near_over_z = (self.near as u64 * reciprocal) >> (32 - shift);
            (ratio(eye.x), ratio(eye.y), near_over_z as u32)
        } else {
            let (x, y, near_over_z) = self.narrow_ratios(eye);
            (x.into(), y.into(), near_over_z)
        }
    }

    /// The same in 32-bit arithmetic, with 15 bits.
    #[inline(always)]
    fn narrow_ratios(&self, eye: EyePoint) -> (i32, i32, u32) {
        let exponent = exponent(eye.z);
        // Between 2^15 and 2^16, rounded.
        let mantissa = mantissa(eye.z, exponent);
        let reciprocal = ((1u32 << 31).wrapping_add(mantissa >> 1))
            .checked_div(mantissa)
            .unwrap_or(0);
        let near_over_z = self
            .near_mantissa
            .wrapping_mul(reciprocal)
            .wrapping_shr(exponent.wrapping_sub(self.near_exponent));
        (
            multiply_high_16(eye.x, reciprocal) >> exponent,
            multiply_high_16(eye.y, reciprocal) >> exponent,
            near_over_z,
        )
    }

    #[inline(always)]
    fn screen_units(&self, ratio: i64) -> i64 {
        let half = 1 << (Self::RATIO_BITS - 1);
        // Below 2^15 in size with 24 more bits, times a focal length below 2^19.
        (ratio * i64::from(self.focal_length) + half) >> Self::RATIO_BITS
    }
}

/// Power of two that brings a number from 2^15 to 2^30 down to 16 bits.
#[inline(always)]
fn exponent(value: i32) -> u32 {
    16u32.saturating_sub(value.leading_zeros())
}

/// The number over that power of two, rounded: 2^15 to 2^16.
#[inline(always)]
fn mantissa(value: i32, exponent: u32) -> u32 {
    let half = (1u32 << exponent) >> 1;
    (value as u32).wrapping_add(half) >> exponent
}

/// value * factor / 2^16, from 32-bit products: |value| < 2^30 and factor <= 2^16.
#[inline(always)]
fn multiply_high_16(value: i32, factor: u32) -> i32 {
    let high = (value >> 16).wrapping_mul(factor as i32);
    let low = (value as u32 & 0xffff).wrapping_mul(factor) >> 16;
    high.wrapping_add(low as i32)
}
