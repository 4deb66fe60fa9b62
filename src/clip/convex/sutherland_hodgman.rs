//! Sutherland and Hodgman (1974): cuts a convex polygon by one plane after another.
//!
//! The near and the far plane cut in eye space, before anything is divided by z. The guard band then cuts on the screen, where
//! a coordinate would leave the domain of its precision; that is much larger than a display, so few faces meet it, and depth is
//! affine there. A cut rounds once, from the end inside to the end outside, so that two faces that share an edge get the same
//! point. All planes share one loop: faces are seldom cut, and flash is scarce.

use core::num::NonZeroU64;

use heapless::Vec;

use crate::{
    geometry::{divide_long, scale_floor},
    view::ScreenPrecision,
};

/// A corner of a convex polygon.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct PolygonCorner<S: ScreenPrecision, A> {
    /// x, y and z of eye space, or x, y and depth on the screen.
    pub(crate) position: [S::Wide; 3],
    /// The attributes of the corner: numbers that vary over the polygon, such as texture coordinates.
    pub(crate) attributes: A,
}

/// The corners of a convex polygon. A face has three, the near and the far plane add one each, and each side of the guard band
/// one.
pub(crate) type Polygon<S, A> = Vec<PolygonCorner<S, A>, 9>;

// Not re-exported: what varies over faces is sealed.
/// Attributes of the corners of a polygon, such as texture coordinates, which the corners that a plane adds get as well.
pub trait CutAttributes: Copy {
    /// Whether they vary evenly in space, and on the screen only when they are multiplied by the depth.
    const NEED_DEPTH: bool;

    /// The attributes of a point between two corners: how far it is from the first and from the second one, in any unit, and
    /// the depths of both, which are 1 where ways are ways in space. Where both ways are 0, those of the first corner.
    fn between(from: &Self, to: &Self, ways: [u64; 2], depths: [u64; 2]) -> Self;
}

/// A plane across one axis, and the side of it that is kept.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Plane {
    axis: u8,
    limit: i32,
    /// Whether what is below the limit is kept.
    below: bool,
    /// Whether the plane cuts projected corners of a picture in perspective, where depths vary evenly along an edge and
    /// distances do not.
    is_in_perspective: bool,
}

impl Plane {
    /// Keeps what is not in front of the near plane.
    pub(crate) const fn near(z: i32) -> Self {
        Self {
            axis: 2,
            limit: z,
            below: false,
            is_in_perspective: false,
        }
    }

    /// Keeps what is not behind the far plane.
    pub(crate) const fn far(z: i32) -> Self {
        Self {
            below: true,
            ..Self::near(z)
        }
    }

    /// The sides of the domain of `S` on the screen: left, right, top, bottom.
    pub(crate) const fn guard_band<S: ScreenPrecision>(is_in_perspective: bool) -> [Self; 4] {
        const fn side(axis: u8, limit: i32, below: bool, is_in_perspective: bool) -> Plane {
            Plane {
                axis,
                limit,
                below,
                is_in_perspective,
            }
        }
        [
            side(0, S::MIN_UNITS, false, is_in_perspective),
            side(0, S::MAX_UNITS, true, is_in_perspective),
            side(1, S::MIN_UNITS, false, is_in_perspective),
            side(1, S::MAX_UNITS, true, is_in_perspective),
        ]
    }

    /// How far inside a corner is; below 0 outside.
    pub(crate) fn distance<S: ScreenPrecision>(&self, corner: &[S::Wide; 3]) -> i64 {
        let coordinate: i64 = corner.get(usize::from(self.axis)).copied().unwrap_or_default().into();
        let above = coordinate - i64::from(self.limit);
        // A difference of two coordinates, so it fits again.
        S::wide(if self.below { -above } else { above }).into()
    }

    /// The attributes where an edge crosses the plane, whose ends have these distances from it.
    #[inline(always)]
    fn cut_attributes<S: ScreenPrecision, A: CutAttributes>(
        &self,
        inside: &PolygonCorner<S, A>,
        outside: &PolygonCorner<S, A>,
        [part, rest]: [u64; 2],
    ) -> A {
        // In perspective, what varies evenly in space has the weight of its depth on the screen. Distances are below 2^35 and
        // depths below 2^24.
        let depth = |corner: &PolygonCorner<S, A>| {
            if A::NEED_DEPTH && self.is_in_perspective {
                let [_, _, z]: [S::Wide; 3] = corner.position;
                z.into() as u64
            } else {
                1
            }
        };
        let depths = [depth(inside), depth(outside)];
        A::between(&inside.attributes, &outside.attributes, [part, rest], depths)
    }
}

