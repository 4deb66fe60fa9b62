//! Whether a contour that goes to the right once and back once, as that of a chart does, crosses or touches itself.
//!
//! Its two runs from the leftmost to the rightmost corner are functions of x. They are walked along side by side, and at the
//! corners of either one is seen which of them lies above the other: that must be the same one everywhere.
//!
//! ```text
//!        .--'\      .       one run, forwards
//!     .-'     '--.-' '.
//!    |                |     upright edges at both ends alone
//!     '--._     _.--._|
//!          '---'            the other run, backwards
//! ```
//!
//! Guarantees: exact. Cost: as many steps as there are corners, with two products of 64 bits each, and for each y-monotone
//! chain a look at those before.
//!
//! Source: monotone polygons (Preparata and Supowit 1981).

use core::cmp::Ordering;

use crate::draw::outline::stored::{Chain, Corner, StoredOutline};

/// Whether a contour has no point twice but the ends that neighbouring edges share; `None` where it goes to the right more
/// than once, or has an upright edge between its ends. It must not turn back upon itself at a corner.
#[inline(never)]
pub(super) fn is_simple(stored: StoredOutline<'_>) -> Option<bool> {
    let start = leftmost(stored)?;
    let mut runs = [Run::new(stored, start, true), Run::new(stored, start, false)];
    runs.iter_mut().for_each(Run::pass_upright_edges);
    let [mut run, mut other] = runs;
    let mut side = run.at[1].cmp(&other.at[1]);
    let (mut end, mut other_end) = (run.next()?, other.next()?);
    loop {
        let order = end.corner[0].cmp(&other_end.corner[0]);
        let here = match order {
            Ordering::Less => side_of(end.corner, [other.at, other_end.corner]),
            Ordering::Greater => side_of(other_end.corner, [run.at, end.corner]).reverse(),
            Ordering::Equal => end.corner[1].cmp(&other_end.corner[1]),
        };
        if side.then(here) != here.then(side) {
            return Some(false);
        }
        side = side.then(here);
        let nexts = (run.past(end, order.is_le()), other.past(other_end, order.is_ge()));
        match nexts {
            (Some(_), Some(_)) if here == Ordering::Equal => return Some(false),
            (Some(next), Some(other_next)) => (end, other_end) = (next, other_next),
            (None, None) if run.reaches(&other) => return (side != Ordering::Equal).then_some(true),
            _ => return None,
        }
    }
}

/// On which side of a line to the right a corner lies: [`Ordering::Greater`] below it.
fn side_of([x, y]: Corner, [[from_x, from_y], [to_x, to_y]]: [Corner; 2]) -> Ordering {
    let product = |one: i32, other: i32| i64::from(one) * i64::from(other);
    product(y - from_y, to_x - from_x).cmp(&product(to_y - from_y, x - from_x))
}

/// A corner of a stored contour: its chain, and its index along that.
#[derive(Copy, Clone)]
struct Position {
    chain: Chain,
    index: u16,
}

/// One of the leftmost corners; `None` where all corners have the same x.
fn leftmost(stored: StoredOutline<'_>) -> Option<Position> {
    let (mut found, mut left, mut right) = (None, i32::MAX, i32::MIN);
    for chain in stored.chains_along() {
        let first = stored.first_corner(chain);
        for index in 0..chain.corners() {
            let [x, _] = stored.corner(first.wrapping_add(index));
            if x < left {
                (found, left) = (Some(Position { chain, index }), x);
            }
            right = right.max(x);
        }
    }
    found.filter(|_| left < right)
}

/// A corner to which a run may go on.
#[derive(Copy, Clone)]
struct Step {
    position: Position,
    corner: Corner,
}

/// One of the two runs of a contour from its leftmost corner to the right, and how far it was walked along.
struct Run<'w> {
    stored: StoredOutline<'w>,
    /// The last corner that was reached, by its chain and by its coordinates.
    position: Position,
    at: Corner,
    /// Whether the run follows the order in which the corners are stored.
    is_forward: bool,
}

impl<'w> Run<'w> {
    fn new(stored: StoredOutline<'w>, position: Position, is_forward: bool) -> Self {
        let mut run = Self {
            stored,
            position,
            at: [0; 2],
            is_forward,
        };
        run.at = run.corner(position);
        run
    }

    fn corner(&self, Position { chain, index }: Position) -> Corner {
        self.stored.corner(self.stored.first_corner(chain).wrapping_add(index))
    }

    /// The next stored corner, which may lie where this one does: a chain begins where the one before it ended.
    fn neighbour(&self, Position { chain, index }: Position) -> Option<Position> {
        let stored = self.stored;
        if self.is_forward {
            if index < chain.corners() - 1 {
                return Some(Position {
                    chain,
                    index: index + 1,
                });
            }
            let chain = stored.chain_behind(chain).or(stored.chains_along().next())?;
            return Some(Position { chain, index: 0 });
        }
        if index > 0 {
            return Some(Position {
                chain,
                index: index - 1,
            });
        }
        let first = stored.first_corner(chain);
        let before = stored
            .chains_along()
            .take_while(|chain| stored.first_corner(*chain) != first);
        let chain = before.last().or_else(|| stored.chains_along().last())?;
        Some(Position {
            chain,
            index: chain.corners() - 1,
        })
    }

    /// The next corner that lies elsewhere, if it lies further to the right.
    fn next(&self) -> Option<Step> {
        let mut position = self.position;
        loop {
            position = self.neighbour(position)?;
            let corner = self.corner(position);
            if corner != self.at {
                return (corner[0] > self.at[0]).then_some(Step { position, corner });
            }
        }
    }

