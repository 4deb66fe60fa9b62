//! Affine maps: scale, shear and mirroring beside rotation and translation, their composition and inverse, and what they do to
//! normals.
//!
//! A map takes the tangents of a surface along, and not its normals: a sphere that is made twice as wide is steeper at its
//! sides than its normals, made twice as wide, would say. Normals go by the inverse transpose of the matrix, which the
//! cofactors are but for a factor, so that nothing is divided: each is the product of two columns that is at right angles to
//! both.
//!
//! Source: Turkowski (1990), "Properties of surface-normal transformations", Graphics Gems.

use core::num::{NonZeroU32, NonZeroU64};

use fixed::types::{I8F24, I16F16};

use crate::{
    geometry::InputError,
    view::{Pose, pose::position, unit_vector::scaled},
};

/// A linear map, then a translation in units of the models' vertices: scale, shear, mirroring and rotation in one.
///
/// Elements of the matrix are from -128 to 128 with 24 fractional bits; `matrix[row][column]`, applied to column vectors. A map
/// with a negative determinant mirrors.
///
/// ```
/// use zrow::fixed::types::{I8F24, I16F16, U0F16};
/// use zrow::scene::{Affine, Pose, Rotation};
///
/// // Twice as high, then turned, then moved.
/// let factors = [1, 2, 1].map(I8F24::from_num::<i32>);
/// let rotation = Rotation::about_z(U0F16::from_num(0.25));
/// let position = [0, 0, 700].map(I16F16::from_num::<i32>);
/// let map = Affine::scaled(factors).then(&Pose::new(rotation, position).into())?;
/// // y is now to the left.
/// assert_eq!(map.matrix.map(|row| row[1]), [-2, 0, 0].map(I8F24::from_num::<i32>));
/// assert_eq!(map.translation, position);
/// assert_eq!(map.then(&map.inverse()?)?, Affine::IDENTITY);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Affine {
    /// The linear map, row by row.
    pub matrix: [[I8F24; 3]; 3],
    /// Where the origin goes: x, y, z.
    pub translation: [I16F16; 3],
}

/// Fractional bits of an element.
const BITS: u32 = 24;

impl Affine {
    /// The map that leaves everything where it is.
    pub const IDENTITY: Self = Self::scaled([I8F24::ONE; 3]);

    /// The map that multiplies x, y and z with a factor each: three equal ones change the size only, a negative one mirrors.
    pub const fn scaled([x, y, z]: [I8F24; 3]) -> Self {
        const ZERO: I8F24 = I8F24::ZERO;
        Self {
            matrix: [[x, ZERO, ZERO], [ZERO, y, ZERO], [ZERO, ZERO, z]],
            translation: [I16F16::ZERO; 3],
        }
    }

    /// This map, and `next` after it.
    ///
    /// Elements are within 2^-24 of those of the exact product, coordinates of the translation within 2^-16. Cost: 36
    /// multiplications.
    ///
    /// # Errors
    /// [`InputError::ScaleOutOfDomain`] and [`InputError::PositionOutOfDomain`].
    pub fn then(&self, next: &Self) -> Result<Self, InputError> {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.matrix.map(|row| row.map(I8F24::to_bits));
        let [first, second, third] = [[a, d, g], [b, e, h], [c, f, i]].map(|column| next.mapped(column));
        let ([a, d, g], [b, e, h], [c, f, i]) = (first, second, third);
        let moved = next.mapped(self.translation.map(I16F16::to_bits));
        let [x, y, z] = next.translation.map(|coordinate| i64::from(coordinate.to_bits()));
        let [moved_x, moved_y, moved_z] = moved;
        Ok(Self {
            matrix: matrix([[a, b, c], [d, e, f], [g, h, i]])?,
            translation: position([moved_x + x, moved_y + y, moved_z + z])?,
        })
    }

    /// The map that undoes this one.
    ///
    /// Elements are within 2^-25 and 2^-30 of their size of those of the exact inverse; the translation is that of this map
    /// through them, within 2^-16. Cost: 30 multiplications and nine divisions.
    ///
    /// # Errors
    /// [`InputError::ScaleOutOfDomain`], also where the map flattens space, so that nothing undoes it;
    /// [`InputError::PositionOutOfDomain`].
    pub fn inverse(&self) -> Result<Self, InputError> {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.cofactors();
        let divisor = Divisor::new(self.determinant()).ok_or(InputError::ScaleOutOfDomain)?;
        let rows = [[a, d, g], [b, e, h], [c, f, i]];
        let matrix = matrix(rows.map(|row| row.map(|cofactor| divisor.divide(cofactor))))?;
        let linear = Self {
            matrix,
            ..Self::IDENTITY
        };
        let moved = linear.mapped(self.translation.map(I16F16::to_bits));
        Ok(Self {
            matrix,
            translation: position(moved.map(|coordinate| -coordinate))?,
        })
    }

