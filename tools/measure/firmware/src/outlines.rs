//! Outlines that zrow and other rasterizers cover: one of each kind, and many of each kind in all directions.

use core::array;

use fixed::types::U0F16;
use zrow::scene::Rotation;

use crate::inputs::Uniform;

/// Columns and rows of the mask that they lie in.
pub const SIZE: usize = 48;

/// In 1/256 pixel from the corner of the mask.
pub type Corner = (i32, i32);

/// Outlines of a kind that has many of them.
pub const MANY: usize = 32;

/// (3.3, 2.1) (44.2, 17.7) (12.6, 45.4).
pub const TRIANGLE: [Corner; 3] = [(845, 538), (11_315, 4_531), (3_226, 11_622)];

/// {7/3} of radius 22 about (24, 24), from the top.
pub const STAR: [Corner; 7] = [
    (6_144, 512),
    (8_588, 11_218),
    (1_741, 2_632),
    (11_635, 7_397),
    (653, 7_397),
    (10_547, 2_632),
    (3_700, 11_218),
];

/// Triangles whose corners are uniform over the mask.
pub fn random_triangles() -> [[Corner; 3]; MANY] {
    let mut uniform = Uniform::default();
    let units = (SIZE * 256) as i32;
    array::from_fn(|_| array::from_fn(|_| (uniform.number(0, units), uniform.number(0, units))))
}

/// The star, turned about its centre by equal angles over a whole turn.
pub fn turned_stars() -> [[Corner; 7]; MANY] {
    const CENTER: i32 = 6_144;
    array::from_fn(|index| {
        let rotation = Rotation::about_z(U0F16::from_bits((index * 65_536 / MANY) as u16));
        let turned = |row: usize, (x, y): Corner| {
            let [along_x, along_y, _] = rotation.matrix()[row].map(|entry| i64::from(entry.to_bits()));
            let sum = along_x * i64::from(x - CENTER) + along_y * i64::from(y - CENTER);
            ((sum + (1 << 29)) >> 30) as i32 + CENTER
        };
        STAR.map(|corner| (turned(0, corner), turned(1, corner)))
    })
}
