//! What lies in front of what, in exact integers, decided for points that coincide as well.
//!
//! An edge may pass through the corner of a face, along its side, or touch it. All such cases are decided as if all edges were moved
//! by a distance smaller than any: nearer by h, right by e and down by e², where e is smaller than any fraction of h (simulation
//! of simplicity, Edelsbrunner and Mücke 1990). Then nothing coincides: an edge has each corner on one side, and crosses a side
//! of a face or does not. Edges that share a vertex are moved together, so that they still share it, and an edge lies in front of
//! the faces that it is a side of.

use core::num::NonZeroU32;

use crate::{
    geometry::quotient_down,
    visible::hidden_lines::{LinePoint, hiding::side, parts::PARAMETER_BITS},
};

/// The least and the greatest x, y and depth of some points.
#[derive(Debug, Copy, Clone)]
struct Bounds {
    least: LinePoint,
    greatest: LinePoint,
}

/// An edge on the screen, between two ends that differ there.
#[derive(Debug, Copy, Clone)]
pub(super) struct Segment {
    pub(super) from: LinePoint,
    pub(super) to: LinePoint,
    bounds: Bounds,
}

/// A face that is seen: its corners run clockwise on the screen, and it has an area.
#[derive(Debug, Copy, Clone)]
pub(super) struct Triangle {
    corners: [LinePoint; 3],
    bounds: Bounds,
}

/// A change of the number of faces in front of an edge.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Change {
    /// Where on the edge, as a parameter of [`PARAMETER_BITS`], rounded down.
    pub(super) at: u32,
    /// 1 where the edge goes behind a face, -1 where it comes out; the sum of several at the same parameter.
    pub(super) by: i32,
}

impl Bounds {
    fn of(first: LinePoint, others: &[LinePoint]) -> Self {
        let choose = |choice: fn(i32, i32) -> i32| {
            others.iter().fold(first, |chosen, point| LinePoint {
                x: choice(chosen.x, point.x),
                y: choice(chosen.y, point.y),
                depth: choice(chosen.depth, point.depth),
            })
        };
        Self {
            least: choose(i32::min),
            greatest: choose(i32::max),
        }
    }

    /// Whether two bounds have a point in common.
    const fn meets(&self, other: &Self) -> bool {
        let (least, greatest) = (self.least, self.greatest);
        least.x <= other.greatest.x
            && other.least.x <= greatest.x
            && least.y <= other.greatest.y
            && other.least.y <= greatest.y
            && least.depth <= other.greatest.depth
            && other.least.depth <= greatest.depth
    }

    /// Whether something within these bounds may lie in front of something within the others.
    fn may_hide(&self, hidden: &Self) -> bool {
        let (least, greatest) = (self.least, self.greatest);
        greatest.depth > hidden.least.depth
            && least.x <= hidden.greatest.x
            && hidden.least.x <= greatest.x
            && least.y <= hidden.greatest.y
            && hidden.least.y <= greatest.y
    }
}

/// Whether a point of an edge, moved, is right of the side of a face from `a` to `b`, given twice the area of all three.
fn is_right_of(a: LinePoint, b: LinePoint, area: i64) -> bool {
    area > 0 || area == 0 && (b.y < a.y || b.y == a.y && b.x > a.x)
}

/// How far the plane of a face is in front of a point, times twice the area of the face: below 2^72 in size.
fn in_front([a, b, c]: [LinePoint; 3], point: LinePoint) -> i128 {
    let product = |area: i64, depth: i32| i128::from(area) * i128::from(depth);
    product(side([a, b], c), a.depth - point.depth)
        + product(side([a, point], c), b.depth - a.depth)
        + product(side([a, b], point), c.depth - a.depth)
}

