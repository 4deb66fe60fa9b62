//! A direction as a point of an octahedron's net (Meyer et al. 2010; Cigolle et al. 2014), of 8 bits each.

use super::vector::dot;

/// The direction, x and y projected onto |x| + |y| + |z| = 127, with the lower half folded outwards. Of the four grid points
/// around the exact one it is the one whose direction is nearest (method "oct16P" of Cigolle et al.).
///
/// The direction may have any length, up to 2^60 in each coordinate, but 0.
pub(super) const fn encode(direction: [i64; 3]) -> [i8; 2] {
    let [x, y, z] = shortened(direction);
    let sum = x.abs() + y.abs() + z.abs();
    let (mut a, mut b) = (x * 127, y * 127);
    if z < 0 {
        let folded = (127 * sum - b.abs(), 127 * sum - a.abs());
        (a, b) = (with_sign(folded.0, a), with_sign(folded.1, b));
    }
    let (left, low) = (a.div_euclid(sum), b.div_euclid(sum));
    let mut best = [left, low];
    let mut corner = 1;
    while corner < 4 {
        let other = [left + corner % 2, low + corner / 2];
        if is_within(other) && is_nearer(decode(other), decode(best), [x, y, z]) {
            best = other;
        }
        corner += 1;
    }
    [best[0] as i8, best[1] as i8]
}

/// The direction of a point of the net, of any length.
const fn decode([a, b]: [i64; 2]) -> [i64; 3] {
    let z = 127 - a.abs() - b.abs();
    if z < 0 {
        [with_sign(127 - b.abs(), a), with_sign(127 - a.abs(), b), z]
    } else {
        [a, b, z]
    }
}

const fn with_sign(magnitude: i64, sign: i64) -> i64 {
    if sign < 0 { -magnitude } else { magnitude }
}

const fn is_within([a, b]: [i64; 2]) -> bool {
    a.abs() <= 127 && b.abs() <= 127
}

/// With 20 bits: the shorter direction differs by less than a thousandth of a degree.
const fn shortened([x, y, z]: [i64; 3]) -> [i64; 3] {
    let bits = (x.abs() + y.abs() + z.abs()).ilog2() + 1;
    let divisor = 1 << bits.saturating_sub(20);
    [x / divisor, y / divisor, z / divisor]
}

/// Whether the first direction makes a smaller angle with the wanted one than the second, both less than a right one.
const fn is_nearer(one: [i64; 3], other: [i64; 3], wanted: [i64; 3]) -> bool {
    let (near, far) = (dot(one, wanted) as i128, dot(other, wanted) as i128);
    near * near * dot(other, other) as i128 > far * far * dot(one, one) as i128
}
