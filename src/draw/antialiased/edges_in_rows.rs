//! The edges of a round outline in some rows, without computing the corners of the others.
//!
//! ```text
//!        .-''-.        Between two turns the corners of an arc run down, or up: in each such part a binary search finds the
//!      /        \      first edge in the rows, and the walk ends at the first corner beyond them.
//!  ---a----------d---
//!  ---b----------c---  rows: edges a-b and c-d of a circle with 128 corners
//!      \        /
//!        '-..-'
//! ```
//!
//! Guarantees: every edge that has a part in the rows, in the order of the outline. Cost: two corners and a logarithmic number
//! of sines for each part that the rows meet, beside the corners in them.

use core::ops::Range;

use crate::{
    coverage::edges::{Y_BITS, Y_ONE},
    draw::antialiased::{
        arc_turns::Axis,
        outline_arc::{Corner, OutlineArc},
        round_outline::{RoundContour, RoundOutline},
    },
    geometry::{Sub8, SubPixel},
};

/// A function that takes the ends of an edge.
type EdgeSink<'s> = dyn FnMut(Corner, Corner) + 's;

/// Rows of pixels by their upper and lower side, in 1/256 pixel from the centre of pixel (0, 0).
#[derive(Debug, Copy, Clone)]
pub(super) struct RowSides {
    top: i32,
    bottom: i32,
}

impl RowSides {
    /// The sides of some rows of pixels, of which those outside the domain of [`Sub8`] do not count.
    pub(super) fn of(rows: &Range<i32>) -> Self {
        const FIRST: i32 = Sub8::MIN_UNITS >> Y_BITS;
        const END: i32 = (Sub8::MAX_UNITS >> Y_BITS) + 1;
        let side = |row: i32| (row.clamp(FIRST, END) << Y_BITS) - Y_ONE / 2;
        Self {
            top: side(rows.start),
            bottom: side(rows.end),
        }
    }

    /// Whether an edge that is not level has a part in the rows, by the y of its ends.
    #[inline]
    pub(super) fn meet(self, one: i32, other: i32) -> bool {
        one.min(other) < self.bottom && self.top < one.max(other)
    }

    /// Whether all that lies between two y is in the rows.
    fn contain(self, [first, last]: [i32; 2]) -> bool {
        self.top <= first && last <= self.bottom
    }
}

impl RoundOutline {
    /// Calls `edge` with the edges that have a part in some rows, and perhaps with others, in the order of the outline. With
    /// `only_up` only with those along which the outline runs up: the left half of an ellipse.
    pub(super) fn edges_between(&self, rows: RowSides, only_up: bool, edge: &mut EdgeSink<'_>) {
        for contour in (0..self.contours()).filter_map(|number| self.contour(number)) {
            contour.edges_between(rows, only_up, edge);
        }
    }

    /// Whether all edges lie in some rows.
    pub(super) fn lies_in(&self, rows: RowSides) -> bool {
        let mut contours = (0..self.contours()).filter_map(|number| self.contour(number));
        contours.all(|contour| contour.arcs().iter().all(|arc| rows.contain(arc.ends_in_y())))
    }
}

impl RoundContour {
    fn edges_between(&self, rows: RowSides, only_up: bool, edge: &mut EdgeSink<'_>) {
        let arcs = self.arcs();
        let followers = arcs.iter().skip(1).chain(arcs.first());
        for (arc, next) in arcs.iter().zip(followers) {
            arc.edges_between(rows, only_up, edge);
            let last = arc.corners() - 1;
            let ends = [arc.y_of(last), next.y_of(0)];
            if rows.meet(ends[0], ends[1]) && !(only_up && ends[0] < ends[1]) {
                edge(arc.corner(last), next.corner(0));
            }
        }
    }
}

impl OutlineArc {
    fn edges_between(&self, rows: RowSides, only_up: bool, edge: &mut EdgeSink<'_>) {
        let mut before: Option<(u16, i32)> = None;
        self.turns(Axis::Y, &mut |index| {
            let y = self.y_of(index);
            if let Some((start, start_y)) = before {
                if rows.meet(start_y, y) && !(only_up && start_y < y) {
                    self.walk(start..index, start_y < y, rows, edge);
                }
            }
            before = Some((index, y));
        });
    }