    /// The map of normals: a normal of a surface, through its matrix, has the direction that is normal to the surface through
    /// this map, on the same side of it. Its length may be any.
    ///
    /// Elements are those of the exact inverse transpose times any positive number, within 2^-25, the greatest between 32 and
    /// 64. A map to a plane has the normal of the plane, a map to a line or a point none: all elements are 0. Cost: 21
    /// multiplications.
    #[must_use]
    pub fn normals(&self) -> Self {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.cofactors();
        let [a, b, c, d, e, f, g, h, i] = scaled([a, b, c, d, e, f, g, h, i]).unwrap_or_default();
        // Mirrored, the products of columns point to the other side.
        let is_mirrored = self.is_mirrored();
        let element = |bits: i64| I8F24::from_bits(if is_mirrored { -bits } else { bits } as i32);
        Self {
            matrix: [[a, b, c], [d, e, f], [g, h, i]].map(|row| row.map(element)),
            ..Self::IDENTITY
        }
    }

    /// Where a position in whole units is mapped to, to the nearest unit: below 2^25 for positions of 16 bits.
    pub(crate) fn position(&self, position: [i32; 3]) -> [i32; 3] {
        let mut mapped = self
            .translation
            .map(|coordinate| i64::from(coordinate.to_bits()) << (BITS - 16));
        for (mapped, row) in mapped.iter_mut().zip(&self.matrix) {
            for (element, coordinate) in row.iter().zip(position) {
                *mapped += i64::from(element.to_bits()) * i64::from(coordinate);
            }
        }
        mapped.map(|bits| ((bits + (1 << (BITS - 1))) >> BITS) as i32)
    }

    /// Whether what runs clockwise runs the other way once it is mapped.
    pub(crate) fn is_mirrored(&self) -> bool {
        self.determinant() < 0
    }

    /// A vector of whole numbers up to 2^8 in size, mapped and made as long as 1, in 2.14: within 2 units of 1/16,384. A vector
    /// of length 0 where it is mapped to nothing.
    pub(crate) fn unit_vector(&self, vector: [i32; 3]) -> [i32; 3] {
        let mapped = self.matrix.map(|row| {
            let products = row.iter().zip(vector);
            products
                .map(|(element, coordinate)| i64::from(element.to_bits()) * i64::from(coordinate))
                .sum::<i64>()
        });
        // Of 30 bits, 15 are kept: three squares fit 32 bits.
        let [x, y, z] = scaled(mapped)
            .unwrap_or_default()
            .map(|bits| ((bits + (1 << 14)) >> 15) as i32);
        let square = (x * x) as u32 + (y * y) as u32 + (z * z) as u32;
        let Some(length) = NonZeroU32::new(square.isqrt()) else {
            return [0; 3];
        };
        // The square of the length and a half is above the square by as much as the root is below the length.
        let length = if square - length.get() * length.get() > length.get() {
            length.saturating_add(1)
        } else {
            length
        };
        [x, y, z].map(|bits: i32| {
            let size = ((bits.unsigned_abs() << 14) + length.get() / 2) / length;
            if bits < 0 { -(size as i32) } else { size as i32 }
        })
    }

    /// A vector through the matrix, with as many fractional bits as it has: within one of them.
    fn mapped(&self, vector: [i32; 3]) -> [i64; 3] {
        self.matrix.map(|row| {
            let products = row.iter().zip(vector);
            // Two bits less leave room for the sum of three products of 62 bits.
            let sum = products
                .map(|(element, coordinate)| (i64::from(element.to_bits()) * i64::from(coordinate)) >> 2)
                .sum::<i64>();
            (sum + (1 << (BITS - 3))) >> (BITS - 2)
        })
    }

    /// The cofactors of the matrix, exactly, with 48 fractional bits.
    fn cofactors(&self) -> [[i64; 3]; 3] {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.matrix.map(|row| row.map(|element| i64::from(element.to_bits())));
        // From -2^31 on and below 2^31: the difference of two products is below 2^63, because the one that is not -2^31 squared
        // is smaller.
        let minor = |a: i64, b: i64, c: i64, d: i64| a * d - b * c;
        [
            [minor(e, f, h, i), minor(f, d, i, g), minor(d, e, g, h)],
            [minor(h, i, b, c), minor(i, g, c, a), minor(g, h, a, b)],
            [minor(b, c, e, f), minor(c, a, f, d), minor(a, b, d, e)],
        ]
    }

