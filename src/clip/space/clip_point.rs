//! Points in homogeneous clip coordinates, and their way to the screen: perspective division, then the map to the viewport.

use core::num::NonZeroU64;

use crate::{
    clip::space::scale::scale_nearest,
    geometry::{SubPixel, SubPoint},
    view::Camera,
};

/// A point in homogeneous clip coordinates: visible where -w <= x <= w, -w <= y <= w and 0 <= z <= w.
///
/// Numbers: 64-bit integers with the fractional bits of the [`ClipMatrix`](crate::clip::ClipMatrix) that made the point. Only
/// ratios matter: a point times any positive number is the same one.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ClipPoint {
    /// To the right: x / w is -1 at the left side of the viewport and 1 at the right one.
    pub x: i64,
    /// Up: y / w is -1 at the lower side of the viewport and 1 at the upper one.
    pub y: i64,
    /// Depth: z / w is 0 at the near plane and 1 at the far one.
    pub z: i64,
    /// Distance from the eye along the direction of sight: 0 beside the eye, negative behind it.
    pub w: i64,
}

impl ClipPoint {
    /// Whether the point is visible, the sides of the volume included.
    ///
    /// Takes any numbers.
    pub const fn is_inside(&self) -> bool {
        // `w` is not negative where it is not below `z`, so the cast keeps it.
        let w = self.w as u64;
        self.z >= 0 && self.z <= self.w && self.x.unsigned_abs() <= w && self.y.unsigned_abs() <= w
    }

    /// The position on the screen: divided by w, mapped to the camera's viewport, and rounded once, to the nearest unit (ties
    /// to the larger coordinate). `None` where w is not positive, because such a point has no picture, and outside the domain
    /// of `S`.
    ///
    /// The result is the nearest unit to the exact one. A scene's own vertices are within one unit of it, in the precision
    /// that they are projected in, where that precision has half a unit: not near the eye, or with a long focal length.
    ///
    /// Takes any numbers. Cost: two divisions of 64 bits, and a step for each bit of the viewport's size in units.
    ///
    /// Source: the perspective division of Roberts 1963 and 1965.
    pub fn on_screen<S: SubPixel>(&self, camera: &Camera) -> Option<SubPoint<S>> {
        let w = u64::try_from(self.w).ok().and_then(NonZeroU64::new)?;
        let viewport = camera.viewport();
        let half_unit = 1 << (S::FRACTION_BITS - 1);
        // Twice the centre of the viewport, minus the half pixel from its sides to the centre of the first pixel.
        let center = |start: i32, end: i32| i64::from((start + end - 1) * half_unit);
        // Half the size in units: below 2^21.
        let x = times(self.x, viewport.width() << (S::FRACTION_BITS - 1), w)?;
        let y = times(self.y, viewport.height() << (S::FRACTION_BITS - 1), w)?;
        let x = center(viewport.left, viewport.right) + x.up;
        let y = center(viewport.top, viewport.bottom) - y.down;
        SubPoint::from_units(i32::try_from(x).ok()?, i32::try_from(y).ok()?).ok()
    }
}

/// A quotient rounded to the nearest whole number, ties to the larger and to the smaller one.
struct Rounded {
    up: i64,
    down: i64,
}

/// `value * factor / divisor` for a factor below 2^22; `None` where it is far beyond every screen.
fn times(value: i64, factor: u32, divisor: NonZeroU64) -> Option<Rounded> {
    let magnitude = value.unsigned_abs();
    let (whole, rest) = (magnitude / divisor, magnitude % divisor);
    let whole = i64::from(i32::try_from(whole).ok()?) * i64::from(factor);
    let (rest, is_tie) = scale_nearest(u64::from(factor), rest, divisor.get());
    // Below 2^53 and below 2^22.
    let away = whole + rest as i64;
    let toward = away - i64::from(is_tie);
    Some(if value < 0 {
        Rounded {
            up: -toward,
            down: -away,
        }
    } else {
        Rounded { up: away, down: toward }
    })
}
