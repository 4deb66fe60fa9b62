//! Rotations from angles, rebuilt for every frame and never accumulated.

use fixed::types::{I2F30, U0F16};

use crate::view::sine::{cosine, sine};

/// A rotation matrix in 2.30 fixed point: `matrix[row][column]`, applied to column vectors.
///
/// Angles are binary fractions of a turn ([`U0F16`]): 1/512 of a turn is 128 units of it, exactly. Sines and cosines are
/// within 2^-27 of the true ones, and quarter turns are exact. Cost: ten multiplications for each angle, 27 for each
/// composition.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Rotation {
    matrix: [[I2F30; 3]; 3],
}

const ZERO: I2F30 = I2F30::ZERO;
const ONE: I2F30 = I2F30::ONE;

impl Rotation {
    /// No rotation.
    pub const IDENTITY: Self = Self {
        matrix: [[ONE, ZERO, ZERO], [ZERO, ONE, ZERO], [ZERO, ZERO, ONE]],
    };

    /// About the x axis: a quarter turn takes y to z.
    pub fn about_x(angle: U0F16) -> Self {
        let (sine, cosine) = (sine(angle), cosine(angle));
        Self {
            matrix: [[ONE, ZERO, ZERO], [ZERO, cosine, -sine], [ZERO, sine, cosine]],
        }
    }

    /// About the y axis: a quarter turn takes z to x.
    pub fn about_y(angle: U0F16) -> Self {
        let (sine, cosine) = (sine(angle), cosine(angle));
        Self {
            matrix: [[cosine, ZERO, sine], [ZERO, ONE, ZERO], [-sine, ZERO, cosine]],
        }
    }

    /// About the z axis: a quarter turn takes x to y.
    pub fn about_z(angle: U0F16) -> Self {
        let (sine, cosine) = (sine(angle), cosine(angle));
        Self {
            matrix: [[cosine, -sine, ZERO], [sine, cosine, ZERO], [ZERO, ZERO, ONE]],
        }
    }

    /// This rotation, and `next` after it.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        let Self { matrix: columns } = self.inverse();
        let row = |next: &[I2F30; 3]| {
            let [x, y, z] = &columns;
            [dot(next, x), dot(next, y), dot(next, z)]
        };
        let [x, y, z] = &next.matrix;
        Self {
            matrix: [row(x), row(y), row(z)],
        }
    }

    /// The rotation that undoes this one.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.matrix;
        Self {
            matrix: [[a, d, g], [b, e, h], [c, f, i]],
        }
    }

    /// The matrix, row by row.
    pub const fn matrix(&self) -> &[[I2F30; 3]; 3] {
        &self.matrix
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Rotation {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Rotation {}",
            self.matrix.map(|row| row.map(|element| element.to_num::<f32>()))
        );
    }
}

/// A row of one rotation times a column of another: between -1 and 1 but for rounding, so it fits 2.30.
#[inline(never)]
fn dot(row: &[I2F30; 3], column: &[I2F30; 3]) -> I2F30 {
    let sum = row
        .iter()
        .zip(column)
        .map(|(left, right)| i64::from(left.to_bits()) * i64::from(right.to_bits()))
        .sum::<i64>();
    // Three products below 2^62 that belong to unit vectors: the sum is about 2^60 at most.
    I2F30::from_bits(((sum + (1 << 29)) >> 30) as i32)
}
