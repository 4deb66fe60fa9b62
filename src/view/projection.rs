//! Perspective projection: one division per vertex, then multiplications.

use core::num::{NonZeroU32, NonZeroU64};

use fixed::types::I16F16;

use crate::{
    geometry::{leading_zeros, multiply_high_16, reciprocal_16},
    view::{Camera, DepthWidth, EyePoint, ScreenPrecision},
};

// Not re-exported.
/// A vertex on the screen: position in units of the precision, and depth. 6 bytes with `Sub4` and `u16`.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScreenVertex<S: ScreenPrecision, D: DepthWidth> {
    pub(crate) x: S::Units,
    pub(crate) y: S::Units,
    pub(crate) z: D,
}

impl<S: ScreenPrecision, D: DepthWidth> ScreenVertex<S, D> {
    #[inline]
    pub(crate) fn position(&self) -> Position {
        Position {
            x: self.x.into(),
            y: self.y.into(),
        }
    }

    #[inline]
    pub(crate) fn x_units(&self) -> i32 {
        self.x.into()
    }

    #[inline]
    pub(crate) fn y_units(&self) -> i32 {
        self.y.into()
    }
}

/// A position on the screen in units of its precision, or the way from one to another.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct Position {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

impl Position {
    #[inline]
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
        }
    }

    #[inline]
    pub(crate) fn minus(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
        }
    }
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
    /// The near plane's distance as 16 bits and a shift. Where rays are parallel, only the shift: that of the way to the far
    /// plane.
    near_mantissa: u32,
    pub(super) depth_exponent: u32,
    /// Focal length in units of the precision. Where rays are parallel, pixels a unit with 24 fractional bits.
    pub(super) scale: i32,
    pub(super) center_x: i32,
    pub(super) center_y: i32,
    /// The picture's centre plus half a unit, with `RATIO_BITS` fractional bits, for rounding in 32-bit arithmetic.
    rounded_center_x: i32,
    rounded_center_y: i32,
    /// The greatest x/z and y/z in size that stay inside the guard band, taken to its nearest side.
    greatest_ratio: u32,
    /// Far plane in 1/4096 unit; 0 where there is none. After what each vertex takes, which is loaded together.
    pub(crate) far: i32,
    formats: core::marker::PhantomData<(S, D)>,
}

/// The centre of the picture in units of a precision, minus the half pixel from u to x, rounded to the nearest: below 2^14
/// times 2^8.
#[inline]
pub(super) fn center<S: ScreenPrecision>(camera: &Camera) -> [i32; 2] {
    let half_unit = 1 << (S::FRACTION_BITS - 1);
    let (viewport, [x, y]) = (camera.viewport(), camera.offset());
    // Twice the middle of the viewport, minus a pixel; below 2^15 times 2^8.
    let units = |start: i32, end: i32, offset: I16F16| {
        (start + end - 1) * half_unit + ((offset.to_bits() + (1 << (15 - S::FRACTION_BITS))) >> (16 - S::FRACTION_BITS))
    };
    [
        units(viewport.left, viewport.right, x),
        units(viewport.top, viewport.bottom, y),
    ]
}

impl<S: ScreenPrecision, D: DepthWidth> Projection<S, D> {
    /// A projection whose numbers are all 0.
    pub(super) const ZERO: Self = Self {
        near: 0,
        far: 0,
        near_mantissa: 0,
        depth_exponent: 0,
        scale: 0,
        center_x: 0,
        center_y: 0,
        rounded_center_x: 0,
        rounded_center_y: 0,
        greatest_ratio: 0,
        formats: core::marker::PhantomData,
    };

    /// Whether 16-bit reciprocals are too coarse: with 1/256 pixel or 24-bit depth.
    const WIDE: bool = S::FRACTION_BITS > 4 || D::FRACTION_BITS < 16;
    /// Fractional bits of x/z.
    const RATIO_BITS: u32 = if Self::WIDE { 24 } else { 15 };

    pub(crate) fn new(camera: &Camera) -> Self {
        // The camera checked it: at least 8 units, which is 2^15 here.
        let near = camera.near().to_bits() >> 4;
        let depth_exponent = exponent(near);
        let focal_length = camera.focal_length().to_bits() >> (16 - S::FRACTION_BITS);
        let [center_x, center_y] = center::<S>(camera);
        // One unit is left for rounding.
        let distance = |center: i32| (S::MAX_UNITS - center).min(center - S::MIN_UNITS).max(1) - 1;
        let distance = distance(center_x).min(distance(center_y)) as u64;
        // The camera checked it: at least one pixel.
        let divisor = NonZeroU64::new(focal_length as u64).unwrap_or(NonZeroU64::MIN);
        let greatest_ratio = (distance << Self::RATIO_BITS) / divisor;
        // Only used with 15 bits, where it stays below 2^30.
        let rounded = |center: i32| center << Self::RATIO_BITS | 1 << (Self::RATIO_BITS - 1);
        Self {
            near,
            // Rounded down, so that it times a reciprocal stays below 2^32.
            near_mantissa: near as u32 >> depth_exponent,
            depth_exponent,
            scale: focal_length,
            center_x,
            center_y,
            rounded_center_x: rounded(center_x),
            // y grows downwards, so the half is rounded the other way.
            rounded_center_y: rounded(center_y) - 1,
            greatest_ratio: greatest_ratio.min(1 << 30) as u32,
            far: camera.far_or_zero().to_bits() >> 4,
            formats: core::marker::PhantomData,
        }
    }

