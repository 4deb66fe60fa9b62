//! Rotations from angles, and what is composed of them.
//!
//! Guarantees: a matrix is orthonormal to within 2^-22, however many are composed (below).
//!
//! A product of two rounded matrices is less of a rotation than either: the errors of both add up, and every element is
//! rounded once more. So each rotation counts the angles that it is a product of. Where they are more than twelve, a Newton
//! step for the nearest orthonormal matrix makes the error less than that of one angle (Higham 1986, "Computing the Polar
//! Decomposition", SIAM Journal on Scientific and Statistical Computing 7(4); here as Schulz wrote the step in 1933,
//! which does not divide). Until then nothing is corrected: what a few angles give for a frame is the product, rounded.

use fixed::types::{I2F30, I16F16, U0F16};

use crate::view::sine::{cosine, sine};

/// A rotation matrix in 2.30 fixed point: `matrix[row][column]`, applied to column vectors.
///
/// Angles are binary fractions of a turn ([`U0F16`]): 1/512 of a turn is 128 units of it, exactly. Sines and cosines are
/// within 2^-27 of the true ones, and quarter turns are exact.
///
/// Guarantees, after any number of compositions in any order: the square of the length of each row and column is within
/// 2^-22 of 1, and the product of two rows or two columns within 2^-22 of 0. So nothing is stretched by more than 2^-23 of
/// its size. The direction drifts with the rounding of each composition, by up to 2^-29: what turns evenly is better built
/// from its angle.
///
/// Cost: ten multiplications for each angle about x, y or z, 27 for each composition; 45 more for one of more than twelve angles, which
/// counts as one angle from then on. Two rotations are equal where their matrices are.
///
/// A model that turns evenly has a rotation for each frame, built from the number of the frame and not from the rotation before:
///
/// ```
/// use zrow::fixed::types::{I2F30, U0F16};
/// use zrow::scene::Rotation;
///
/// // 1/512 of a turn a frame about the axis of a globe, which is tilted by a sixteenth.
/// let tilt = Rotation::about_z(U0F16::from_num(1.0 / 16.0));
/// let globe = |frame: u16| Rotation::about_y(U0F16::from_bits(frame.wrapping_mul(128))).then(&tilt);
/// assert_eq!(globe(0), tilt);
/// // Nothing has added up after a turn.
/// assert_eq!(globe(512), tilt);
/// // After a half, the axis is where it was, and what was in front is behind.
/// let [[_, y_to_x, _], _, [.., z_to_z]] = *globe(256).matrix();
/// assert_eq!((y_to_x, z_to_z), (tilt.matrix()[0][1], -I2F30::ONE));
/// ```
#[derive(Debug, Copy, Clone)]
pub struct Rotation {
    matrix: [[I2F30; 3]; 3],
    /// How many rotations about an axis it is the product of, since it was last corrected.
    angles: u8,
}

impl PartialEq for Rotation {
    fn eq(&self, other: &Self) -> bool {
        self.matrix == other.matrix
    }
}

impl Eq for Rotation {}

const ZERO: I2F30 = I2F30::ZERO;
const ONE: I2F30 = I2F30::ONE;

/// The most angles that are composed without a correction.
///
/// How far the product of a matrix with its transpose is from the identity adds up (as the spectral norm of the
/// difference, which is the same for rows and for columns): 16 of 2^-30 for an angle, and 4 for the rounding of each
/// composition. That is below 256, or 2^-22, for 12 angles, and below 512 for 24 before they are corrected.
const MOST_ANGLES: u8 = 12;

impl Rotation {
    /// No rotation.
    pub const IDENTITY: Self = Self {
        matrix: [[ONE, ZERO, ZERO], [ZERO, ONE, ZERO], [ZERO, ZERO, ONE]],
        angles: 0,
    };

    /// A matrix in 2.30, whose error is at most that of so many angles about an axis.
    pub(super) fn from_bits(matrix: [[i64; 3]; 3], angles: u8) -> Self {
        Self {
            matrix: matrix.map(|row| row.map(|element| I2F30::from_bits(element as i32))),
            angles,
        }
    }

    /// About the x axis: a quarter turn takes y to z.
    #[inline]
    pub fn about_x(angle: U0F16) -> Self {
        let (sine, cosine) = (sine(angle), cosine(angle));
        Self {
            matrix: [[ONE, ZERO, ZERO], [ZERO, cosine, -sine], [ZERO, sine, cosine]],
            angles: 1,
        }
    }

