//! Directions without floating point: the same pixels on every machine.

use embedded_graphics::geometry::Point;
use zrow::geometry::{Sub8, SubPoint};

use crate::PrepareError;

/// Steps of a full turn.
pub const TURN: u32 = 512;

static SINES: [i16; TURN as usize] = include!(concat!(env!("OUT_DIR"), "/sine.rs"));

/// The sine of an angle in steps, 16,384 for 1.
pub fn sine(angle: u32) -> i32 {
    SINES.get((angle % TURN) as usize).copied().map_or(0, i32::from)
}

/// A point at a distance from another; angle 0 is up, and angles grow clockwise. In sixteenths of a pixel.
pub fn around_sixteenths(center: Point, radius: i32, angle: u32) -> Point {
    let along = |sine: i32| (radius * sine + 512) >> 10;
    Point::new(
        center.x * 16 + along(sine(angle)),
        center.y * 16 - along(sine(angle + TURN / 4)),
    )
}

/// A point at a distance from another, rounded to a pixel; angle 0 is up, and angles grow clockwise.
pub fn around(center: Point, radius: i32, angle: u32) -> Point {
    let along = |sine: i32| (radius * sine + 8192) >> 14;
    center + Point::new(along(sine(angle)), -along(sine(angle + TURN / 4)))
}

/// A point around another one, which is in pixels; angle 0 is up, and angles grow clockwise. Radius in 1/256 pixel, angle
/// in 1/65,536 turn.
///
/// # Errors
/// [`PrepareError`] where the point is out of the domain of [`Sub8`].
pub fn around_sub8(center: (i32, i32), radius: i32, angle: u32) -> Result<SubPoint<Sub8>, PrepareError> {
    // Between two entries of the table.
    let sine = |angle: u32| {
        let (step, rest) = (angle >> 7, (angle & 127) as i32);
        (sine(step) * (128 - rest) + sine(step + 1) * rest) >> 7
    };
    let along = |sine: i32| ((i64::from(radius) * i64::from(sine) + 8192) >> 14) as i32;
    SubPoint::from_units(
        center.0 * 256 + along(sine(angle)),
        center.1 * 256 - along(sine(angle.wrapping_add(0x4000))),
    )
}
