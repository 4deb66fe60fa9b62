//! Sub-pixel positions as a type parameter, so that what accuracy costs can be measured.
//!
//! A position is snapped once, where it enters the library; everything after that uses the snapped integers.

use core::fmt::Debug;

use embedded_graphics::geometry::Point;
use fixed::types::{I12F4, I24F8};

use crate::geometry::InputError;

/// A sub-pixel precision: [`Sub4`] or [`Sub8`].
///
/// A function that is generic over the precision, called with coordinates at 1/16 and at 1/256 pixel:
///
/// ```
/// use zrow::geometry::{InputError, Sub4, Sub8, SubPixel, SubPoint};
///
/// /// A position that a touch controller reports in 1/4 pixel.
/// fn touched<S: SubPixel>([x, y]: [u16; 2]) -> Result<SubPoint<S>, InputError> {
///     let units = |quarters: u16| i32::from(quarters) << (S::FRACTION_BITS - 2);
///     SubPoint::from_units(units(x), units(y))
/// }
///
/// assert_eq!(touched::<Sub4>([10, 321])?.x_units(), 40);
/// assert_eq!(touched::<Sub8>([10, 321])?.x_units(), 640);
/// # Ok::<(), InputError>(())
/// ```
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
///
/// Half the memory of [`Sub8`], for what stays on a small panel:
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use zrow::{
///     draw::{FillRule, Polygon, PrimitiveStyle},
///     geometry::{InputError, Sub4, SubPoint},
/// };
///
/// // From half a pixel to 3.5 pixels: its sides are those of the pixels 1 to 3.
/// let at = SubPoint::<Sub4>::from_units;
/// let corners = [at(8, 8)?, at(56, 8)?, at(56, 56)?, at(8, 56)?];
/// assert_eq!(size_of_val(&corners), 4 * 4);
/// let contours = [corners.as_slice()];
/// let square = Polygon::new(&contours, FillRule::NonZero).prepare::<2, 2>()?;
/// let mut display = MockDisplay::new();
/// let Ok(()) = square.into_styled(PrimitiveStyle::with_fill(BinaryColor::On)).draw(&mut display);
/// display.assert_pattern(&["    ", " ###", " ###", " ###"]);
/// assert!(SubPoint::<Sub4>::from_pixel(Point::new(1024, 0)).is_err());
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sub4;

/// 24.8 fixed point in 32 bits: 1/256 pixel, domain -8191 to 8191 pixels, set-up in 64-bit arithmetic.
///
/// The eight fractional bits of Direct3D 11 and most Vulkan devices.
///
/// Fine enough for a needle that moves by less than a pixel from frame to frame:
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::{band::Band, draw::FilteredLine, geometry::{Sub8, SubPoint}};
///
/// let at = SubPoint::<Sub8>::from_units;
/// let needle_at = |x: i32| -> Result<[u8; 5], Box<dyn core::error::Error>> {
///     let mut row = [0; 5];
///     let mut band = Band::<Gray8>::new(Rectangle::new(Point::new(0, 20), Size::new(5, 1)), &mut row)?;
///     let Ok(()) = FilteredLine::new(at(x, 0)?, at(x, 40 * 256)?)?.draw(&mut band, Gray8::WHITE);
///     Ok(row)
/// };
/// assert_eq!(needle_at(2 * 256)?, [0, 28, 199, 28, 0]);
/// // 1/8 pixel farther right.
/// assert_eq!(needle_at(2 * 256 + 32)?, [0, 14, 194, 47, 0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
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
///
/// ```
/// use embedded_graphics::prelude::*;
/// use zrow::fixed::types::I24F8;
/// use zrow::geometry::{InputError, Sub8, SubPoint};
///
/// /// Where a chart has a reading: a column each, and 0 to 4095 on 100 rows upwards.
/// fn of_reading(column: i32, reading: u16) -> Result<SubPoint<Sub8>, InputError> {
///     SubPoint::from_units(256 * column, 256 * 100 - i32::from(reading) * (256 * 100) / 4096)
/// }
///
/// let half = of_reading(3, 2048)?;
/// assert_eq!(half, SubPoint::from_pixel(Point::new(3, 50))?);
/// assert_eq!(of_reading(4, 2064)?.y, I24F8::from_num(49.609375));
/// assert_eq!(of_reading(9000, 0), Err(InputError::OutOfDomain { min: -8191, max: 8191 }));
/// # Ok::<(), InputError>(())
/// ```
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
