//! Directions without floating point: the same pixels on every machine.

use embedded_graphics::geometry::Point;

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