    /// About the y axis: a quarter turn takes z to x.
    #[inline]
    pub fn about_y(angle: U0F16) -> Self {
        let (sine, cosine) = (sine(angle), cosine(angle));
        Self {
            matrix: [[cosine, ZERO, sine], [ZERO, ONE, ZERO], [-sine, ZERO, cosine]],
            angles: 1,
        }
    }

    /// About the z axis: a quarter turn takes x to y.
    #[inline]
    pub fn about_z(angle: U0F16) -> Self {
        let (sine, cosine) = (sine(angle), cosine(angle));
        Self {
            matrix: [[cosine, -sine, ZERO], [sine, cosine, ZERO], [ZERO, ZERO, ONE]],
            angles: 1,
        }
    }

    /// This rotation, and `next` after it.
    // Inlined, so that a product of few angles links no correction.
    #[inline]
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        let mut product = self.product(next);
        if product.angles > MOST_ANGLES {
            product.make_orthonormal();
        }
        product
    }

    /// Composes as [`then`](Self::then) does, but never corrects, so the result is only within 2^-21: for a rotation
    /// that is not composed further.
    #[inline]
    pub(super) fn product(&self, next: &Self) -> Self {
        Self {
            matrix: multiplied(&next.matrix, &self.matrix),
            angles: self.angles + next.angles,
        }
    }

    /// Makes the nearest rotation of a product: by a Newton step, whose own error is less than that of its rounding.
    #[inline(never)]
    fn make_orthonormal(&mut self) {
        let [x, y, z] = &self.matrix;
        // What the product with the transpose differs from the identity by, in 2.30.
        let [xx, yy, zz] = [x, y, z].map(|row| (dot(row, row) - ONE).to_bits());
        let [yz, zx, xy] = [(y, z), (z, x), (x, y)].map(|(one, other)| dot(one, other).to_bits());
        debug_assert!([xx, yy, zz, yz, zx, xy].iter().all(|error| error.abs() < 1 << 9));
        self.matrix = [
            self.corrected(x, [xx, xy, zx]),
            self.corrected(y, [xy, yy, yz]),
            self.corrected(z, [zx, yz, zz]),
        ];
        self.angles = 1;
    }

    /// A row, less half of its error with each row times that row.
    fn corrected(&self, row: &[I2F30; 3], errors: [i32; 3]) -> [I2F30; 3] {
        let mut sums = [0; 3];
        for (other, error) in self.matrix.iter().zip(errors) {
            for (sum, element) in sums.iter_mut().zip(other) {
                // An element in 2.16, at most 2^16 and rounding, and an error below 2^9: three products are below 2^27.
                *sum += (element.to_bits() >> 14) * error;
            }
        }
        let [a, b, c] = sums.map(|sum| I2F30::from_bits((sum + (1 << 16)) >> 17));
        let [x, y, z] = *row;
        [x - a, y - b, z - c]
    }

    /// The rotation that undoes this one.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.matrix;
        Self {
            matrix: [[a, d, g], [b, e, h], [c, f, i]],
            angles: self.angles,
        }
    }

    /// A vector, turned, with 16 fractional bits: rounded to the nearest.
    pub(crate) fn turned(&self, vector: &[I16F16; 3]) -> [i64; 3] {
        self.matrix.each_ref().map(|row| {
            let products = row.iter().zip(vector);
            // Three products of at most 2^61: a row is of length 1.
            let sum = products
                .map(|(element, coordinate)| i64::from(element.to_bits()) * i64::from(coordinate.to_bits()))
                .sum::<i64>();
            (sum + (1 << 29)) >> 30
        })
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

/// The product of two matrices, of which the right one is applied first.
#[inline(never)]
fn multiplied(left: &[[I2F30; 3]; 3], [[a, b, c], [d, e, f], [g, h, i]]: &[[I2F30; 3]; 3]) -> [[I2F30; 3]; 3] {
    let columns = [[*a, *d, *g], [*b, *e, *h], [*c, *f, *i]];
    left.each_ref()
        .map(|row| columns.each_ref().map(|column| dot(row, column)))
}

/// The product of two rows or columns of rotations: between -1 and 1 but for rounding, so it fits 2.30.
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
