//! Any sub-pixel precision, to see what fewer or more bits than the library's do.

use zrow::geometry::{FixedPointWindow, InputError, SubPixel, SubPoint, Window};

/// So many fractional bits in 32, for 8191 pixels on each side; at most 16.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Fraction<const BITS: u32>;

impl<const BITS: u32> SubPixel for Fraction<BITS> {
    type Coordinate = i32;
    const FRACTION_BITS: u32 = BITS;
    const MIN_UNITS: i32 = -8191 << BITS;
    const MAX_UNITS: i32 = 8191 << BITS;

    fn from_units(units: i32) -> Option<i32> {
        (Self::MIN_UNITS..=Self::MAX_UNITS).contains(&units).then_some(units)
    }

    fn units(coordinate: i32) -> i32 {
        coordinate
    }
}

/// The window between the centres of pixels, and half a pixel larger above and below, or left and right.
///
/// # Errors
/// It is too large.
pub fn clip_window<const BITS: u32>(
    window: &Window,
    (beside, above): (bool, bool),
) -> Result<FixedPointWindow<Fraction<BITS>>, InputError> {
    let half = |grown| if grown { (1 << BITS) / 2 } else { 0 };
    let corner = |x: i32, y: i32, sign: i32| {
        SubPoint::from_units((x << BITS) + sign * half(beside), (y << BITS) + sign * half(above))
    };
    FixedPointWindow::new(
        corner(window.left, window.top, -1)?,
        corner(window.right - 1, window.bottom - 1, 1)?,
    )
}
