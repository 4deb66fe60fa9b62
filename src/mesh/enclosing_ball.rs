//! Small balls and discs around points.
//!
//! How it works: a ball through two points far from each other grows by each point that lies outside of it, just so far that it
//! reaches the point and keeps its far side.
//!
//! ```text
//!        .--.           .----.
//!       /    \         /      \
//!      |  c   | o  ->  |   c   o     the far side stays where it is, the centre moves towards the new point
//!       \    /         \      /
//!        '--'           '----'
//! ```
//!
//! Guarantees: all points lie in the ball, exactly: its radius is measured from the centre in whole units, rounded up. It is at
//! most as large as the one around the middle of the box around the points. Numbers stay below 2^55.
//!
//! Source: Ritter (1990), "An efficient bounding sphere", in Graphics Gems.

use crate::mesh::BoundingBox;

/// Fractional bits of a centre while the ball grows.
const FRACTION_BITS: u32 = 8;

/// The centre and the radius of a small ball around points, as far as the axes go that `weights` have as 1; those that they
/// have as 0 are left out: two axes give a disc. `None` where there are no points.
pub(super) const fn ball_around(points: &[[i16; 3]], weights: [i64; 3]) -> Option<([i16; 3], u16)> {
    let [start, ..] = points else { return None };
    let middle = weighted(BoundingBox::around(points).middle(), weights);
    let one = farthest(points, weighted(*start, weights), weights);
    let other = farthest(points, one, weights);
    let grown = grown_centre(points, [one, other], weights);
    let (of_middle, of_grown) = (radius(points, middle, weights), radius(points, grown, weights));
    let ([x, y, z], radius) = if of_grown < of_middle {
        (grown, of_grown)
    } else {
        (middle, of_middle)
    };
    // From the middle of a box of 16-bit coordinates all points are less than 56,757 away.
    Some(([x as i16, y as i16, z as i16], radius as u16))
}

/// The centre of the ball through two points, grown by all others, rounded to whole units.
const fn grown_centre(points: &[[i16; 3]], [one, other]: [[i64; 3]; 2], weights: [i64; 3]) -> [i64; 3] {
    let half = 1 << (FRACTION_BITS - 1);
    let ([x1, y1, z1], [x2, y2, z2]) = (one, other);
    let mut centre = [(x1 + x2) * half, (y1 + y2) * half, (z1 + z2) * half];
    let mut radius = (square(difference(one, other)) << (2 * FRACTION_BITS - 2)).isqrt() as i64;
    let mut rest = points;
    while let [point, others @ ..] = rest {
        let [x, y, z] = weighted(*point, weights);
        let way = difference([x << FRACTION_BITS, y << FRACTION_BITS, z << FRACTION_BITS], centre);
        let distance = square(way).isqrt() as i64;
        if distance > radius {
            let (part, whole) = (distance - radius, 2 * distance);
            let ([x, y, z], [way_x, way_y, way_z]) = (centre, way);
            centre = [
                x + way_x * part / whole,
                y + way_y * part / whole,
                z + way_z * part / whole,
            ];
            radius = (radius + distance) / 2;
        }
        rest = others;
    }
    let [x, y, z] = centre;
    [
        (x + half) >> FRACTION_BITS,
        (y + half) >> FRACTION_BITS,
        (z + half) >> FRACTION_BITS,
    ]
}

/// The point that is farthest from a place.
const fn farthest(points: &[[i16; 3]], from: [i64; 3], weights: [i64; 3]) -> [i64; 3] {
    let (mut found, mut most) = (from, 0);
    let mut rest = points;
    while let [point, others @ ..] = rest {
        let point = weighted(*point, weights);
        let distance = square(difference(point, from));
        if distance > most {
            (found, most) = (point, distance);
        }
        rest = others;
    }
    found
}

/// The least whole radius of a ball around all points with this centre.
const fn radius(points: &[[i16; 3]], centre: [i64; 3], weights: [i64; 3]) -> u64 {
    let most = square(difference(farthest(points, centre, weights), centre));
    let root = most.isqrt();
    if root * root < most { root + 1 } else { root }
}

const fn weighted([x, y, z]: [i16; 3], [of_x, of_y, of_z]: [i64; 3]) -> [i64; 3] {
    [x as i64 * of_x, y as i64 * of_y, z as i64 * of_z]
}

const fn difference([x1, y1, z1]: [i64; 3], [x0, y0, z0]: [i64; 3]) -> [i64; 3] {
    [x1 - x0, y1 - y0, z1 - z0]
}

const fn square([x, y, z]: [i64; 3]) -> u64 {
    (x * x + y * y + z * z) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// xorshift32 (Marsaglia 2003).
    fn numbers() -> impl FnMut() -> i32 {
        let mut state = 0x0123_4567u32;
        move || {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            state as i32
        }
    }

    /// Twice the radius of the least ball is no less than the greatest distance of two points, and by Jung (1901) no more than
    /// that times the root of 3/2.
    #[test]
    fn all_points_are_inside_and_the_ball_is_small() {
        let mut next = numbers();
        let mut excess = 0.0;
        for round in 0..3_000 {
            let count = 1 + round % 9;
            let shift = round % 12;
            let mut points = [[0; 3]; 9];
            for point in &mut points {
                *point = [next(), next(), next()].map(|number| (number >> 16 >> shift) as i16);
            }
            let points = &points[..count];
            for weights in [[1, 1, 1], [1, 0, 1], [0, 1, 1]] {
                let (centre, radius) = ball_around(points, weights).unwrap();
                let far = |from: [i16; 3]| {
                    let distances = points
                        .iter()
                        .map(|to| square(difference(weighted(*to, weights), weighted(from, weights))));
                    distances.max().unwrap()
                };
                let needed = far(centre);
                assert!(needed <= u64::from(radius).pow(2), "{points:?}");
                assert!(radius == 0 || needed > u64::from(radius - 1).pow(2), "{points:?}");
                let diameter = (points.iter().map(|point| far(*point)).max().unwrap() as f64).sqrt();
                let least = diameter / 2.0;
                assert!(
                    f64::from(radius) <= least * 1.5f64.sqrt() * 1.2 + 2.0,
                    "{points:?} {radius} {least}"
                );
                excess += f64::from(radius) / (least + 1.0) / 9_000.0;
            }
        }
        assert!(excess < 1.1, "{excess}");
        assert_eq!(ball_around(&[], [1; 3]), None);
        let corners = [[i16::MIN; 3], [i16::MAX; 3]];
        assert_eq!(ball_around(&corners, [1; 3]), Some(([-1; 3], 56_756)));
    }
}
