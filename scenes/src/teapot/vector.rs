//! Vectors of integers.

pub(super) const fn difference(one: [i16; 3], other: [i16; 3]) -> [i64; 3] {
    [
        one[0] as i64 - other[0] as i64,
        one[1] as i64 - other[1] as i64,
        one[2] as i64 - other[2] as i64,
    ]
}

pub(super) const fn cross(one: [i64; 3], other: [i64; 3]) -> [i64; 3] {
    [
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    ]
}

pub(super) const fn dot(one: [i64; 3], other: [i64; 3]) -> i64 {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

/// The length, rounded down.
pub(super) const fn length(vector: [i64; 3]) -> i64 {
    dot(vector, vector).isqrt()
}
