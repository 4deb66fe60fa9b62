//! Normals in two bytes: unit vectors on an octahedron that is unfolded into a square.
//!
//! ```text
//!     -127       127
//! -127  +----+----+      the faces with z >= 0 are the diamond in the middle,
//!       | \  |  / |      those with z < 0 are folded out over its edges
//!       |  \ | /  |
//!       +----+----+
//!       |  / | \  |
//!       | /  |  \ |
//!  127  +----+----+
//! ```
//!
//! Source: Meyer, Suessmuth, Sussner, Stamminger, Greiner (2010), "On floating-point normal vectors"; Cigolle and others
//! (2014).

/// The direction of a normal that is stored in two bytes, as a vector of length 1 in 2.14: within 4 units of 1/16,384 of the
/// exact direction of the two bytes. Cost: 9 multiplications and no division.
#[inline]
pub(crate) fn unit_normal(bytes: [i8; 2]) -> [i32; 3] {
    let [x, y, z] = normal(bytes);
    // From 5,377, as of (42, 42, 43), to 16,643 of (1, 1, -129), where both bytes are -128.
    let square = x * x + y * y + z * z;
    let scale = reciprocal_square_root(square);
    // In units of 1/128: the square root of 2^14.
    let scaled = |coordinate: i32| (coordinate * scale + 64) >> 7;
    [scaled(x), scaled(y), scaled(z)]
}

/// A normal that is stored in two bytes, as a vector of whole numbers of any length: its direction is exact.
#[inline]
pub(crate) fn normal([a, b]: [i8; 2]) -> [i32; 3] {
    let (a, b) = (i32::from(a), i32::from(b));
    let z = 127 - a.abs() - b.abs();
    let (x, y) = if z < 0 { (folded(a, b), folded(b, a)) } else { (a, b) };
    [x, y, z]
}

/// A coordinate on the other side of the octahedron.
#[inline]
fn folded(coordinate: i32, other: i32) -> i32 {
    let size = 127 - other.abs();
    if coordinate < 0 { -size } else { size }
}

/// 2^21 / sqrt(square), for squares from 5,377 to 16,643: a line, then two steps of Newton's method.
#[inline]
fn reciprocal_square_root(square: i32) -> i32 {
    // 2.043 - 1.124 x for x = square / 2^14, with 14 fractional bits: within 5 % of 1 / sqrt(x).
    let estimate = 33_472 - ((square * 1_151) >> 10);
    newton_step(square, newton_step(square, estimate))
}

/// y (3 - x y^2) / 2, which doubles the number of right bits.
#[inline]
fn newton_step(square: i32, estimate: i32) -> i32 {
    // An estimate below 2^15: its square, in 14 bits, is below 2^16, and times the square below 2^16 once more.
    let product = (((estimate * estimate) >> 14) * square) >> 14;
    (estimate * ((3 << 14) - product)) >> 15
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All 65,536 of them, against floating point.
    #[test]
    fn every_normal_has_length_one_and_its_direction() {
        let mut worst = 0.0_f64;
        for a in i8::MIN..=i8::MAX {
            for b in i8::MIN..=i8::MAX {
                let (x, y) = (f64::from(a), f64::from(b));
                let z = 127.0 - x.abs() - y.abs();
                let fold = |one: f64, other: f64| (127.0 - other.abs()) * if one < 0.0 { -1.0 } else { 1.0 };
                let exact = if z < 0.0 {
                    [fold(x, y), fold(y, x), z]
                } else {
                    [x, y, z]
                };
                let length = exact.iter().map(|value| value * value).sum::<f64>().sqrt();
                for (unit, exact) in unit_normal([a, b]).into_iter().zip(exact) {
                    worst = worst.max((f64::from(unit) - exact / length * 16_384.0).abs());
                }
            }
        }
        assert!(worst < 4.0, "{worst}");
    }
}
