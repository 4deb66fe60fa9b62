//! Vectors in double precision, which the tests of lights compare with.

extern crate std;

/// The scalar product of two vectors.
pub(super) fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

/// A vector of length 1 in the direction of another one.
pub(super) fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = dot(vector, vector).sqrt();
    vector.map(|coordinate| coordinate / length)
}
