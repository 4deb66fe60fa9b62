//! Directions and centres by embedded-graphics' definition, with micromath's sines on every machine.

use embedded_graphics::geometry::{Angle, AngleUnit};
use micromath::F32Ext;

/// 2^22 turns in radians: from there on an angle has no direction.
pub const NO_DIRECTION: f32 = 4_194_304.0 * core::f32::consts::TAU;

/// The normal vector of an angle; the zero vector without a direction.
pub fn normal(angle: Angle) -> (i128, i128) {
    let radians = angle.to_radians();
    if angle == 180.0.deg() {
        (0, -1024)
    } else if radians.abs() < NO_DIRECTION {
        let scaled = |value: f32| i128::from((value * 1024.0) as i32);
        (-scaled(F32Ext::sin(radians)), scaled(F32Ext::cos(radians)))
    } else {
        (0, 0)
    }
}

/// Twice the middle of so many coordinates; that of none is half a pixel behind their position.
pub fn middle_2x(start: i32, length: u32) -> i128 {
    2 * i128::from(start) + if length == 0 { 1 } else { i128::from(length) - 1 }
}
