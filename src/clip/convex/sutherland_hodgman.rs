//! Sutherland and Hodgman (1974): cuts a convex polygon by one plane after another.
//!
//! The near plane cuts in eye space, before anything is divided by z. The guard band then cuts on the screen, where a
//! coordinate would leave the domain of its precision; that is much larger than a display, so few faces meet it, and
//! depth is affine there. A cut rounds once, from the end inside to the end outside, so that two faces that share an
//! edge get the same point. All planes share one loop: faces are seldom cut, and flash is scarce.

use core::num::NonZeroU64;

use heapless::Vec;

use crate::{
    geometry::{divide_long, scale_floor},
    view::ScreenPrecision,
};

/// The corners of a convex polygon: x, y and z of eye space, or x, y and depth on the screen.
///
/// A face has three, the near plane adds one, and each side of the guard band one.
pub(crate) type Polygon<S> = Vec<[<S as ScreenPrecision>::Wide; 3], 8>;

/// A plane across one axis, and the side of it that is kept.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Plane {
    axis: u8,
    limit: i32,
    /// Whether what is below the limit is kept.
    below: bool,
}

impl Plane {
    /// Keeps what is not in front of the near plane.
    pub(crate) const fn near(z: i32) -> Self {
        Self {
            axis: 2,
            limit: z,
            below: false,
        }
    }

    /// The sides of the domain of `S` on the screen: left, right, top, bottom.
    pub(crate) const fn guard_band<S: ScreenPrecision>() -> [Self; 4] {
        const fn side(axis: u8, limit: i32, below: bool) -> Plane {
            Plane { axis, limit, below }
        }
        [
            side(0, S::MIN_UNITS, false),
            side(0, S::MAX_UNITS, true),
            side(1, S::MIN_UNITS, false),
            side(1, S::MAX_UNITS, true),
        ]
    }

    /// How far inside a corner is; below 0 outside.
    pub(crate) fn distance<S: ScreenPrecision>(&self, corner: &[S::Wide; 3]) -> i64 {
        let coordinate: i64 = corner.get(usize::from(self.axis)).copied().unwrap_or_default().into();
        let above = coordinate - i64::from(self.limit);
        // A difference of two coordinates, so it fits again.
        S::wide(if self.below { -above } else { above }).into()
    }
}

/// The part of a polygon on the side of a plane that is kept, its corners in the same order.
#[inline(never)]
pub(crate) fn sutherland_hodgman<S: ScreenPrecision>(polygon: &Polygon<S>, plane: &Plane, kept: &mut Polygon<S>) {
    kept.clear();
    let Some(mut previous) = polygon.last() else {
        return;
    };
    // A convex polygon crosses a plane twice: it gains one corner at most.
    let mut keep = |corner| {
        let pushed = kept.push(corner);
        debug_assert!(pushed.is_ok(), "there is room for a corner more at each plane");
    };
    for corner in polygon {
        let (before, here) = (plane.distance::<S>(previous), plane.distance::<S>(corner));
        if (before < 0) != (here < 0) {
            // From the end inside, whichever it is.
            let (inside, outside, part, beyond) = if here < 0 {
                (previous, corner, before, here)
            } else {
                (corner, previous, here, before)
            };
            let mut cut = *inside;
            for (from, to) in cut.iter_mut().zip(outside) {
                *from = between::<S>((*from).into(), (*to).into(), part, part - beyond);
            }
            keep(cut);
        }
        if here >= 0 {
            keep(*corner);
        }
        previous = corner;
    }
}

/// `from + (to - from) * part / whole`, rounded down, for 0 <= part <= whole.
///
/// Coordinates are below 2^30 with `Sub4`, below 2^34 with `Sub8`. So differences fit 32 and 36 bits, and products of
/// two need 62 and 70.
fn between<S: ScreenPrecision>(from: i64, to: i64, part: i64, whole: i64) -> S::Wide {
    let change = to - from;
    let change = if S::FRACTION_BITS <= 4 {
        divide_long(i64::from(change as i32) * i64::from(part as i32), whole as i32)
            .0
            .into()
    } else {
        // The whole is not 0: it is the distance of two ends on two sides.
        NonZeroU64::new(whole as u64).map_or(0, |whole| scale_floor(change, part as u64, whole))
    };
    S::wide(from + change)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Sub4;

    /// A corner on the plane stays as it is; one unit in front of it is outside, one unit behind it inside.
    #[test]
    fn the_plane_itself_is_kept() {
        let cut = |corners: [[i32; 3]; 3]| {
            let (polygon, mut kept) = (corners.into_iter().collect(), Polygon::<Sub4>::new());
            sutherland_hodgman::<Sub4>(&polygon, &Plane::near(500), &mut kept);
            kept
        };
        let [a, b, c] = [[0, 0, 500], [80, 0, 501], [0, 80, 499]];
        // The edge from outside is cut where it ends.
        assert_eq!(cut([a, b, c]), [a, a, b, [40, 40, 500]]);
        assert_eq!(cut([a, b, a]), [a, b, a]);
        assert!(cut([c, c, c]).is_empty());
    }
}
