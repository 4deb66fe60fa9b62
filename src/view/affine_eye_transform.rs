//! Vertices of a model under an affine map to eye space, at any precision: long products, because a map may make them larger.

use fixed::types::I16F16;

use crate::{
    geometry::Sub8,
    view::{
        Affine, EyePoint, Pose, ScreenPrecision,
        eye_transform::{ToEye, difference},
    },
};

/// The transformation from the vertices of one model, which an affine map and then a pose put into the world, to eye space: a
/// matrix and a translation with 24 fractional bits each.
///
/// A coordinate in eye space is within 2^-12 units of the exact one, and 2^-25 times the sum of the sizes of the vertex'
/// coordinates.
#[derive(Debug, Copy, Clone)]
pub(crate) struct AffineEyeTransform {
    rows: [[i32; 3]; 3],
    /// With half of 1/4096 unit more, so that the sum is rounded once.
    translation: [i64; 3],
}

/// Bits of a coordinate with 24 fractional ones that is an [`EyePoint`]'s: below 2^30 in 1/4096 unit.
const MOST_BITS: u32 = 42;

impl AffineEyeTransform {
    /// `None` where the map stretches by 128 or more.
    #[inline(never)]
    pub(crate) fn new(affine: &Affine, model: &Pose, camera: &Pose) -> Option<Self> {
        let to_eye = camera.rotation.inverse();
        let turned = model.rotation.product(&to_eye);
        let ([x1, y1, z1], [x0, y0, z0]) = (model.translation, camera.translation);
        let offset = [difference(x1, x0), difference(y1, y0), difference(z1, z0)];
        let [[a, b, c], [d, e, f], [g, h, i]] =
            affine.matrix.map(|row| row.map(|element| i64::from(element.to_bits())));
        let columns = [[a, d, g], [b, e, h], [c, f, i]];
        let moved = affine
            .translation
            .map(|coordinate| i64::from(I16F16::to_bits(coordinate)));
        let mut transform = Self {
            rows: [[0; 3]; 3],
            translation: [0; 3],
        };
        let rows = transform.rows.iter_mut().zip(&mut transform.translation);
        for ((row, translation), (turned, to_eye)) in rows.zip(turned.matrix().iter().zip(to_eye.matrix())) {
            // A row of a rotation, whose sizes add up to less than 2 in 2.30, times 31 bits.
            let product = |column: [i64; 3]| {
                let products = turned.iter().zip(column);
                products
                    .map(|(element, part)| i64::from(element.to_bits()) * part)
                    .sum::<i64>()
            };
            for (element, column) in row.iter_mut().zip(columns) {
                *element = i32::try_from((product(column) + (1 << 29)) >> 30).ok()?;
            }
            // Both with 30 fractional bits, below 2^47 and 2^46, and half of 1/4096 unit in the first.
            let sum = Sub8::eye_offset(to_eye, &offset) + ((product(moved) + (1 << 15)) >> 16);
            *translation = (sum + (1 << 5)) >> 6;
        }
        Some(transform)
    }

    /// Whether all of the vertices have coordinates in eye space that an [`EyePoint`] holds: decided by the box around them and
    /// the origin of the model.
    #[inline(never)]
    pub(crate) fn fits(&self, vertices: &[[i16; 3]]) -> bool {
        if self.holds([1 << 15; 3]) {
            return true;
        }
        let mut most = [0; 3];
        for vertex in vertices {
            for (most, coordinate) in most.iter_mut().zip(vertex) {
                *most = coordinate.unsigned_abs().max(*most);
            }
        }
        self.holds(most.map(i64::from))
    }

    /// Whether a box of this reach to both sides of the model's origin fits.
    fn holds(&self, most: [i64; 3]) -> bool {
        self.rows.iter().zip(self.translation).all(|(row, translation)| {
            let reach = row
                .iter()
                .zip(most)
                .map(|(element, most)| i64::from(element.unsigned_abs()) * most);
            // Three products of 46 bits. Coordinates are rounded down: the least one is a whole unit of theirs farther inside.
            reach.sum::<i64>() + translation.abs() <= (1 << MOST_BITS) - (1 << 12)
        })
    }
}

impl ToEye for AffineEyeTransform {
    /// Three multiplications of 32 by 32 bits a coordinate; the sum stays below 2^42.
    #[inline]
    fn apply(&self, vertex: [i16; 3]) -> EyePoint {
        let [x, y, z] = vertex.map(i64::from);
        let coordinate = |[a, b, c]: [i32; 3], translation: i64| {
            ((i64::from(a) * x + i64::from(b) * y + i64::from(c) * z + translation) >> 12) as i32
        };
        let ([row_x, row_y, row_z], [t_x, t_y, t_z]) = (self.rows, self.translation);
        EyePoint {
            x: coordinate(row_x, t_x),
            y: coordinate(row_y, t_y),
            z: coordinate(row_z, t_z),
        }
    }
}
