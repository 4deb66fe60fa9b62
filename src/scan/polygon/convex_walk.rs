//! A convex polygon of at most four corners on its way from row to row, as words.
//!
//! ```text
//!       a _____ d       | left edge, right edge: 5 words each | row of the next change | a | b | c | d |
//!     ___/_____/___
//!       /     /         Each row of pixel centres crosses one edge on the left, which runs down, and one on the right, which runs
//!     b ----- c         up: the pixels between both crossings are inside. Where one of both ends, the next one is set up from the
//!                       corners, of which the last one is repeated where there are three.
//! ```
//!
//! Guarantees: the pixels of the polygon by the top-left rule. Cost of a row: four additions; where an edge ends the divisions of
//! two edges.

use crate::scan::polygon::{Edge, EdgeWalk, Part, ceil_pixel};

/// The first words of the right edge, of the row of the next change, and of the corners.
const RIGHT: usize = EdgeWalk::WORDS;
const CHANGE: usize = 2 * EdgeWalk::WORDS;
const CORNERS: usize = CHANGE + 1;

/// Words of a polygon.
pub(crate) const WORDS: usize = CORNERS + 8;

/// A convex polygon in a row.
pub(crate) type ConvexWalk = [u32; WORDS];

/// Corners of a convex polygon whose edges run down on the left and up on the right.
pub(crate) type Corners = [(i32, i32); 4];

/// Takes a polygon of three or four corners apart into convex ones: four corners of which the third one lies inside of the other
/// three are two triangles.
pub(crate) fn convex_parts(corners: &[(i32, i32)], call: &mut dyn FnMut(Corners)) {
    match *corners {
        [a, b, c] => call([a, b, c, c]),
        [a, b, c, d] if turns_in(b, c, d) => {
            call([a, b, c, c]);
            call([a, c, d, d]);
        }
        [a, b, c, d] => call([a, b, c, d]),
        _ => {}
    }
}

/// Whether a path turns at `b` the other way round than a convex polygon does.
fn turns_in(a: (i32, i32), b: (i32, i32), c: (i32, i32)) -> bool {
    let vector = |from: (i32, i32), to: (i32, i32)| {
        let component = |from: i32, to: i32| i64::from(to) - i64::from(from);
        (component(from.0, to.0), component(from.1, to.1))
    };
    let (before, after) = (vector(a, b), vector(b, c));
    // A factor of each product is below 2^29: it is at most as long as a stroke is wide.
    before.0 * after.1 > before.1 * after.0
}

/// The polygon in a row; `None` where it has ended above. Its corners are in units of `1 / (1 << fraction_bits)` pixel. Above its
/// first row it has no pixels, and changes in that row.
pub(crate) fn enter(corners: Corners, fraction_bits: u32, row: i32) -> Option<ConvexWalk> {
    let rows = corners.map(|(_, y)| ceil_pixel(y, fraction_bits));
    let (first, end) = rows
        .into_iter()
        .fold((i32::MAX, i32::MIN), |(first, end), row| (first.min(row), end.max(row)));
    if end <= row || first == end {
        return None;
    }
    let mut words = [0; WORDS];
    let [left, right] = if row < first {
        [Side::AHEAD, Side::AHEAD]
    } else {
        [
            side(&corners, fraction_bits, row, 1)?,
            side(&corners, fraction_bits, row, -1)?,
        ]
    };
    let change = if row < first {
        first
    } else {
        left.end_row.min(right.end_row)
    };
    let [a, b, c, d] = corners.map(|(x, y)| [x as u32, y as u32]);
    let all = left.walk.into_iter().chain(right.walk).chain([change as u32]);
    for (room, word) in words.iter_mut().zip(all.chain([a, b, c, d].into_iter().flatten())) {
        *room = word;
    }
    Some(words)
}

/// The polygon of some words in another row.
pub(crate) fn entered_again(words: &ConvexWalk, fraction_bits: u32, row: i32) -> Option<ConvexWalk> {
    let [.., ax, ay, bx, by, cx, cy, dx, dy] = words.map(|word| word as i32);
    enter([(ax, ay), (bx, by), (cx, cy), (dx, dy)], fraction_bits, row)
}

/// The row in which an edge of the polygon begins or ends.
pub(crate) const fn change_row(words: &ConvexWalk) -> i32 {
    words[CHANGE] as i32
}

