//! Which part of an edge a face hides: exactly the part where the edge lies within the projected triangle and behind its plane.
//!
//! ```text
//!              b                      Along an edge, on which side of a line through two corners it is changes
//!             / \                     linearly, and so does how far it lies behind the plane of the face. So each of
//!     P -----+===+----- Q             these four leaves one interval of the edge, and the part that is hidden is what
//!           /     \                   all of them have in common.
//!          a-------c
//! ```
//!
//! Stored depths are rounded to a unit, and positions to that of the precision, so that what lies in the plane of a face in
//! space may lie somewhat behind it here. A face hides only what is behind it by more than a tolerance: 2 units of depth (8 of
//! depths with 24 bits), and what the face's depth changes over one unit of x and one of y. Where a corner of the face is an
//! end of the edge, both to the unit, the edge begins in the plane: it is hidden there from this end on if it is behind by more
//! than the tolerance where it leaves the triangle. A face that has both ends hides nothing of the edge.

use core::num::NonZeroU32;

use crate::{
    geometry::quotient_down,
    view::DepthWidth,
    visible::hidden_lines::{
        line_table::LinePoint,
        parts::{END, PARAMETER_BITS},
    },
};

/// How many units of depth an edge has to be behind a face to be hidden, besides what the depth of the face changes over one
/// unit of x and one of y. Depths of an edge and of a face are each rounded by less than a unit; those of 24 bits have more
/// digits than coordinates in eye space have, which are rounded to 1/4096.
pub(super) const fn tolerance<D: DepthWidth>() -> i64 {
    if D::FRACTION_BITS == 16 { 2 } else { 8 }
}

/// A face that may hide something: its corners clockwise on the screen, and twice its area in units of the precision.
#[derive(Debug, Copy, Clone)]
pub(super) struct HidingFace {
    corners: [LinePoint; 3],
    area: i64,
}

impl HidingFace {
    /// A face with these corners; `None` where it is seen on edge, so that it hides nothing.
    pub(super) fn new([a, b, c]: [LinePoint; 3]) -> Option<Self> {
        let area = side([a, b], c);
        match area.signum() {
            1 => Some(Self {
                corners: [a, b, c],
                area,
            }),
            -1 => Some(Self {
                corners: [a, c, b],
                area: -area,
            }),
            _ => None,
        }
    }

    /// The part of a segment that the face hides, as parameters from 0 at its first to [`END`] at its second end; `None` where
    /// it hides nothing. Faces that share a side have the same parameter there.
    pub(super) fn hidden<D: DepthWidth>(&self, ends: [LinePoint; 2]) -> Option<[u32; 2]> {
        let touches = ends.map(|end| self.corners.contains(&end));
        if let [true, true] = touches {
            return None;
        }
        let within = self.within(ends)?;
        let [first, second] = ends.map(|end| self.behind(end));
        let tolerance = self.tolerance::<D>();
        let hidden = match touches {
            [true, _] => self.wedge(second, within[1], tolerance).then_some(within),
            [_, true] => self.wedge(first, END - within[0], tolerance).then_some(within),
            // Behind by more: by one at least.
            _ => cut(within, narrowed([first - tolerance - 1, second - tolerance - 1])),
        };
        hidden.filter(|[start, end]| start < end)
    }

    /// Whether an edge that begins in the plane of the face, and lies so far behind it at its other end, is behind by more than
    /// the tolerance at a way along it.
    fn wedge(&self, at_other_end: i128, way: u32, tolerance: i128) -> bool {
        // Below 2^72, and 30 bits.
        at_other_end * i128::from(way) > tolerance << PARAMETER_BITS
    }

    /// The part of a segment within the triangle, its border included.
    fn within(&self, ends: [LinePoint; 2]) -> Option<[u32; 2]> {
        let [a, b, c] = self.corners;
        let mut within = [0, END];
        for line in [[a, b], [b, c], [c, a]] {
            within = cut(within, ends.map(|end| side(line, end)))?;
        }
        Some(within)
    }