/// The parameter of a point of an edge, rounded down: what `from` is of `from - to`, two numbers that do not have the same sign.
fn parameter(from: i128, to: i128) -> u32 {
    let (part, whole) = (from.unsigned_abs(), from.unsigned_abs() + to.unsigned_abs());
    // 32 bits of the whole are enough.
    let shift = (u128::BITS - whole.leading_zeros()).saturating_sub(u32::BITS);
    match NonZeroU32::new((whole >> shift) as u32) {
        Some(whole) => quotient_down(u64::from((part >> shift) as u32) << PARAMETER_BITS, whole),
        None => 0,
    }
}

impl Segment {
    /// `None` where the ends do not differ on the screen: an edge that is seen from its end.
    pub(super) fn new([from, to]: [LinePoint; 2]) -> Option<Self> {
        let bounds = Bounds::of(from, &[to]);
        (from.x != to.x || from.y != to.y).then_some(Self { from, to, bounds })
    }

    /// Whether a point is right of the edge, moved, given twice the area of both ends and the point.
    fn has_on_right(&self, area: i64) -> bool {
        let (from, to) = (self.from, self.to);
        area > 0 || area == 0 && (to.y > from.y || to.y == from.y && to.x < from.x)
    }

    /// What changes where the edge passes behind a side from `a` to `b` of a face, which lies right of it; `None` where the edge
    /// does not.
    pub(super) fn behind(&self, [a, b]: [LinePoint; 2]) -> Option<Change> {
        if !Bounds::of(a, &[b]).may_hide(&self.bounds) {
            return None;
        }
        let (from, to) = (side([a, b], self.from), side([a, b], self.to));
        let enters = is_right_of(a, b, to);
        if is_right_of(a, b, from) == enters {
            return None;
        }
        let [first, second] = [a, b].map(|end| side([self.from, self.to], end));
        if self.has_on_right(first) == self.has_on_right(second) {
            return None;
        }
        // The crossing is at from / (from - to) of the edge, and at -first / (from - to) of the side.
        let whole = i128::from(from - to);
        let depth = |[start, end]: [i32; 2], part: i64| {
            // Below 2^71.
            i128::from(start) * whole + i128::from(end - start) * i128::from(part)
        };
        let of_side = depth([a.depth, b.depth], -first);
        let of_edge = depth([self.from.depth, self.to.depth], from);
        let is_nearer = if whole > 0 {
            of_side > of_edge
        } else {
            of_side < of_edge
        };
        is_nearer.then(|| Change::new(from.into(), to.into(), enters))
    }

    /// What changes where the edge goes through a face; `None` where it does not.
    pub(super) fn through(&self, face: &Triangle) -> Option<Change> {
        if !face.bounds.may_hide(&self.bounds) || face.bounds.least.depth > self.bounds.greatest.depth {
            return None;
        }
        let [from, to] = [self.from, self.to].map(|end| in_front(face.corners, end));
        let enters = to > 0;
        if (from > 0) == enters || !self.meets_within(face, [from, to]) {
            return None;
        }
        Some(Change::new(from, to, enters))
    }

    /// Whether the point at `from / (from - to)` of the edge is within a face, whose plane the edge meets there.
    fn meets_within(&self, face: &Triangle, [from, to]: [i128; 2]) -> bool {
        let comes_out = from > to;
        face.sides().into_iter().all(|[a, b]| {
            let (start, end) = (side([a, b], self.from), side([a, b], self.to));
            // Below 2^118. The area at that point, times from - to.
            let there = i128::from(end) * from - i128::from(start) * to;
            if there != 0 {
                (there > 0) == comes_out
            } else if start != end {
                // Moved nearer, the edge comes out of the face earlier, and goes behind it later.
                (start > end) == comes_out
            } else {
                is_right_of(a, b, start)
            }
        })
    }
}

impl Change {
    pub(super) const NONE: Self = Self { at: 0, by: 0 };

    /// The change at `from / (from - to)` of an edge.
    fn new(from: i128, to: i128, enters: bool) -> Self {
        Self {
            at: parameter(from, to),
            by: if enters { 1 } else { -1 },
        }
    }

    /// What takes the change out of the number again.
    pub(super) fn reversed(self) -> Self {
        Self { by: -self.by, ..self }
    }
}