/// The first column of the polygon in its row, and the one after the last; goes on to the next row.
#[inline(always)]
pub(crate) fn next_row(words: &mut [u32]) -> (i32, i32) {
    let mut step = |first: usize| {
        let Some([x, error, step, error_step, height]) = words.get_mut(first..).and_then(<[u32]>::first_chunk_mut)
        else {
            return 0;
        };
        let mut walk = EdgeWalk::of_words([*x, *error, *step, *error_step, *height]);
        let column = walk.x();
        walk.step();
        [*x, *error, ..] = walk.to_words();
        column
    };
    (step(0), step(RIGHT))
}

/// One of the two edges that a row crosses.
struct Side {
    walk: [u32; EdgeWalk::WORDS],
    end_row: i32,
}

impl Side {
    /// The side of a polygon that begins below the row in question, where it has no edge yet.
    const AHEAD: Self = Self {
        walk: [0; EdgeWalk::WORDS],
        end_row: i32::MAX,
    };
}

/// The edge of a direction that a row crosses.
fn side(corners: &Corners, fraction_bits: u32, row: i32, winding: i8) -> Option<Side> {
    let [a, b, c, d] = *corners;
    [(a, b), (b, c), (c, d), (d, a)].into_iter().find_map(|(from, to)| {
        let (upper, lower) = if winding > 0 { (from, to) } else { (to, from) };
        let rows = ceil_pixel(upper.1, fraction_bits)..ceil_pixel(lower.1, fraction_bits);
        if !rows.contains(&row) {
            return None;
        }
        let edge = Edge::from_units(from, to, fraction_bits, Part::Stroke)?;
        Some(Side {
            walk: edge.walk_from(row).to_words(),
            end_row: edge.end_row,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const BITS: u32 = 2;

    /// The change of the winding number from left of an edge to a pixel, where the pixel's row crosses the edge.
    fn winding((from, to): ((i32, i32), (i32, i32)), x: i32, y: i32) -> i32 {
        let (upper, lower, winding) = if from.1 < to.1 { (from, to, 1) } else { (to, from, -1) };
        let (x, y) = (x << BITS, y << BITS);
        let is_right = (x - upper.0) * (lower.1 - upper.1) >= (y - upper.1) * (lower.0 - upper.0);
        if (upper.1..lower.1).contains(&y) && is_right {
            winding
        } else {
            0
        }
    }

    /// Whether a pixel is inside of a polygon.
    fn is_inside(corners: &[(i32, i32)], x: i32, y: i32) -> bool {
        let ends = corners.iter().skip(1).chain(corners.first());
        let windings = corners.iter().zip(ends).map(|(from, to)| winding((*from, *to), x, y));
        windings.sum::<i32>() != 0
    }

    /// Checks all pixels of a polygon's parts: each row entered by itself, and walked to from each row above.
    fn check(corners: &[(i32, i32)]) {
        let rows = -3..4;
        for first in rows.clone() {
            let mut shown = [[false; 7]; 7];
            convex_parts(corners, &mut |part| {
                let mut words = enter(part, BITS, first);
                for (row, shown) in rows.clone().zip(&mut shown).skip((first + 3) as usize) {
                    let Some(walk) = &mut words else { break };
                    if change_row(walk) <= row {
                        words = entered_again(walk, BITS, row);
                    }
                    let Some(walk) = &mut words else { break };
                    let (start, end) = next_row(walk);
                    for (column, pixel) in (-3..).zip(shown) {
                        *pixel |= (start..end).contains(&column);
                    }
                }
            });
            for (y, row) in rows.clone().zip(shown).skip((first + 3) as usize) {
                for (x, pixel) in (-3..).zip(row) {
                    assert_eq!(pixel, is_inside(corners, x, y), "{corners:?} from {first}: {x}, {y}");
                }
            }
        }
    }

    /// Wedges of a corner and two or three others around it, of which the middle one is anywhere between the others.
    #[test]
    fn the_parts_of_a_wedge_have_its_pixels() {
        let cross = |a: (i32, i32), b: (i32, i32)| a.0 * b.1 - a.1 * b.0;
        let points = || (-8..9).step_by(3).flat_map(|x| (-8..9).step_by(2).map(move |y| (x, y)));
        for one in points() {
            for other in points().filter(|other| cross(one, *other) < 0) {
                check(&[(0, 0), one, other].map(|(x, y)| (x + 1, y)));
                for tip in points().filter(|tip| cross(one, *tip) < 0 && cross(*tip, other) < 0) {
                    check(&[(0, 0), one, tip, other].map(|(x, y)| (x + 1, y)));
                }
            }
        }
    }
}
