//! Whether an outline is one convex contour, found while its edges come one by one.
//!
//! A contour is convex where it turns the same way at all of its corners and all turns together are one: then it goes down
//! once and up once.
//!
//! Guarantees: exact. Cost: two products of 64 bits for each edge, four where it goes straight on.

use crate::draw::outline::stored::Corner;

/// Which way an outline turns at its corners. One contour that always turns the same way, and goes down and up only once,
/// is convex.
#[derive(Debug, Default)]
pub(super) struct Turns {
    /// The ends of the first edge that is longer than 0.
    first: Option<[Corner; 2]>,
    /// The ends of the last edge that is longer than 0.
    last: [Corner; 2],
    /// Whether the first and the last edge that is not level go down; `None` where all are level.
    goes_down: Option<[bool; 2]>,
    /// How often an edge goes the other way in y than the one before that was not level.
    reversals: u32,
    /// Whether the outline turns clockwise at some corner.
    clockwise: bool,
    /// Whether the outline turns counterclockwise at some corner.
    counterclockwise: bool,
    /// Whether an edge does not begin where the one before it ends, or goes back over that one.
    is_broken: bool,
}

impl Turns {
    /// Adds the next edge.
    pub(super) fn add(&mut self, from: Corner, to: Corner) {
        if from == to {
            return;
        }
        match self.first {
            Some(_) => self.turn([from, to]),
            None => self.first = Some([from, to]),
        }
        if to[1] != from[1] {
            let goes_down = to[1] > from[1];
            let [first, last] = self.goes_down.unwrap_or([goes_down; 2]);
            self.reversals += u32::from(goes_down != last);
            self.goes_down = Some([first, goes_down]);
        }
        self.last = [from, to];
    }

    /// Records the turn at the corner from the last edge to this one.
    fn turn(&mut self, [from, to]: [Corner; 2]) {
        let [before, joint] = self.last;
        self.is_broken |= joint != from;
        let along = |from: Corner, to: Corner| [i64::from(to[0] - from[0]), i64::from(to[1] - from[1])];
        let ([x, y], [next_x, next_y]) = (along(before, joint), along(from, to));
        // Corners in the domain differ by less than 2^22 units, so that products fit.
        let cross = x * next_y - y * next_x;
        self.clockwise |= cross > 0;
        self.counterclockwise |= cross < 0;
        self.is_broken |= cross == 0 && x * next_x + y * next_y < 0;
    }

    /// Records the turn from the last edge to the first one: to be called once, after the last edge.
    pub(super) fn close(&mut self) {
        if let Some(edge) = self.first {
            self.turn(edge);
        }
    }

    /// Whether the edges of a contour that was [closed](Self::close) are one contour that nowhere goes back over itself.
    pub(super) const fn are_one_contour(&self) -> bool {
        !self.is_broken
    }

    /// Whether the edges of a contour that was [closed](Self::close) are one convex contour.
    pub(super) fn are_convex(&self) -> bool {
        let Some([first, last]) = self.goes_down else {
            return false;
        };
        let reversals = self.reversals + u32::from(first != last);
        !self.is_broken && reversals == 2 && !(self.clockwise && self.counterclockwise)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    /// Whether contours, each begun at any of its corners, are convex.
    fn are_convex(contours: &[&[Corner]]) -> bool {
        let longest = contours.iter().map(|contour| contour.len()).max().unwrap_or(0);
        let found: Vec<bool> = (0..longest)
            .map(|first| {
                let mut turns = Turns::default();
                for contour in contours {
                    let corner = |index: usize| contour[(first + index) % contour.len()];
                    for index in 0..contour.len() {
                        turns.add(corner(index), corner(index + 1));
                    }
                }
                turns.close();
                turns.are_convex()
            })
            .collect();
        assert!(found.iter().all(|one| *one == found[0]), "{contours:?}: {found:?}");
        found[0]
    }

    const SQUARE: [Corner; 4] = [[0, 0], [9, 0], [9, 9], [0, 9]];

    #[test]
    fn squares_and_triangles_are_convex_from_any_corner_on() {
        let mut reversed = SQUARE;
        reversed.reverse();
        assert!(are_convex(&[&SQUARE]) && are_convex(&[&reversed]));
        assert!(are_convex(&[&[[0, 0], [9, 4], [2, 9]]]));
        // With a corner twice, and one in the middle of a side.
        assert!(are_convex(&[&[[0, 0], [4, 0], [9, 0], [9, 0], [9, 9], [0, 9]]]));
    }

    #[test]
    fn what_turns_twice_or_both_ways_is_not() {
        let pentagram = [[50, 0], [79, 90], [2, 35], [98, 35], [21, 90]];
        assert!(!are_convex(&[&pentagram]));
        assert!(!are_convex(&[&[[0, 0], [9, 4], [0, 9], [3, 4]]]));
        assert!(!are_convex(&[&[[0, 0], [9, 9], [9, 0], [0, 9]]]));
        // A spike, a line there and back, and two squares.
        assert!(!are_convex(&[&[[0, 0], [9, 0], [20, 0], [9, 0], [9, 9], [0, 9]]]));
        assert!(!are_convex(&[&[[0, 0], [9, 4]]]));
        assert!(!are_convex(&[&SQUARE, &SQUARE.map(|[x, y]| [x + 20, y])]));
    }
}