    /// The determinant, exactly, with 72 fractional bits.
    fn determinant(&self) -> i128 {
        let ([first, ..], [cofactors, ..]) = (self.matrix, self.cofactors());
        let products = first.iter().zip(cofactors);
        products
            .map(|(element, cofactor)| i128::from(element.to_bits()) * i128::from(cofactor))
            .sum()
    }
}

impl From<Pose> for Affine {
    /// The map that turns and moves as a pose does: each element within 2^-25.
    fn from(pose: Pose) -> Self {
        let element = |bits: i32| I8F24::from_bits((bits + (1 << 5)) >> 6);
        Self {
            matrix: pose
                .rotation
                .matrix()
                .map(|row| row.map(|part| element(part.to_bits()))),
            translation: pose.translation,
        }
    }
}

/// A determinant to divide cofactors by: its sign, its highest bits, from 2^30 to 2^31, and their place.
#[derive(Debug, Copy, Clone)]
struct Divisor {
    is_negative: bool,
    mantissa: NonZeroU64,
    exponent: i32,
}

impl Divisor {
    fn new(determinant: i128) -> Option<Self> {
        let size = determinant.unsigned_abs();
        let exponent = 97 - size.leading_zeros() as i32;
        // Rounded to the nearest: 2^31 at most.
        let mantissa = if exponent > 0 {
            ((size >> (exponent - 1)) + 1) >> 1
        } else {
            size << -exponent
        };
        Some(Self {
            is_negative: determinant < 0,
            mantissa: NonZeroU64::new(mantissa as u64)?,
            exponent,
        })
    }

    /// A cofactor divided by the determinant, with 24 fractional bits, rounded to the nearest; what does not fit 32 bits is any
    /// number of more bits.
    fn divide(self, cofactor: i64) -> i64 {
        let size = cofactor.unsigned_abs();
        let zeros = size.leading_zeros();
        // From 2^32 to 2^34, for a cofactor that is not 0.
        let quotient = ((size << (zeros & 63)) / self.mantissa) as i64;
        // The cofactor has 48 fractional bits, the determinant 72, and 48 more are left after the division.
        let shift = zeros as i32 + self.exponent - 48;
        let size = match shift {
            ..=0 => quotient,
            1..=40 => ((quotient >> (shift - 1)) + 1) >> 1,
            _ => 0,
        };
        if (cofactor < 0) == self.is_negative {
            size
        } else {
            -size
        }
    }
}

/// A matrix of these numbers, where they fit.
fn matrix(rows: [[i64; 3]; 3]) -> Result<[[I8F24; 3]; 3], InputError> {
    let fits = rows.iter().flatten().all(|&bits| i32::try_from(bits).is_ok());
    if fits {
        Ok(rows.map(|row| row.map(|bits| I8F24::from_bits(bits as i32))))
    } else {
        Err(InputError::ScaleOutOfDomain)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Affine {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Affine {} at {}",
            self.matrix.map(|row| row.map(|element| element.to_num::<f32>())),
            self.translation.map(|coordinate| coordinate.to_num::<f32>())
        );
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;

    /// A million directions through maps of any shape, against floating point.
    #[test]
    fn unit_vectors_are_within_two_units() {
        let mut state = 0x0123_4567u32;
        let mut next = || {
            // xorshift32 (Marsaglia 2003).
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            state as i32
        };
        let mut worst = 0.0f64;
        for round in 0..1_000_000 {
            let matrix = [[0; 3]; 3].map(|row| row.map(|_: i32| I8F24::from_bits(next() >> (round % 24 + 1))));
            let map = Affine {
                matrix,
                ..Affine::IDENTITY
            };
            let vector = [0; 3].map(|_: i32| next() >> 23);
            let exact = matrix.map(|row| {
                let products = row.iter().zip(vector);
                products
                    .map(|(part, other)| part.to_num::<f64>() * f64::from(other))
                    .sum::<f64>()
            });
            let length = exact.iter().map(|part| part * part).sum::<f64>().sqrt();
            for (found, exact) in map.unit_vector(vector).into_iter().zip(exact) {
                let exact = if length == 0.0 { 0.0 } else { exact / length * 16_384.0 };
                worst = worst.max((f64::from(found) - exact).abs());
            }
        }
        assert!(worst > 0.5 && worst <= 2.0, "{worst}");
    }
}