    /// Goes to a step's corner if that `is_passed`, and returns the next step then, or else the same.
    fn past(&mut self, step: Step, is_passed: bool) -> Option<Step> {
        if !is_passed {
            return Some(step);
        }
        (self.position, self.at) = (step.position, step.corner);
        self.next()
    }

    /// Goes on as long as the next corner has the same x.
    fn pass_upright_edges(&mut self) {
        while let Some(position) = self.neighbour(self.position) {
            let corner = self.corner(position);
            if corner[0] != self.at[0] {
                break;
            }
            (self.position, self.at) = (position, corner);
        }
    }

    fn is_at(&self, Position { chain, index }: Position) -> bool {
        let own = self.stored.first_corner(self.position.chain);
        own == self.stored.first_corner(chain) && self.position.index == index
    }

    /// Whether the contour goes on to where another run is without a step to the left or right.
    fn reaches(&self, other: &Self) -> bool {
        let mut position = self.position;
        while !other.is_at(position) {
            match self.neighbour(position) {
                Some(next) if self.corner(next)[0] == self.at[0] => position = next,
                _ => return false,
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;
    use crate::{
        draw::{
            FillRule,
            outline::{convex::Turns, store::store},
            payload::Payload,
        },
        geometry::{Sub8, SubPoint},
    };

    /// Whether no two edges have a point in common but neighbours their corner, by a comparison of all pairs. The contour has
    /// no corner twice in succession, and does not turn back upon itself.
    fn is_simple_by_pairs(corners: &[Corner]) -> bool {
        let count = corners.len();
        let edge = |index: usize| [corners[index], corners[(index + 1) % count]];
        let turn = |[a, b]: [Corner; 2], c: Corner| {
            let [ux, uy, vx, vy] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]].map(i64::from);
            (ux * vy - uy * vx).signum()
        };
        let overlap = |axis: usize, [a, b]: [Corner; 2], [c, d]: [Corner; 2]| {
            a[axis].min(b[axis]) <= c[axis].max(d[axis]) && c[axis].min(d[axis]) <= a[axis].max(b[axis])
        };
        let meet = |one: [Corner; 2], other: [Corner; 2]| {
            overlap(0, one, other)
                && overlap(1, one, other)
                && turn(one, other[0]) * turn(one, other[1]) <= 0
                && turn(other, one[0]) * turn(other, one[1]) <= 0
        };
        (0..count)
            .all(|one| (one + 2..count).all(|other| (one == 0 && other == count - 1) || !meet(edge(one), edge(other))))
    }

    /// Whether a contour crosses or touches itself nowhere, by a walk along its two runs, and by comparing all pairs of edges;
    /// `None` for a contour that turns back upon itself at a corner, which the walk is not asked about.
    fn both(corners: &[Corner]) -> Option<(Option<bool>, bool)> {
        let mut turns = Turns::default();
        for (index, corner) in corners.iter().enumerate() {
            turns.add(*corner, corners[(index + 1) % corners.len()]);
        }
        turns.close();
        let points: Vec<_> = corners
            .iter()
            .map(|[x, y]| SubPoint::<Sub8>::from_units(*x, *y).unwrap())
            .collect();
        let outline = [points.as_slice()];
        let mut words = [0; 256];
        let mut payload = Payload::new(&mut words, 99);
        store(&outline, FillRule::NonZero, &mut payload).unwrap();
        let stored = StoredOutline::new(payload.written_from(0));
        let is_known = turns.are_one_contour() && stored.chains_along().next().is_some();
        is_known.then(|| (is_simple(stored), is_simple_by_pairs(corners)))
    }

    /// Contours along two runs of random heights, which often meet, begun at any corner, in either direction, near or far
    /// apart.
    #[test]
    fn the_answer_is_that_of_comparing_all_pairs_of_edges() {
        let mut state = 0x2468_ace1u32;
        let mut random = |below: i32| {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            (state % below as u32) as i32
        };
        let mut counts = [0; 3];
        for _ in 0..40_000 {
            let (columns, heights, scale) = (2 + random(7), 2 + random(9), [1, 64, 9_000][random(3) as usize]);
            let mut corners = Vec::new();
            let shift = random(heights);
            for x in 0..columns {
                if x == 0 || x == columns - 1 || random(3) > 0 {
                    corners.push([x, random(heights) + shift]);
                }
            }
            for x in (0..columns).rev() {
                if x == 0 || x == columns - 1 || random(3) > 0 {
                    corners.push([x, random(heights)]);
                }
            }
            // A corner anywhere makes most contours go back and forth.
            if random(4) == 0 {
                let index = random(corners.len() as i32) as usize;
                corners.insert(index, [random(columns), random(heights)]);
            }
            if random(2) == 0 {
                corners.reverse();
            }
            let first = random(corners.len() as i32) as usize;
            corners.rotate_left(first);
            let mut corners: Vec<Corner> = corners.iter().map(|corner| corner.map(|units| units * scale)).collect();
            corners.dedup();
            if corners.first() == corners.last() {
                corners.pop();
            }
            if let Some((fast, slow)) = both(&corners) {
                assert!(fast.is_none_or(|fast| fast == slow), "{corners:?}: {fast:?}, {slow}");
                counts[fast.map_or(2, usize::from)] += 1;
            }
        }
        assert!(counts.iter().all(|count| *count > 2_000), "{counts:?}");
    }
}
