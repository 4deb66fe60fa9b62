//! The near plane: cuts faces in eye space, before anything is divided by z.
//!
//! Sutherland and Hodgman's reentrant clipping (1974) against one plane. A cut rounds once, from the end inside to the
//! end outside, so that two faces that share an edge get the same point.

use heapless::Vec;

use crate::view::EyePoint;

/// A face cut by one plane has four corners at most.
pub(crate) fn near_plane(face: &[EyePoint; 3], near: i32) -> Vec<EyePoint, 4> {
    cut_polygon(
        face,
        |point| point.z >= near,
        |inside, outside| cut(inside, outside, near),
    )
}

fn cut(inside: &EyePoint, outside: &EyePoint, near: i32) -> EyePoint {
    // Eye coordinates are below 2^30, so a product of two differences is below 2^62.
    let numerator = i64::from(inside.z) - i64::from(near);
    let denominator = i64::from(inside.z) - i64::from(outside.z);
    let between = |from: i32, to: i32| {
        let change = (i64::from(to) - i64::from(from)) * numerator;
        // Between the two ends, so it fits again.
        from.wrapping_add(change.div_euclid(denominator) as i32)
    };
    EyePoint {
        x: between(inside.x, outside.x),
        y: between(inside.y, outside.y),
        z: near,
    }
}

/// Keeps the part of a convex polygon that is inside, in the same order of corners.
pub(super) fn cut_polygon<P: Copy, const N: usize>(
    corners: &[P],
    inside: impl Fn(&P) -> bool,
    cut: impl Fn(&P, &P) -> P,
) -> Vec<P, N> {
    let mut kept = Vec::new();
    // A convex polygon crosses a plane twice: it gains one corner at most, for which the caller left room.
    let mut keep = |corner: P| kept.push(corner).is_ok();
    let Some(mut previous) = corners.last() else {
        return Vec::new();
    };
    for corner in corners {
        match (inside(previous), inside(corner)) {
            (true, true) => {
                keep(*corner);
            }
            (true, false) => {
                keep(cut(previous, corner));
            }
            (false, true) => {
                keep(cut(corner, previous));
                keep(*corner);
            }
            (false, false) => {}
        }
        previous = corner;
    }
    kept
}
