//! The units around an exact point on a side of a convex window, and which of them stands for it.
//!
//! Promises: the nearest one that lies inside the window; of equally near ones that furthest from the side, so that nothing
//! prefers a direction; where that does not decide, as on upright sides, the one with the larger x, then y. On a side alone
//! there is always one inside, as the side passes between them. Where another side keeps all of them out, it is the nearest
//! one.

use core::cmp::Reverse;

use crate::geometry::{ConvexWindow, Side, SubPixel, SubPoint};

/// An exact point: so many units, and in each coordinate a part of `whole` more, which is less than all of it.
pub(super) struct UnitCell<S: SubPixel> {
    pub(super) top_left: SubPoint<S>,
    pub(super) parts: (u64, u64),
    pub(super) whole: u64,
}

/// From the top left corner of a cell, larger coordinates first.
const CORNERS: [(i32, i32); 4] = [(1, 1), (1, 0), (0, 1), (0, 0)];

impl<S: SubPixel> UnitCell<S> {
    /// What stands for the point, which lies on that side of the window.
    ///
    /// Cost: two products a side of the window.
    pub(super) fn corner_inside(&self, window: &ConvexWindow<'_, S>, crossed: Side) -> Option<SubPoint<S>> {
        let are_outside = self.corners_outside(window);
        let ranks = CORNERS
            .iter()
            .zip(are_outside)
            .filter_map(|(&(right, down), is_outside)| {
                let distance = self.distance(right, down)?;
                Some((
                    (is_outside, distance, Reverse(crossed.change(right, down))),
                    (right, down),
                ))
            });
        let (_, (right, down)) = ranks.min_by_key(|&(rank, _)| rank)?;
        // One more at most than what is in the domain.
        let (x, y) = (self.top_left.x_units(), self.top_left.y_units());
        SubPoint::from_units(x.wrapping_add(right), y.wrapping_add(down)).ok()
    }

    /// What grows with the distance to a corner; `None` where the point has one coordinate exactly, and the corner the next.
    ///
    /// The square of the distance is that to the top left corner and `1 - 2 part` for each step, in parts of the whole. All
    /// below 2^57.
    fn distance(&self, right: i32, down: i32) -> Option<i64> {
        let step = |units, part: u64| match (units, part) {
            (0, _) => Some(0),
            (_, 0) => None,
            _ => Some(self.whole.wrapping_sub(part.wrapping_mul(2)) as i64),
        };
        Some(step(right, self.parts.0)?.wrapping_add(step(down, self.parts.1)?))
    }

    /// For each corner, whether it is outside.
    fn corners_outside(&self, window: &ConvexWindow<'_, S>) -> [bool; 4] {
        let mut are_outside = [false; 4];
        for side in window.sides() {
            let distance = side.distance(self.top_left);
            for (is_outside, (right, down)) in are_outside.iter_mut().zip(CORNERS) {
                *is_outside |= distance.wrapping_add(side.change(right, down)) < 0;
            }
        }
        are_outside
    }
}