impl Triangle {
    /// The corners may run in either sense; `None` where the face is seen on edge.
    pub(super) fn new([a, b, c]: [LinePoint; 3]) -> Option<Self> {
        let corners = match side([a, b], c).signum() {
            1 => [a, b, c],
            -1 => [a, c, b],
            _ => return None,
        };
        let bounds = Bounds::of(a, &[b, c]);
        Some(Self { corners, bounds })
    }

    /// The sides, each with the face on its right.
    pub(super) fn sides(&self) -> [[LinePoint; 2]; 3] {
        let [a, b, c] = self.corners;
        [[a, b], [b, c], [c, a]]
    }

    /// Whether the face may have a point in common with another one.
    pub(super) const fn meets(&self, other: &Self) -> bool {
        self.bounds.meets(&other.bounds)
    }

    /// Whether the face lies in front of a point of an edge.
    pub(super) fn hides(&self, point: LinePoint) -> bool {
        let covers = |[a, b]: [LinePoint; 2]| is_right_of(a, b, side([a, b], point));
        self.bounds.may_hide(&Bounds::of(point, &[]))
            && self.sides().into_iter().all(covers)
            && in_front(self.corners, point) > 0
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;

    /// What an edge passes and goes through adds up to what rays say at its ends, wherever corners, sides and ends coincide.
    #[test]
    fn changes_of_any_face_add_up() {
        // xorshift32 (Marsaglia 2003).
        let mut state = 0x0123_4567u32;
        let mut next = |range: u32| {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            (state % range) as i32
        };
        let (mut hidden, mut entered, mut passed) = (0, 0, 0);
        for _ in 0..100_000 {
            let mut point = || LinePoint {
                x: next(5),
                y: next(5),
                depth: next(4),
            };
            let (corners, ends) = ([point(), point(), point()], [point(), point()]);
            let (Some(face), Some(edge)) = (Triangle::new(corners), Segment::new(ends)) else {
                continue;
            };
            let behind = face.sides().into_iter().filter_map(|side| edge.behind(side));
            let (behind, through) = (behind.map(|change| change.by).collect::<Vec<_>>(), edge.through(&face));
            let sum = behind.iter().sum::<i32>() + through.map_or(0, |change| change.by);
            let [from, to] = ends.map(|end| i32::from(face.hides(end)));
            assert_eq!(from + sum, to, "{corners:?} {ends:?}");
            hidden += from;
            passed += behind.len();
            entered += usize::from(through.is_some());
        }
        assert!(
            hidden > 500 && entered > 500 && passed > 500,
            "{hidden} {entered} {passed}"
        );
    }

    /// Along the same edge, one face gives the parameters of its changes in their order, at the ends of the domain, too.
    #[test]
    fn parameters_are_parts_of_an_edge() {
        let far = 8_191 * 256;
        let point = |x: i32, y: i32, depth: i32| LinePoint { x, y, depth };
        let deepest = (1 << 24) - 1;
        let face = Triangle::new([point(-far, -far, 0), point(far, -far, deepest), point(0, far, deepest)]).unwrap();
        let edge = Segment::new([point(-far, 0, deepest / 2), point(far, 0, deepest / 2)]).unwrap();
        let mut changes: Vec<Change> = face.sides().into_iter().filter_map(|side| edge.behind(side)).collect();
        changes.extend(edge.through(&face));
        changes.sort_by_key(|change| change.at);
        // The left side of the face is farther than the edge in the middle, and its right side nearer.
        assert_eq!(changes.iter().map(|change| change.by).collect::<Vec<_>>(), [1, -1]);
        // The plane has half of the greatest depth at a quarter of the width; the face ends at three quarters.
        let [enters, leaves] = [changes[0].at, changes[1].at].map(|at| f64::from(at) / f64::from(1 << PARAMETER_BITS));
        assert!(
            (leaves - 0.75).abs() < 1e-6 && (0.25..0.75).contains(&enters),
            "{enters} {leaves}"
        );
    }
}