/// The part of a polygon on the side of a plane that is kept, its corners in the same order.
#[inline(never)]
pub(crate) fn sutherland_hodgman<S: ScreenPrecision, A: CutAttributes>(
    polygon: &Polygon<S, A>,
    plane: &Plane,
    kept: &mut Polygon<S, A>,
) {
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
        let distance = |corner: &PolygonCorner<S, A>| plane.distance::<S>(&corner.position);
        let (before, here) = (distance(previous), distance(corner));
        if (before < 0) != (here < 0) {
            // From the end inside, whichever it is.
            let (inside, outside, part, beyond) = if here < 0 {
                (previous, corner, before, here)
            } else {
                (corner, previous, here, before)
            };
            let mut cut = *inside;
            move_to_crossing::<S>(&mut cut.position, &outside.position, [part, beyond]);
            cut.attributes = plane.cut_attributes(inside, outside, [part as u64, beyond.unsigned_abs()]);
            keep(cut);
        }
        if here >= 0 {
            keep(*corner);
        }
        previous = corner;
    }
}

/// The part of a segment on the side of a plane that is kept, from the same end on; `None` where all of it is beyond. A cut is
/// the corner that a polygon with this edge gets there.
pub(crate) fn cut_segment<S: ScreenPrecision>(
    [mut from, mut to]: [[S::Wide; 3]; 2],
    plane: &Plane,
) -> Option<[[S::Wide; 3]; 2]> {
    let (before, after) = (plane.distance::<S>(&from), plane.distance::<S>(&to));
    match (before < 0, after < 0) {
        (true, true) => return None,
        (true, false) => {
            let outside = core::mem::replace(&mut from, to);
            move_to_crossing::<S>(&mut from, &outside, [after, before]);
        }
        (false, true) => {
            let outside = core::mem::replace(&mut to, from);
            move_to_crossing::<S>(&mut to, &outside, [before, after]);
        }
        (false, false) => {}
    }
    Some([from, to])
}

/// Moves a corner inside of a plane to where the edge to one outside crosses the plane. The distances of both are those from
/// the plane, not below 0 and below it.
#[inline]
fn move_to_crossing<S: ScreenPrecision>(inside: &mut [S::Wide; 3], outside: &[S::Wide; 3], [part, beyond]: [i64; 2]) {
    for (from, to) in inside.iter_mut().zip(*outside) {
        *from = between::<S>((*from).into(), to.into(), part, part - beyond);
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
            let corner = |position| PolygonCorner {
                position,
                attributes: (),
            };
            let (polygon, mut kept) = (corners.map(corner).into_iter().collect(), Polygon::<Sub4, ()>::new());
            sutherland_hodgman(&polygon, &Plane::near(500), &mut kept);
            kept.iter().map(|corner| corner.position).collect::<Vec<_, 8>>()
        };
        let [a, b, c] = [[0, 0, 500], [80, 0, 501], [0, 80, 499]];
        // The edge from outside is cut where it ends.
        assert_eq!(cut([a, b, c]), [a, a, b, [40, 40, 500]]);
        assert_eq!(cut([a, b, a]), [a, b, a]);
        assert!(cut([c, c, c]).is_empty());
    }

    /// A segment is cut where a polygon is that has it as an edge, in whichever direction.
    #[test]
    fn segments_are_cut_as_edges_are() {
        let plane = Plane::near(500);
        let ends = [[-70, 11, 503], [80, -9, 496]];
        let corner = |position| PolygonCorner {
            position,
            attributes: (),
        };
        let mut kept = Polygon::<Sub4, ()>::new();
        sutherland_hodgman(&ends.into_iter().map(corner).collect(), &plane, &mut kept);
        let [from, to] = ends;
        let cut = kept[0].position;
        assert_eq!(cut, [-6, 2, 500]);
        assert_eq!(cut_segment::<Sub4>([from, to], &plane), Some([from, cut]));
        assert_eq!(cut_segment::<Sub4>([to, from], &plane), Some([cut, from]));
        assert_eq!(cut_segment::<Sub4>([from, from], &plane), Some([from, from]));
        assert_eq!(cut_segment::<Sub4>([to, to], &plane), None);
    }
}
