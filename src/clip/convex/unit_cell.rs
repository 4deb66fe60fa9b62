//! The units around an exact point on a side of a convex window, and which of them stands for it.
//!
//! Guarantees: the nearest one that lies inside the window; of equally near ones that furthest from the side, so that
//! nothing prefers a direction; where that does not decide, as on upright sides, the one with the larger x, then y. On a
//! side alone there is always one inside, as the side passes between them. Where another side keeps all of them out, it is
//! the nearest one beyond the side, where the segment came from, so that the ends of what crosses a sliver stay on both
//! sides of it.

use crate::geometry::{ConvexWindow, SideLine, SubPixel, SubPoint};

/// An exact point: `top_left` in units, and `parts / whole` of a unit more along x and y, both less than 1.
pub(crate) struct UnitCell<S: SubPixel> {
    pub(crate) top_left: SubPoint<S>,
    pub(crate) parts: (u64, u64),
    pub(crate) whole: u64,
}

impl<S: SubPixel> UnitCell<S> {
    /// The unit that stands for the exact point, which lies on a side of the window: of the four around it the nearest one inside.
    ///
    /// Cost: two products a side of the window for each of up to four units; fewer for those outside.
    pub(crate) fn corner_inside(&self, window: &ConvexWindow<'_, S>, crossed: SideLine) -> Option<SubPoint<S>> {
        let mut nearest = None;
        // Larger x first, then y.
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

    /// A number that grows with the distance from the exact point to a corner of the cell; `None` for a corner that the point does
    /// not lie between, because one of its coordinates is a whole unit.
    ///
    /// The square of the distance is that to the top left corner and `1 - 2 part` for each step, in parts of the whole. All
    /// below 2^57.
    fn distance(&self, right: i32, down: i32) -> Option<i64> {
        let step = |units, part: u64| match (units, part) {
            (0, _) => Some(0),
            (_, 0) => None,
            _ => Some(self.whole.wrapping_sub(part * 2) as i64),
        };
        Some(step(right, self.parts.0)? + step(down, self.parts.1)?)
    }
}
