//! Directions between points, and their exact order around a point.
//!
//! Coordinates are below 2^21, so differences fit 23 bits with their sign, and products of two `i64` with room to spare.

use core::cmp::Ordering;

use crate::geometry::{SubPixel, SubPoint};

/// The vector from one point to another, in units. That of an edge is never (0, 0).
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct Direction {
    x: i32,
    y: i32,
}

impl Direction {
    /// The direction against the x axis.
    pub(crate) const LEFT: Self = Self { x: -1, y: 0 };

    pub(crate) fn between<S: SubPixel>(from: SubPoint<S>, to: SubPoint<S>) -> Self {
        Self {
            x: to.x_units() - from.x_units(),
            y: to.y_units() - from.y_units(),
        }
    }

    pub(crate) const fn reversed(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }

    /// The coordinates of two other directions, both on the axis on which this direction is longer.
    pub(crate) const fn longer_axis(self, one: Self, other: Self) -> (i32, i32) {
        if self.x.unsigned_abs() >= self.y.unsigned_abs() {
            (one.x, other.x)
        } else {
            (one.y, other.y)
        }
    }

    /// Above 0 where the other one points to the positive side: where a turn from the x axis to the y axis leads.
    pub(crate) const fn cross(self, other: Self) -> i64 {
        self.x as i64 * other.y as i64 - self.y as i64 * other.x as i64
    }

    pub(crate) const fn is_along(self, other: Self) -> bool {
        self.cross(other) == 0 && self.x as i64 * other.x as i64 + self.y as i64 * other.y as i64 > 0
    }

    /// Which of two directions a positive turn from this one meets first: `Less` for `one`. This direction itself is met last.
    pub(crate) fn order(self, one: Self, other: Self) -> Ordering {
        self.half_turns(one)
            .cmp(&self.half_turns(other))
            .then_with(|| other.cross(one).cmp(&0))
    }

    /// Whether a positive turn from this one to `last` passes the other one in between.
    pub(crate) fn passes(self, other: Self, last: Self) -> bool {
        !self.is_along(other) && self.order(other, last) == Ordering::Less
    }

    /// The size of the positive turn from this direction to another one, as a number to compare by: 0 for less than half a turn,
    /// 1 for half a turn, 2 for more, 3 for a whole turn (the same direction).
    const fn half_turns(self, other: Self) -> u8 {
        match self.cross(other) {
            1.. => 0,
            0 if self.is_along(other) => 3,
            0 => 1,
            _ => 2,
        }
    }

    /// How often the shorter turn from this direction to another passes the x axis, positive turns counted up.
    ///
    /// Over a closed contour that does not meet itself this adds up to one or minus one (Hopf's Umlaufsatz, 1935).
    pub(crate) const fn turns_to(self, other: Self) -> i32 {
        match (self.is_in_first_half(), other.is_in_first_half()) {
            (false, true) if self.cross(other) > 0 => 1,
            (true, false) if self.cross(other) < 0 => -1,
            _ => 0,
        }
    }

    /// Whether the direction is that of the x axis, or less than half a positive turn from it.
    const fn is_in_first_half(self) -> bool {
        self.y > 0 || self.y == 0 && self.x > 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AROUND: [Direction; 8] = [
        Direction { x: 3, y: 0 },
        Direction { x: 2, y: 1 },
        Direction { x: 0, y: 4 },
        Direction { x: -1, y: 1 },
        Direction { x: -7, y: 0 },
        Direction { x: -1, y: -5 },
        Direction { x: 0, y: -1 },
        Direction { x: 9, y: -2 },
    ];

    #[test]
    fn a_turn_meets_the_directions_in_their_order_and_its_own_last() {
        for (start, from) in AROUND.iter().enumerate() {
            let index = |index: usize| (index + AROUND.len() - start - 1) % AROUND.len();
            for (first, one) in AROUND.iter().enumerate() {
                for (last, other) in AROUND.iter().enumerate() {
                    assert_eq!(from.order(*one, *other), index(first).cmp(&index(last)));
                }
            }
        }
    }

    #[test]
    fn a_whole_turn_passes_the_x_axis_once() {
        for step in 1..4 {
            let turn = |from: usize| AROUND[from % 8].turns_to(AROUND[(from + step) % 8]);
            let back = |from: usize| AROUND[(from + step) % 8].turns_to(AROUND[from % 8]);
            assert_eq!((0..8).map(turn).sum::<i32>(), step as i32);
            assert_eq!((0..8).map(back).sum::<i32>(), -(step as i32));
        }
    }
}
