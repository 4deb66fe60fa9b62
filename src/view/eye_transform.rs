//! Model vertices to eye space: one rotation and one translation per vertex.

use fixed::types::{I2F30, I16F16};

use crate::view::Pose;

/// A point of eye space in 1/4096 of the vertices' unit.
///
/// Every `i16` vertex and every `I16F16` translation of model and camera give coordinates below 2^30.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct EyePoint {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) z: i32,
}

/// From the vertices of one model to eye space: a 2.14 matrix and a translation in 1/4096 unit.
#[derive(Debug, Copy, Clone)]
pub(crate) struct EyeTransform {
    rows: [[i16; 3]; 3],
    translation: [i32; 3],
}

impl EyeTransform {
    pub(crate) fn new(model: &Pose, camera: &Pose) -> Self {
        let to_eye = camera.rotation.inverse();
        let matrix = *model.rotation.then(&to_eye).matrix();
        let mut offset = [0i64; 3];
        for (offset, (model, camera)) in offset.iter_mut().zip(model.translation.iter().zip(&camera.translation)) {
            *offset = difference(*model, *camera);
        }
        Self {
            rows: matrix.map(|row| row.map(to_2_14)),
            translation: to_eye.matrix().map(|row| rotated(&row, &offset)),
        }
    }

    /// Three multiplications a coordinate. The rows are unit vectors within rounding, and a vertex is at most
    /// 32,768 * sqrt(3) long: each sum stays below 2^30 in 2.14, so nothing wraps.
    #[inline(always)]
    pub(crate) fn apply(&self, vertex: [i16; 3]) -> EyePoint {
        let [x, y, z] = vertex.map(i32::from);
        let coordinate = |row: &[i16; 3], translation: i32| {
            let [a, b, c] = row.map(i32::from);
            let sum = a
                .wrapping_mul(x)
                .wrapping_add(b.wrapping_mul(y))
                .wrapping_add(c.wrapping_mul(z));
            (sum >> 2).wrapping_add(translation)
        };
        let [row_x, row_y, row_z] = &self.rows;
        let [t_x, t_y, t_z] = self.translation;
        EyePoint {
            x: coordinate(row_x, t_x),
            y: coordinate(row_y, t_y),
            z: coordinate(row_z, t_z),
        }
    }
}

fn difference(model: I16F16, camera: I16F16) -> i64 {
    i64::from(model.to_bits()) - i64::from(camera.to_bits())
}

/// A row of a rotation (2.30) times a vector (.16), to 1/4096.
///
/// The vector is at most 2^16 * sqrt(3) units long: the result is below 113,600 units or 2^29.
fn rotated(row: &[I2F30; 3], vector: &[i64; 3]) -> i32 {
    let sum: i64 = row
        .iter()
        .zip(vector)
        // 2^30 * 2^33 would leave no room for the sum: four bits of the matrix give it.
        .map(|(element, coordinate)| i64::from(element.to_bits() >> 4) * coordinate)
        .sum();
    ((sum + (1 << 29)) >> 30) as i32
}

fn to_2_14(element: I2F30) -> i16 {
    // At most 1 and rounding: 16,384 in 2.14.
    ((element.to_bits() + (1 << 15)) >> 16) as i16
}
