//! Normals of faces as exact integers, and by how much two of them turn.
//!
//! The cosine of the angle between two normals is their dot product divided by both lengths. It is compared with another number
//! without a root or a division, by squares: of up to 160 bits, so that nothing is rounded.

/// The normal of a triangle, cross(b - a, c - a): as long as twice its area, below 2^35 along each axis.
pub(super) const fn normal([a, b, c]: [[i16; 3]; 3]) -> [i64; 3] {
    cross(way(a, b), way(a, c))
}

/// The way from one position to another, below 2^16 along each axis.
pub(super) const fn way([x, y, z]: [i16; 3], [to_x, to_y, to_z]: [i16; 3]) -> [i64; 3] {
    [to_x as i64 - x as i64, to_y as i64 - y as i64, to_z as i64 - z as i64]
}

/// The cross product of two ways.
pub(super) const fn cross([x, y, z]: [i64; 3], [u, v, w]: [i64; 3]) -> [i64; 3] {
    [y * w - z * v, z * u - x * w, x * v - y * u]
}

/// The dot product.
pub(super) const fn dot([x, y, z]: [i64; 3], [u, v, w]: [i64; 3]) -> i128 {
    x as i128 * u as i128 + y as i128 * v as i128 + z as i128 * w as i128
}

/// Whether the cosine of the angle between two normals of triangles is less than one with 14 fractional bits, from -1 to 1.
/// Normals without a length turn by no angle.
pub(super) const fn cosine_is_below(one: [i64; 3], other: [i64; 3], cosine: i16) -> bool {
    let dot = dot(one, other);
    let squares = (square(one), square(other));
    if squares.0 == 0 || squares.1 == 0 {
        return false;
    }
    if dot < 0 && cosine >= 0 || dot >= 0 && cosine <= 0 {
        return dot < 0;
    }
    // Both have the same sign. A normal is at most sqrt(3) 2^32 long, so that squares and the dot product are below 2^66.
    let scaled = dot.unsigned_abs() << 14;
    let left = wide_product(scaled, scaled);
    let right = wide_product(
        squares.0,
        squares.1 * (cosine.unsigned_abs() as u128 * cosine.unsigned_abs() as u128),
    );
    if dot < 0 {
        is_less(right, left)
    } else {
        is_less(left, right)
    }
}

/// The square of a length.
pub(super) const fn square(way: [i64; 3]) -> u128 {
    dot(way, way).unsigned_abs()
}

/// The product of two numbers below 2^96: its bits from the 128th on, and the lower ones.
pub(super) const fn wide_product(one: u128, other: u128) -> (u128, u128) {
    const LOW: u128 = u64::MAX as u128;
    let (a, b) = (one >> 64, one & LOW);
    let (c, d) = (other >> 64, other & LOW);
    // Two products of 64 and 32 bits.
    let middle = a * d + b * c;
    let (low, carry) = (b * d).overflowing_add((middle & LOW) << 64);
    (a * c + (middle >> 64) + carry as u128, low)
}

/// Whether a number of 256 bits is less than another one.
pub(super) const fn is_less(one: (u128, u128), other: (u128, u128)) -> bool {
    one.0 < other.0 || one.0 == other.0 && one.1 < other.1
}
