//! Model vertices to eye space: one rotation and one translation per vertex.

use fixed::types::{I2F30, I16F16};

use crate::{
    geometry::Sub8,
    view::{Pose, ScreenPrecision},
};

/// A point of eye space in 1/4096 of the vertices' unit.
///
/// Coordinates are below 2^30 in size: every `i16` vertex and every `I16F16` translation of model and camera give such, and a
/// model that an affine map makes greater is an error.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct EyePoint {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) z: i32,
}

/// A transformation from the vertices of one model to eye space.
pub(crate) trait ToEye {
    /// A vertex in eye space. Nothing wraps: see [`EyePoint`].
    fn apply(&self, vertex: [i16; 3]) -> EyePoint;
}

/// The transformation from the vertices of one model to eye space: a matrix and a translation, with
/// [`Sub4`](crate::geometry::Sub4) in 2.14 and in 1/4096 unit, with [`Sub8`](crate::geometry::Sub8) with 30 fractional bits
/// each.
#[derive(Debug, Copy, Clone)]
pub(crate) struct EyeTransform<S: ScreenPrecision> {
    rows: [[S::EyeElement; 3]; 3],
    translation: [S::EyeOffset; 3],
}

impl<S: ScreenPrecision> EyeTransform<S> {
    pub(crate) fn new(model: &Pose, camera: &Pose) -> Self {
        let to_eye = camera.rotation.inverse();
        let matrix = model.rotation.product(&to_eye);
        let [x, y, z] = matrix.matrix();
        let ([x1, y1, z1], [x0, y0, z0]) = (model.translation, camera.translation);
        let offset = [difference(x1, x0), difference(y1, y0), difference(z1, z0)];
        Self {
            rows: [eye_row::<S>(x), eye_row::<S>(y), eye_row::<S>(z)],
            translation: to_eye.matrix().each_ref().map(|row| S::eye_offset(row, &offset)),
        }
    }

    /// The rows of the matrix with 30 fractional bits.
    pub(super) fn rows_bits(&self) -> [[i64; 3]; 3] {
        self.rows
            .map(|row| row.map(|element| S::eye_element_bits(element).into()))
    }

    /// The translation in 1/4096 unit, rounded down.
    pub(super) fn offset_bits(&self) -> [i64; 3] {
        self.translation.map(S::eye_offset_bits)
    }
}

impl<S: ScreenPrecision> ToEye for EyeTransform<S> {
    /// Three multiplications a coordinate.
    #[inline]
    fn apply(&self, vertex: [i16; 3]) -> EyePoint {
        let [row_x, row_y, row_z] = &self.rows;
        let [t_x, t_y, t_z] = self.translation;
        EyePoint {
            x: S::eye_coordinate(row_x, vertex, t_x),
            y: S::eye_coordinate(row_y, vertex, t_y),
            z: S::eye_coordinate(row_z, vertex, t_z),
        }
    }
}

pub(super) fn difference(model: I16F16, camera: I16F16) -> i64 {
    i64::from(model.to_bits()) - i64::from(camera.to_bits())
}

// Not inlined nine times.
#[inline(never)]
fn eye_row<S: ScreenPrecision>([x, y, z]: &[I2F30; 3]) -> [S::EyeElement; 3] {
    [S::eye_element(*x), S::eye_element(*y), S::eye_element(*z)]
}

/// How far positions of a model are along a camera's axis, for positions of any map: the last row of the transformation to eye
/// space with 30 fractional bits.
#[derive(Debug, Copy, Clone)]
pub(crate) struct EyeAxis {
    row: [I2F30; 3],
    offset: i64,
}

impl EyeAxis {
    pub(crate) fn new(model: &Pose, camera: &Pose) -> Self {
        let EyeTransform { rows, translation } = EyeTransform::<Sub8>::new(model, camera);
        let ([_, _, row], [_, _, offset]) = (rows, translation);
        Self { row, offset }
    }

    /// The distance of a position below 2^25 in size, in 1/4096 unit.
    pub(crate) fn distance(&self, position: [i32; 3]) -> i64 {
        let products = self.row.iter().zip(position);
        // Three products below 2^55, and an offset below 2^48.
        let sum = products
            .map(|(element, coordinate)| i64::from(element.to_bits()) * i64::from(coordinate))
            .sum::<i64>();
        (sum + self.offset) >> 18
    }
}
