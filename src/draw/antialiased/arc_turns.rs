//! Corners at which an arc turns back along the x or the y axis, and the most edges that lie between them in a row.

use crate::draw::antialiased::{
    outline_arc::OutlineArc,
    turn::{TURN_BITS, direction, scaled},
};

/// An axis of the picture.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) enum Axis {
    X = 0,
    Y = 1,
}

impl OutlineArc {
    /// Calls `call` with the indices of corners, in ascending order, between which all others lie in monotone order along an
    /// axis: the first one, the last one, and the outermost ones between them.
    pub(crate) fn turns(&self, axis: Axis, call: &mut dyn FnMut(u16)) {
        let last = self.corners() - 1;
        call(0);
        // The ellipse's ends along x are at even quarters of a turn, those along y at odd ones. A start is below a turn.
        for step in 0..4 {
            let step = if self.is_reversed { 3 - step } else { step };
            let number = self.outermost(2 * step + axis as i32, axis);
            let index = number.map(|number| self.number_of(number));
            if let Some(index) = index.filter(|&index| 0 < index && index < last) {
                call(index);
            }
        }
        if last > 0 {
            call(last);
        }
    }

    /// The number, counted clockwise, of the corner that is outermost around an angle in quarters of a turn; `None` where
    /// the arc does not pass it.
    fn outermost(&self, quarters: i32, axis: Axis) -> Option<u16> {
        let angle = quarters << (TURN_BITS - 2);
        if angle <= self.start || self.start + self.sweep <= angle {
            return None;
        }
        let part = u64::from((angle - self.start).unsigned_abs()) * u64::from(self.chords_of_quarter);
        let mut before = ((part >> (TURN_BITS - 2)) as u16).min(self.chords);
        while before > 0 && self.angle_of(before) > angle {
            before -= 1;
        }
        while before < self.chords && self.angle_of(before + 1) <= angle {
            before += 1;
        }
        let distance = |number: u16| {
            let [cosine, sine] = direction(self.angle_of(number));
            let [across, down] = self.radii;
            match axis {
                Axis::X => scaled(across, cosine),
                Axis::Y => scaled(down, sine),
            }
            .abs()
        };
        let behind = (before + 1).min(self.chords);
        Some(if distance(behind) > distance(before) {
            behind
        } else {
            before
        })
    }

    /// Top and bottom of the whole ellipse, in 1/256 pixel.
    pub(crate) fn ends_in_y(&self) -> [i32; 2] {
        let ([_, y], [_, down]) = (self.center, self.radii);
        [y - down as i32, y + down as i32]
    }

    /// The most edges in a row of pixels of a part of the arc that is monotone in y and has so many edges: less than two
    /// pixels from an end of the ellipse in y, and elsewhere. Upper bounds.
    pub(crate) fn most_edges_in_a_row(&self, edges: u16) -> [u16; 2] {
        let [_, down] = self.radii;
        let quarter = u64::from(self.chords_of_quarter);
        // x edges below the top the ellipse is r (1 - cos(x pi / 2q)) down, at least 0.916 r (x pi / 2q)^2 / 2 as long as
        // that angle is below 1: a distance h is passed after at most q sqrt(0.885 h / r) edges. More than two pixels from
        // the end, the number in a row is at most 1.16 times its derivative there. The factors leave room for the rounding
        // of angles. The further from the end, the fewer edges a row has: none has more than the one at the end.
        let edges_to = |height: u64, factor: u64| {
            let square = quarter * quarter * height * factor / 1_024;
            square.checked_div(down.into()).map_or(u64::MAX, u64::isqrt)
        };
        let at_most = |bound: u64| bound.min(edges.into()) as u16;
        let near = if down < 600 { u64::MAX } else { edges_to(256, 980) + 2 };
        let elsewhere = if down < 1_100 {
            near
        } else {
            edges_to(512, 1_130) / 4 + 2
        };
        [at_most(near), at_most(elsewhere)]
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;
    use crate::draw::antialiased::{outline_arc::WidePosition, turn::TURN};

    const CENTER: WidePosition = [1_000, -2_000];

    /// All corners between two turns are in monotone order, and no more of them are in a row of pixels than is promised.
    #[test]
    fn turns_are_all_turns_and_rows_have_no_more_edges_than_promised() {
        for radii in [
            [0, 90],
            [90, 0],
            [40, 40],
            [600, 600],
            [700, 700],
            [900, 1_024],
            [30_000, 1_099],
            [20_000, 30],
            [20_000, 1_200],
            [300, 30_000],
            [90_000, 90_000],
        ] {
            for (start, sweep) in [
                (3 * TURN / 4, TURN),
                (0, TURN),
                (5_000_000, TURN / 2),
                (9, 77),
                (TURN - 5, -TURN + 99),
            ] {
                let arc = OutlineArc::new(CENTER, radii, (start, sweep)).unwrap();
                for axis in [Axis::X, Axis::Y] {
                    let mut turns = Vec::new();
                    arc.turns(axis, &mut |index| turns.push(index));
                    assert!(turns.is_sorted() && turns.len() <= 4, "{turns:?}");
                    assert_eq!((turns[0], *turns.last().unwrap()), (0, arc.corners() - 1));
                    for part in turns.windows(2) {
                        let along: Vec<i32> = (part[0]..=part[1])
                            .map(|index| arc.corner(index)[axis as usize])
                            .collect();
                        assert!(
                            along.is_sorted() || along.iter().rev().is_sorted(),
                            "{radii:?}, {start}: {along:?}"
                        );
                        if axis == Axis::Y {
                            rows_keep_the_promise(&arc, &along);
                        }
                    }
                }
            }
        }
    }

    /// Counts the edges in each row of a part that is monotone in y.
    fn rows_keep_the_promise(arc: &OutlineArc, ys: &[i32]) {
        let edges = ys.len() as u16 - 1;
        let ([near, elsewhere], [top, bottom]) = (arc.most_edges_in_a_row(edges), arc.ends_in_y());
        let (first, last) = (ys.iter().min().unwrap() >> 8, ys.iter().max().unwrap() >> 8);
        for row in first..=last {
            let (row_top, row_bottom) = (row << 8, (row + 1) << 8);
            let lies_in_row = |pair: &&[i32]| {
                let (upper, lower) = (pair[0].min(pair[1]), pair[0].max(pair[1]));
                upper < lower && upper < row_bottom && row_top < lower
            };
            let count = ys.windows(2).filter(lies_in_row).count();
            let is_near = row_top - top < 512 || bottom - row_bottom < 512;
            let most = if is_near { near } else { elsewhere };
            assert!(
                count <= usize::from(most),
                "{arc:?}, row {row}: {count} edges, {most} promised"
            );
        }
    }
}
