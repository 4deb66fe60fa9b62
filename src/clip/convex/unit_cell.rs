//! Rounds the exact point in which a segment crosses a side of a convex window to one of the up to four points with whole
//! units around it.
//!
//! Guarantees: the result is the nearest of these points inside the window. Of equally near ones it is the one furthest from
//! the side, so that mirrored windows have mirrored results; where that does not decide, as on upright sides, the one with
//! the larger x, then the larger y. Near a single side, one of the points is always inside, because the side passes between
//! them. Where another side leaves all of them outside, as in a sliver thinner than a unit, the result is the nearest one
//! beyond the crossed side, so that both ends of a segment across the sliver stay on their own sides of it.

use crate::geometry::{ConvexWindow, SideLine, SubPixel, SubPoint};

/// An exact point: `top_left` in units, and `parts / whole` of a unit more along x and y, both less than 1.
pub(crate) struct UnitCell<S: SubPixel> {
    pub(crate) top_left: SubPoint<S>,
    pub(crate) parts: (u64, u64),
    pub(crate) whole: u64,
}

impl<S: SubPixel> UnitCell<S> {
    /// Rounds the exact point, which lies on the side `crossed` of the window, to the nearest corner of the cell inside the window:
    /// of equally near ones to that furthest from the side, then to that with the larger x, then y. Where all are outside, to the
    /// nearest one beyond the crossed side; `None` where no corner is in the domain.
    ///
    /// Cost: two products a side of the window for each of up to four corners; fewer for those outside.
    pub(crate) fn corner_inside(&self, window: &ConvexWindow<'_, S>, crossed: SideLine) -> Option<SubPoint<S>> {
        let mut nearest = None;
        // Corners with a larger x first, then those with a larger y: of equal ranks the first one is kept.
        for corner in (0..4).rev() {
            let (right, down) = (corner >> 1, corner & 1);
            let Some(distance) = self.distance(right, down) else {
                continue;
            };
            // No overflow: at most one unit beyond a coordinate in the domain.
            let (x, y) = (self.top_left.x_units(), self.top_left.y_units());
            let Ok(unit) = SubPoint::from_units(x + right, y + down) else {
                continue;
            };
            let depth = crossed.distance(unit);
            let is_outside = !window.contains(unit);
            let rank = (is_outside, is_outside && depth >= 0, distance, -depth);
            if nearest.is_none_or(|(least, _)| rank < least) {
                nearest = Some((rank, unit));
            }
        }
        nearest.map(|(_, unit)| unit)
    }

    /// A number that grows with the distance from the exact point to the corner of the cell that is `right` and `down` units from
    /// the top left one; `None` for a corner further away than need be, because the point's x or y is a whole unit.
    ///
    /// With a and b as the point's fractions of a unit, the squared distance to the top left corner is a^2 + b^2; one unit to
    /// the right adds 1 - 2a, one unit down 1 - 2b. These additions, times `whole`, are the number; it is below 2^57.
    fn distance(&self, right: i32, down: i32) -> Option<i64> {
        let step = |units, part: u64| match (units, part) {
            (0, _) => Some(0),
            (_, 0) => None,
            _ => Some(self.whole as i64 - 2 * part as i64),
        };
        Some(step(right, self.parts.0)? + step(down, self.parts.1)?)
    }
}
