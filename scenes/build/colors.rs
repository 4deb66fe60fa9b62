//! A colour for each face of the standard scenes' meshes, in the order of the faces.

use std::fmt;

/// Red, green and blue from 0 to 1.
pub struct Color([f64; 3]);

impl fmt::Debug for Color {
    /// As a constant expression.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Color([red, green, blue]) = self;
        let level = |value: f64, most: f64| (value.clamp(0.0, 1.0) * most).round() as u8;
        let (red, green, blue) = (level(*red, 31.0), level(*green, 63.0), level(*blue, 31.0));
        write!(formatter, "Rgb565::new({red}, {green}, {blue})")
    }
}

/// The hues go around the torus, and its inside is darker. The cube's sides are light.
pub fn torus_and_cube() -> Vec<Color> {
    let mut colors = Vec::new();
    for i in 0..24 {
        for j in 0..12 {
            // Two quads share a colour, so that all colours fit the palette of a GIF.
            let around = f64::from(i / 2) / 12.0;
            // 0 on the outside, 1 on the inside.
            let inside = (6.0 - (f64::from(j) + 0.5 - 6.0).abs()) / 6.0;
            let checker = if (i / 2 + j) % 2 == 0 { 0.06 } else { 0.0 };
            for _ in 0..2 {
                colors.push(hue(around, 0.62, 0.95 - 0.5 * inside - checker));
            }
        }
    }
    colors.extend(cube());
    colors
}

/// Warm at one pole and cold at the other; neighbours differ.
pub fn icosphere() -> Vec<Color> {
    let mesh = super::meshes::icosphere();
    let heights = mesh.heights();
    let color = |(face, height): (usize, f64)| {
        let shade = 0.12 * (face % 3) as f64;
        hue(0.35 + 0.22 * height, 0.6, 0.95 - shade)
    };
    heights.into_iter().enumerate().map(color).collect()
}

/// Two faces a side.
pub fn cube() -> Vec<Color> {
    let sides = [
        [0.98, 0.93, 0.80],
        [0.90, 0.84, 0.70],
        [0.95, 0.55, 0.35],
        [0.86, 0.43, 0.30],
        [0.40, 0.72, 0.85],
        [0.30, 0.60, 0.76],
    ];
    sides.into_iter().flat_map(|side| [Color(side), Color(side)]).collect()
}

/// A hue (0 and 1 are red, 1/3 is green), how saturated, and how bright.
fn hue(hue: f64, saturation: f64, value: f64) -> Color {
    let channel = |shift: f64| {
        let position = ((hue + shift).rem_euclid(1.0) * 6.0 - 3.0).abs() - 1.0;
        value * (1.0 - saturation * (1.0 - position.clamp(0.0, 1.0)))
    };
    Color([channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0)])
}