    /// Calls with the edges in some rows of a part of the arc that is monotone in y, from a corner to another one.
    fn walk(
        &self,
        Range { mut start, end: last }: Range<u16>,
        runs_down: bool,
        rows: RowSides,
        edge: &mut EdgeSink<'_>,
    ) {
        let (is_above, is_below) = (|y: i32| y <= rows.top, |y: i32| y >= rows.bottom);
        let is_before = |y: i32| if runs_down { is_above(y) } else { is_below(y) };
        let is_behind = |y: i32| if runs_down { is_below(y) } else { is_above(y) };
        // All edges before `start` end before the rows; the one that ends at `end` does not.
        let mut end = last - 1;
        while start < end {
            let middle = start + (end - start) / 2;
            if is_before(self.y_of(middle + 1)) {
                start = middle + 1;
            } else {
                end = middle;
            }
        }
        let mut from = self.corner(start);
        for index in start + 1..=last {
            let to = self.corner(index);
            edge(from, to);
            if is_behind(to[1]) {
                break;
            }
            from = to;
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;
    use crate::draw::{
        SubOutline,
        antialiased::{outline_arc::WidePosition, turn::TURN},
    };

    fn arc(center: WidePosition, radii: [i64; 2], start: i32, sweep: i32) -> OutlineArc {
        OutlineArc::new(center, radii, (start, sweep)).unwrap()
    }

    /// Whole ellipses, rings, sectors with their tip, and contours of more than one arc.
    fn outlines() -> impl Iterator<Item = RoundOutline> {
        let contour = |radius: i64| RoundContour::ellipse([400, -300], [radius, radius / 2 + 9]).unwrap();
        let sector = |start: i32, sweep: i32| {
            let tip = OutlineArc::point([77, 5]).unwrap();
            RoundOutline::new(RoundContour::new(&[arc([77, 5], [5_000, 9_000], start, sweep), tip]))
        };
        let band = |start: i32, sweep: i32| {
            let inner = arc([0, 0], [6_000; 2], start + sweep, -sweep);
            RoundOutline::new(RoundContour::new(&[arc([0, 0], [7_000; 2], start, sweep), inner]))
        };
        let wholes = [1, 40, 700, 9_000, 90_000].map(|radius| RoundOutline::new(contour(radius)));
        let rings = [900, 9_000].map(|radius| RoundOutline::ring(contour(radius), Some(contour(radius - 300))));
        let sweeps = [77, TURN / 5, TURN / 2, 9 * (TURN / 10)];
        let starts = [0, 5, TURN / 4, 9_999_999];
        let cut = starts.into_iter().flat_map(move |start| {
            sweeps
                .into_iter()
                .flat_map(move |sweep| [sector(start, sweep), band(start, sweep)])
        });
        wholes.into_iter().chain(rings).chain(cut)
    }

    /// All edges in the rows come, in the order of the outline, and few others.
    #[test]
    fn the_edges_between_two_rows_are_those_of_the_outline() {
        for outline in outlines() {
            let mut all = Vec::new();
            outline.edges(&mut |from, to| all.push((from, to)));
            for start in (-400..400).step_by(7) {
                for rows in [
                    start..start + 1,
                    start..start + 9,
                    start..start,
                    0..i32::MAX,
                    i32::MIN..start,
                ] {
                    let sides = RowSides::of(&rows);
                    let mut found = Vec::new();
                    outline.edges_between(sides, false, &mut |from, to| found.push((from, to)));
                    let mut rest = all.iter();
                    assert!(
                        found.iter().all(|edge| rest.any(|other| other == edge)),
                        "{outline:?}, {rows:?}"
                    );
                    let in_rows = |&&(from, to): &&(Corner, Corner)| sides.meet(from[1], to[1]) && from[1] != to[1];
                    let (needed, expected) = (found.iter().filter(in_rows).count(), all.iter().filter(in_rows).count());
                    assert_eq!(needed, expected, "{outline:?}, {rows:?}");
                    // Level edges and those that only touch the rows.
                    assert!(
                        found.len() <= expected + 12,
                        "{outline:?}, {rows:?}: {} of {expected}",
                        found.len()
                    );
                }
            }
        }
    }
}