    /// Projects a vertex, which must not be in front of the near plane; rounded once to units of the precision.
    ///
    /// `Sub4` with `u16` takes a 16-bit reciprocal: x/z is right to 2^-15, and to 2^-15 of itself. Otherwise the reciprocal has 32
    /// bits and one 64-bit division. Neither wraps: |x| < 2^30 and z >= 2^15.
    #[inline]
    pub(crate) fn project(&self, eye: EyePoint) -> WideVertex {
        let (ratio_x, ratio_y, near_over_z) = self.ratios(eye);
        WideVertex {
            x: i64::from(self.center_x) + self.screen_units(ratio_x),
            y: i64::from(self.center_y) - self.screen_units(ratio_y),
            z: D::from_near_over_z(near_over_z).units(),
        }
    }

    /// Projects a vertex to the same integers as [`project`](Self::project). `None` where the vertex is further from
    /// the centre of the picture than the nearest side of the guard band is.
    #[inline]
    pub(crate) fn project_inside(&self, eye: EyePoint) -> Option<ScreenVertex<S, D>> {
        if Self::WIDE {
            let WideVertex { x, y, z } = self.project(eye);
            let domain = i64::from(S::MIN_UNITS)..=i64::from(S::MAX_UNITS);
            return (domain.contains(&x) && domain.contains(&y)).then(|| ScreenVertex {
                x: S::narrow(x as i32),
                y: S::narrow(y as i32),
                z: D::from_units(z),
            });
        }
        let (ratio_x, ratio_y, near_over_z) = self.narrow_ratios(eye);
        let greatest = self.greatest_ratio;
        // As an unsigned number, a ratio below the least one is far above the greatest: one comparison tests both
        // limits. Ratios are below 2^30 in size.
        let from_least = |ratio: i32| (ratio + greatest as i32) as u32;
        if from_least(ratio_x).max(from_least(ratio_y)) > greatest << 1 {
            return None;
        }
        // A product below 2^14 units, a centre below that, and 15 bits: below 2^30.
        let x = self.rounded_center_x + ratio_x * self.scale;
        let y = self.rounded_center_y - ratio_y * self.scale;
        Some(ScreenVertex {
            x: S::narrow(x >> Self::RATIO_BITS),
            y: S::narrow(y >> Self::RATIO_BITS),
            z: D::from_near_over_z(near_over_z),
        })
    }

    /// Depth of a plane at that distance; the near plane's for anything nearer.
    pub(crate) fn depth_at(&self, distance: I16F16) -> D {
        let z = (distance.to_bits() >> 4).max(self.near);
        D::from_near_over_z(self.ratios(EyePoint { x: 0, y: 0, z }).2)
    }

    /// The ratios x/z and y/z with `RATIO_BITS` fractional bits, and near/z with 31.
    #[inline]
    fn ratios(&self, eye: EyePoint) -> (i64, i64, u32) {
        if Self::WIDE {
            let shift = (eye.z as u32).leading_zeros();
            // z normalised to 32 bits: the reciprocal lies between 2^31 and 2^32. The highest bit is set anyway, but so that
            // the type says that there is no division by 0.
            const HIGHEST_BIT: NonZeroU32 = NonZeroU32::new(1 << 31).unwrap();
            let normalized = HIGHEST_BIT | (eye.z as u32) << shift;
            let reciprocal = (1u64 << 63) / NonZeroU64::from(normalized);
            let ratio = |value: i32| (i64::from(value) * reciprocal as i64) >> (39 - shift);
            let near_over_z = (self.near as u64 * reciprocal) >> (32 - shift);
            (ratio(eye.x), ratio(eye.y), near_over_z as u32)
        } else {
            let (x, y, near_over_z) = self.narrow_ratios(eye);
            (x.into(), y.into(), near_over_z)
        }
    }

    /// The ratios x / z, y / z and near / z in 32-bit arithmetic, with 15 bits.
    #[inline]
    fn narrow_ratios(&self, eye: EyePoint) -> (i32, i32, u32) {
        let exponent = exponent(eye.z);
        let mantissa = mantissa(eye.z, exponent);
        // The mantissa is not 0 for a vertex behind the near plane.
        let reciprocal = NonZeroU32::new(mantissa).map_or(0, |mantissa| reciprocal_16(mantissa, mantissa.get() >> 1));
        // No vertex is nearer than the near plane: its exponent is not smaller.
        let near_over_z = (self.near_mantissa * reciprocal) >> (exponent - self.depth_exponent);
        (
            multiply_high_16(eye.x, reciprocal) >> exponent,
            multiply_high_16(eye.y, reciprocal) >> exponent,
            near_over_z,
        )
    }

    /// Fractional bits of x / z that are right, also relative to its size.
    pub(super) const fn exact_ratio_bits(&self) -> u32 {
        if Self::WIDE { 23 } else { 15 }
    }

    #[inline]
    fn screen_units(&self, ratio: i64) -> i64 {
        let half = 1 << (Self::RATIO_BITS - 1);
        // Below 2^15 in size with 24 more bits, times a focal length below 2^19.
        (ratio * i64::from(self.scale) + half) >> Self::RATIO_BITS
    }
}

/// The right shift that brings a number from 2^15 to 2^30 down to 16 bits.
#[inline]
fn exponent(value: i32) -> u32 {
    (16 - leading_zeros(value as u32)) & 31
}

/// The number shifted right by its exponent, rounded: 2^15 to 2^16.
#[inline]
fn mantissa(value: i32, exponent: u32) -> u32 {
    let half = (1u32 << exponent) >> 1;
    (value as u32 + half) >> exponent
}

impl Camera {
    /// The stored depth of a plane at that distance, to draw at with the scene's depth.
    pub fn depth_at<S: ScreenPrecision, D: DepthWidth>(&self, distance: I16F16) -> D {
        Projection::<S, D>::new(self).depth_at(distance)
    }
}
