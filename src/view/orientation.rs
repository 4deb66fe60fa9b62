//! Rotations about any axis, from a quaternion, and those that turn an object or a camera towards something.
//!
//! Guarantees: as for rotations from angles, the matrix is orthonormal to within 2^-22, however many are composed.

use fixed::types::{I2F30, I16F16, U0F16};

use crate::{
    geometry::InputError,
    view::{
        Rotation,
        sine::{cosine, sine},
        unit_vector::{cross, scaled, unit},
    },
};

impl Rotation {
    /// About an axis of any length, from the origin to a point: right-handed in the axes of this crate, as
    /// [`about_x`](Self::about_x), [`about_y`](Self::about_y) and [`about_z`](Self::about_z), whose matrices it has for their axes.
    ///
    /// Elements are within 2^-26 of the true ones. Cost: a square root, three divisions, 19 multiplications.
    ///
    /// Source: Rodrigues (1840).
    ///
    /// # Errors
    /// [`InputError::NoDirection`] for an axis of length 0.
    pub fn about(axis: [I16F16; 3], angle: U0F16) -> Result<Self, InputError> {
        let axis = axis.map(|coordinate| i64::from(coordinate.to_bits()));
        let axis = unit(scaled(axis).ok_or(InputError::NoDirection)?).map(|coordinate| i64::from(coordinate.to_bits()));
        let sine = i64::from(sine(angle).to_bits());
        let cosine = i64::from(cosine(angle).to_bits());
        let [x, y, z] = axis;
        let [turned_x, turned_y, turned_z] = axis.map(|coordinate| (coordinate * sine + (1 << 29)) >> 30);
        // What does not turn: the part along the axis. A product of coordinates in 2.31, times up to 2 in 2.30, is 2^62 at most.
        let along = |one: i64, other: i64| {
            let product = (one * other + (1 << 28)) >> 29;
            (product * ((1 << 30) - cosine) + (1 << 30)) >> 31
        };
        let (xy, yz, zx) = (along(x, y), along(y, z), along(z, x));
        let matrix = [
            [cosine + along(x, x), xy - turned_z, zx + turned_y],
            [xy + turned_z, cosine + along(y, y), yz - turned_x],
            [zx - turned_y, yz + turned_x, cosine + along(z, z)],
        ];
        // Of the error of three angles: one is that of sine and cosine, the length of the axis enters four times.
        Ok(Self::from_bits(matrix, 3))
    }

    /// The rotation of a quaternion w + xi + yj + zk of any length, `[w, x, y, z]`: by the angle a about the axis u it is
    /// (cos a/2, u sin a/2). A quaternion and its negative are the same rotation.
    ///
    /// Elements are within 2^-27 of those of the exact quaternion. Cost: a square root, four divisions, 18 multiplications.
    ///
    /// Source: Hamilton (1844); Shoemake (1985) for animation.
    ///
    /// # Errors
    /// [`InputError::NoDirection`] for a quaternion of length 0.
    pub fn from_quaternion(quaternion: [I2F30; 4]) -> Result<Self, InputError> {
        let quaternion = quaternion.map(|part| i64::from(part.to_bits()));
        let quaternion = unit(scaled(quaternion).ok_or(InputError::NoDirection)?);
        let [w, x, y, z] = quaternion.map(|part| i64::from(part.to_bits()));
        // Twice a sum of two products, which is 1 at most.
        let twice = |sum: i64| (sum + (1 << 28)) >> 29;
        let matrix = [
            [
                (1 << 30) - twice(y * y + z * z),
                twice(x * y - w * z),
                twice(x * z + w * y),
            ],
            [
                twice(x * y + w * z),
                (1 << 30) - twice(x * x + z * z),
                twice(y * z - w * x),
            ],
            [
                twice(x * z - w * y),
                twice(y * z + w * x),
                (1 << 30) - twice(x * x + y * y),
            ],
        ];
        // The error of the length enters four times.
        Ok(Self::from_bits(matrix, 2))
    }

    /// The rotation that turns the z axis to a direction, and the y axis as near to `up` as that allows: x stays at right angles
    /// to `up`. Both vectors have any length.
    ///
    /// z is within 2^-28 of the direction, the axes are at right angles within 2^-26. Cost: two square roots, six divisions, 24
    /// multiplications.
    ///
    /// # Errors
    /// [`InputError::NoDirection`] where the direction or `up` has length 0, where they are parallel, and where they are so nearly
    /// parallel that they are when rounded to 30 bits.
    pub fn look_at(direction: [I16F16; 3], up: [I16F16; 3]) -> Result<Self, InputError> {
        Self::towards(direction.map(|coordinate| i64::from(coordinate.to_bits())), up)
    }

    /// Turns the z axis to a direction as [`look_at`](Self::look_at) does: with 16 fractional bits and 16 whole ones beside the sign.
    pub(super) fn towards(direction: [i64; 3], up: [I16F16; 3]) -> Result<Self, InputError> {
        let up = up.map(|coordinate| i64::from(coordinate.to_bits()));
        let no_direction = InputError::NoDirection;
        if are_parallel(direction, up) {
            return Err(no_direction);
        }
        let (direction, up) = (scaled(direction).ok_or(no_direction)?, scaled(up).ok_or(no_direction)?);
        let z = unit(direction).map(|coordinate| i64::from(coordinate.to_bits()));
        // Of the direction before it was rounded to length 1, so that a parallel `up` gives no vector at all.
        let x =
            unit(scaled(cross(up, direction)).ok_or(no_direction)?).map(|coordinate| i64::from(coordinate.to_bits()));
        let y = cross(z, x).map(|coordinate| (coordinate + (1 << 29)) >> 30);
        let [[a, b, c], [d, e, f], [g, h, i]] = [x, y, z];
        Ok(Self::from_bits([[a, d, g], [b, e, h], [c, f, i]], 1))
    }
}

/// Whether two vectors are parallel, exactly: coordinates of one are 2^31 in size at most, those of the other below 2^32.
// Both are rounded before they are multiplied, and what that leaves of parallel vectors would be taken for a direction.
fn are_parallel([a, b, c]: [i64; 3], [x, y, z]: [i64; 3]) -> bool {
    b * z == c * y && c * x == a * z && a * y == b * x
}
