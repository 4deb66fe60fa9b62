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

/// The transformation from the vertices of one model to eye space: a 2.14 matrix and a translation in 1/4096 unit.
#[derive(Debug, Copy, Clone)]
pub(crate) struct EyeTransform {
    rows: [[i16; 3]; 3],
    translation: [i32; 3],
}

impl EyeTransform {
    pub(crate) fn new(model: &Pose, camera: &Pose) -> Self {
        let to_eye = camera.rotation.inverse();
        let matrix = model.rotation.product(&to_eye);
        let [x, y, z] = matrix.matrix();
        let ([x1, y1, z1], [x0, y0, z0]) = (model.translation, camera.translation);
        let offset = [difference(x1, x0), difference(y1, y0), difference(z1, z0)];
        let [to_x, to_y, to_z] = to_eye.matrix();
        Self {
            rows: [row_2_14(x), row_2_14(y), row_2_14(z)],
            translation: [rotated(to_x, &offset), rotated(to_y, &offset), rotated(to_z, &offset)],
        }
    }

    /// Three multiplications a coordinate. The rows are unit vectors within rounding, and a vertex is at most
    /// 32,768 * sqrt(3) long: each sum stays below 2^30 in 2.14, so nothing wraps.
    #[inline]
    pub(crate) fn apply(&self, vertex: [i16; 3]) -> EyePoint {
        // Written out: a closure over an array is a loop through memory when the compiler minds the size.
        let [x, y, z] = vertex;
        let (x, y, z) = (i32::from(x), i32::from(y), i32::from(z));
        let coordinate = |row: &[i16; 3], translation: i32| {
            let [a, b, c] = *row;
            let sum = i32::from(a) * x + (i32::from(b) * y) + (i32::from(c) * z);
            (sum >> 2) + translation
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

/// The dot product of a row of a rotation (2.30) and a vector (16 fractional bits), in 1/4096 unit.
///
/// The vector is at most 2^16 * sqrt(3) units long: the result is below 113,600 units or 2^29.
#[inline(never)]
fn rotated(row: &[I2F30; 3], vector: &[i64; 3]) -> i32 {
    let sum: i64 = row
        .iter()
        .zip(vector)
        // 2^30 * 2^33 would leave no room for the sum: four bits of the matrix give it.
        .map(|(element, coordinate)| i64::from(element.to_bits() >> 4) * coordinate)
        .sum();
    ((sum + (1 << 29)) >> 30) as i32
}

// Not inlined nine times.
#[inline(never)]
fn row_2_14([x, y, z]: &[I2F30; 3]) -> [i16; 3] {
    // At most 1 and rounding: 16,384 in 2.14.
    let round = |element: &I2F30| ((element.to_bits() + (1 << 15)) >> 16) as i16;
    [round(x), round(y), round(z)]
}
