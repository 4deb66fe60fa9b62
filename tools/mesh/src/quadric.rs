//! Quadrics: the sum of squared distances of a point from planes, whichever the point is (Garland and Heckbert, "Surface
//! Simplification Using Quadric Error Metrics", 1997).

use crate::vector::{Vector, dot};

/// A sum of squared distances from planes, each with a weight: for a plane `n p + d = 0`, of `n n^T`, `d n` and `d d`.
#[derive(Debug, Copy, Clone, Default)]
pub struct Quadric {
    /// The upper half of the symmetric matrix: xx, xy, xz, yy, yz, zz.
    matrix: [f64; 6],
    vector: Vector,
    constant: f64,
}

impl Quadric {
    /// That of the plane through a point, whose normal has length 1.
    pub fn of_plane(normal: Vector, point: Vector, weight: f64) -> Self {
        let [x, y, z] = normal;
        let distance = -dot(normal, point);
        Self {
            matrix: [x * x, x * y, x * z, y * y, y * z, z * z].map(|product| product * weight),
            vector: normal.map(|coordinate| coordinate * distance * weight),
            constant: distance * distance * weight,
        }
    }

    /// The planes of both.
    pub fn and(self, other: Self) -> Self {
        let mut both = self;
        for (sum, more) in both.matrix.iter_mut().zip(other.matrix) {
            *sum += more;
        }
        for (sum, more) in both.vector.iter_mut().zip(other.vector) {
            *sum += more;
        }
        both.constant += other.constant;
        both
    }

    /// The weighted sum of squared distances of a point.
    pub fn error(&self, point: Vector) -> f64 {
        let ([xx, xy, xz, yy, yz, zz], [x, y, z]) = (self.matrix, point);
        let squares = xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + xz * x * z + yz * y * z);
        // Rounding may leave a little less than 0.
        (squares + 2.0 * dot(self.vector, point) + self.constant).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_is_the_sum_of_squared_distances() {
        let planes = [
            ([0.6, 0.0, 0.8], [10.0, -3.0, 4.0], 1.0),
            ([0.0, 1.0, 0.0], [0.0, 7.0, 0.0], 2.5),
            ([1.0, 0.0, 0.0], [-2.0, 0.0, 0.0], 4.0),
        ];
        let all = planes.iter().fold(Quadric::default(), |all, &(normal, point, weight)| {
            all.and(Quadric::of_plane(normal, point, weight))
        });
        for point in [[0.0; 3], [5.0, -6.0, 70.0], [-300.0, 20.0, 1.0]] {
            let squares = planes.iter().map(|&(normal, on_plane, weight)| {
                let distance = dot(normal, point) - dot(normal, on_plane);
                weight * distance * distance
            });
            let sum: f64 = squares.sum();
            assert!((all.error(point) - sum).abs() < 1e-9 * (1.0 + sum));
        }
    }
}
