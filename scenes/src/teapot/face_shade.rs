//! The colour of a flat face in a light that is far away.

use embedded_graphics::pixelcolor::Rgb565;

use super::vector::{cross, difference, dot, length};

/// Towards the light: from the upper left, and from the viewer's side.
const LIGHT: [i64; 3] = [-1, 2, -2];

/// A face of that colour (red, green, blue): half of it where the face is turned away from the light, all of it
/// where it looks into the light.
pub(super) const fn shade(corners: [[i16; 3]; 3], color: [i64; 3]) -> Rgb565 {
    let normal = face_normal(corners);
    let lengths = length(normal) * length(LIGHT);
    // 256 times the cosine of the angle to the light.
    let cosine = if lengths > 0 {
        dot(normal, LIGHT) * 256 / lengths
    } else {
        0
    };
    let light = 192 + cosine / 4;
    let [red, green, blue] = [color[0] * light / 256, color[1] * light / 256, color[2] * light / 256];
    Rgb565::new((red >> 3) as u8, (green >> 2) as u8, (blue >> 3) as u8)
}

/// The normal of a face, of any length.
pub(super) const fn face_normal([a, b, c]: [[i16; 3]; 3]) -> [i64; 3] {
    cross(difference(b, a), difference(c, a))
}
