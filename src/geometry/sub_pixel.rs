//! Sub-pixel positions as a type parameter, so that what accuracy costs can be measured.
//!
//! A position is snapped once, where it enters the library; everything after that uses the snapped integers.

use core::fmt::Debug;

use embedded_graphics::geometry::Point;
use fixed::types::{I12F4, I24F8};

use crate::geometry::InputError;

/// A sub-pixel precision: [`Sub4`] or [`Sub8`].
pub trait SubPixel: Copy + Clone + Debug + Default + PartialEq + Eq + Send + Sync + 'static {
    /// The fixed-point type of a coordinate, in pixels.
    type Coordinate: Copy + Debug + Default + PartialEq + Eq + PartialOrd + Ord + Send + Sync;

    /// Fractional bits: a pixel is `1 << FRACTION_BITS` units.
    const FRACTION_BITS: u32;
    /// Smallest coordinate of the domain, in units.
    const MIN_UNITS: i32;
    /// Largest coordinate of the domain, in units.
    const MAX_UNITS: i32;

    /// The coordinate with that many units; `None` outside the domain.
    fn from_units(units: i32) -> Option<Self::Coordinate>;
    /// The units of a coordinate.
    fn units(coordinate: Self::Coordinate) -> i32;
}

/// 12.4 fixed point in 16 bits: 1/16 pixel, domain -1024 to 1023 pixels, set-up in 32-bit arithmetic.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sub4;

/// 24.8 fixed point in 32 bits: 1/256 pixel, domain -8191 to 8191 pixels, set-up in 64-bit arithmetic.
///
/// The eight fractional bits of Direct3D 11 and most Vulkan devices.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sub8;

impl SubPixel for Sub4 {
    type Coordinate = I12F4;
    const FRACTION_BITS: u32 = 4;
    const MIN_UNITS: i32 = -1024 * 16;
    const MAX_UNITS: i32 = 1023 * 16;

    fn from_units(units: i32) -> Option<I12F4> {
        // The domain check makes the narrowing exact.
        (Self::MIN_UNITS..=Self::MAX_UNITS)
            .contains(&units)
            .then(|| I12F4::from_bits(units as i16))
    }

    fn units(coordinate: I12F4) -> i32 {
        i32::from(coordinate.to_bits())
    }
}

impl SubPixel for Sub8 {
    type Coordinate = I24F8;
    const FRACTION_BITS: u32 = 8;
    const MIN_UNITS: i32 = -8191 * 256;
    const MAX_UNITS: i32 = 8191 * 256;

    fn from_units(units: i32) -> Option<I24F8> {
        (Self::MIN_UNITS..=Self::MAX_UNITS)
            .contains(&units)
            .then(|| I24F8::from_bits(units))
    }

    fn units(coordinate: I24F8) -> i32 {
        coordinate.to_bits()
    }
}

/// The smallest and the largest pixel coordinate of the domain of a precision.
pub(crate) const fn pixel_domain<S: SubPixel>() -> (i32, i32) {
    (S::MIN_UNITS >> S::FRACTION_BITS, S::MAX_UNITS >> S::FRACTION_BITS)
}

impl InputError {
    /// The error of a coordinate outside the domain of a precision.
    pub(crate) const fn out_of_domain<S: SubPixel>() -> Self {
        let (min, max) = pixel_domain::<S>();
        Self::OutOfDomain { min, max }
    }
}

/// A point at sub-pixel precision `S`, in pixels.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
pub struct SubPoint<S: SubPixel> {
    /// Column; grows to the right.
    pub x: S::Coordinate,
    /// Row in pixels; grows downwards.
    pub y: S::Coordinate,
}

impl<S: SubPixel> SubPoint<S> {
    /// The point with these units of `1 / (1 << S::FRACTION_BITS)` pixel.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a coordinate does not fit the precision.
    pub fn from_units(x: i32, y: i32) -> Result<Self, InputError> {
        match (S::from_units(x), S::from_units(y)) {
            (Some(x), Some(y)) => Ok(Self { x, y }),
            _ => Err(InputError::out_of_domain::<S>()),
        }
    }

    /// The centre of a pixel.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the pixel does not fit the precision.
    pub fn from_pixel(pixel: Point) -> Result<Self, InputError> {
        let unit = 1 << S::FRACTION_BITS;
        match (pixel.x.checked_mul(unit), pixel.y.checked_mul(unit)) {
            (Some(x), Some(y)) => Self::from_units(x, y),
            _ => Err(InputError::out_of_domain::<S>()),
        }
    }

    /// Column in units of the number format: 1/256 pixel for [`Sub8`], 1/16 pixel for [`Sub4`].
    pub fn x_units(&self) -> i32 {
        S::units(self.x)
    }

    /// Row in units of the number format: 1/256 pixel for [`Sub8`], 1/16 pixel for [`Sub4`].
    pub fn y_units(&self) -> i32 {
        S::units(self.y)
    }
}

#[cfg(feature = "defmt")]
impl<S: SubPixel> defmt::Format for SubPoint<S> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "({}, {})/{}",
            self.x_units(),
            self.y_units(),
            1u32 << S::FRACTION_BITS
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_domain_ends_are_in_and_the_next_unit_is_out() {
        assert!(SubPoint::<Sub4>::from_units(-16_384, 16_368).is_ok());
        assert_eq!(
            SubPoint::<Sub4>::from_units(0, 16_369),
            Err(InputError::OutOfDomain { min: -1024, max: 1023 })
        );
        assert!(SubPoint::<Sub8>::from_pixel(Point::new(8191, -8191)).is_ok());
        assert_eq!(
            SubPoint::<Sub8>::from_pixel(Point::new(i32::MAX, 0)),
            Err(InputError::OutOfDomain { min: -8191, max: 8191 })
        );
    }
}