    /// How far a point is behind the plane of the face, in units of depth times [`area`](Self::area); below 0 in front of it.
    pub(super) fn behind(&self, point: LinePoint) -> i128 {
        let [a, b, c] = self.corners;
        // Sides are below 2^45, depths below 2^24.
        let part =
            |line: [LinePoint; 2], opposite: LinePoint| i128::from(side(line, point)) * i128::from(opposite.depth);
        part([b, c], a) + part([c, a], b) + part([a, b], c) - i128::from(self.area) * i128::from(point.depth)
    }

    /// The tolerance of the face, in units of depth times [`area`](Self::area).
    pub(super) fn tolerance<D: DepthWidth>(&self) -> i128 {
        let [a, b, c] = self.corners;
        // How the plane changes with x and y: below 2^48.
        let sum = |of: fn(LinePoint) -> i32| {
            let part = |from: LinePoint, to: LinePoint, opposite: LinePoint| {
                i64::from(of(to) - of(from)) * i64::from(opposite.depth)
            };
            (part(b, c, a) + part(c, a, b) + part(a, b, c)).abs()
        };
        i128::from(tolerance::<D>() * self.area + sum(|point| point.x) + sum(|point| point.y))
    }

    /// Whether a point lies in the face, or not farther beside it than a unit of x and one of y.
    pub(super) fn is_beside(&self, point: LinePoint) -> bool {
        let [a, b, c] = self.corners;
        [[a, b], [b, c], [c, a]].into_iter().all(|[from, to]| {
            let of_unit = i64::from((to.x - from.x).abs()) + i64::from((to.y - from.y).abs());
            side([from, to], point) >= -of_unit
        })
    }

    /// How far a point whose column and row lie in the face is behind the plane of the face, in units of stored depth, rounded
    /// up; 0 for a point in front of it.
    pub(super) fn units_behind(&self, point: LinePoint) -> i32 {
        let whole = self.behind(point).checked_div(i128::from(self.area));
        // Depths have 24 bits.
        whole.unwrap_or_default().clamp(-1, 1 << 24) as i32 + 1
    }
}

/// On which side of a line a point is: twice the area of the triangle, above 0 where the line passes it clockwise.
pub(super) fn side([from, to]: [LinePoint; 2], point: LinePoint) -> i64 {
    // Differences below 2^22.
    let (width, height) = (i64::from(to.x - from.x), i64::from(to.y - from.y));
    width * i64::from(point.y - from.y) - height * i64::from(point.x - from.x)
}

/// What is left of an interval where a function is not below 0 that changes linearly, given its values at 0 and at [`END`], each
/// below 2^62.
pub(super) fn cut([start, end]: [u32; 2], values: [i64; 2]) -> Option<[u32; 2]> {
    let [first, second] = values;
    let (start, end) = match (first < 0, second < 0) {
        (true, true) => return None,
        (false, false) => (start, end),
        (true, false) => (start.max(zero_between(values)), end),
        (false, true) => (start, end.min(zero_between(values))),
    };
    (start <= end).then_some([start, end])
}

/// Two values with so many of their low bits left out that both are below 2^62; their signs stay.
pub(super) fn narrowed(values: [i128; 2]) -> [i64; 2] {
    let [first, second] = values.map(i128::unsigned_abs);
    let bits = u128::BITS - (first | second).leading_zeros();
    values.map(|value| (value >> bits.saturating_sub(62)) as i64)
}

/// The parameter where a linear function is 0 of which one of the values at 0 and at [`END`] is below 0 and the other one is
/// not. Off by less than 2 of 2^30.
pub(super) fn zero_between([first, second]: [i64; 2]) -> u32 {
    let (way, whole) = (first.unsigned_abs(), first.abs_diff(second));
    // 32 bits of the whole way are enough.
    let shift = (u64::BITS - whole.leading_zeros()).saturating_sub(u32::BITS);
    match NonZeroU32::new((whole >> shift) as u32) {
        Some(whole) => quotient_down((way >> shift) << PARAMETER_BITS, whole).min(END),
        None => 0,
    }
}
