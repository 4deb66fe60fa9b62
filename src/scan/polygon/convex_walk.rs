//! A convex polygon of at most four corners on its way from row to row, as words.
//!
//! ```text
//!       a _____ d       | left edge, right edge: 5 words each | rows in which both end | a | b | c | d |
//!     ___/_____/___
//!       /     /         Each row of pixel centres crosses one edge on the left, which runs down, and one on the right, which runs
//!     b ----- c         up: the pixels between both crossings are inside. Where one of both ends, the next one is set up from the
//!                       corners, of which the last one is repeated where there are three.
//! ```
//!
//! Guarantees: the pixels of the polygon by the top-left rule, if its rows fit 16 bits. Cost of a row: four additions; where an
//! edge ends, the divisions of another one.

use crate::scan::polygon::{Edge, EdgeWalk, Part, ceil_pixel};

/// The word with the rows in which the edges end, the left one's in the lower half.
const ENDS: usize = 2 * EdgeWalk::WORDS;

/// Words of a polygon.
pub(crate) const WORDS: usize = ENDS + 1 + 8;

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
    // Either both vectors lead to a tip that is at most 10,240 pixels away, or one of them is at most as long as a stroke is wide:
    // the products are below 2^61.
    before.0 * after.1 > before.1 * after.0
}

/// Sets up the polygon in a row. Returns `false` where it has ended above. Its corners are in units of
/// `1 / (1 << fraction_bits)` pixel. Above its first row it has no pixels, and both edges end in that row.
pub(crate) fn enter(words: &mut ConvexWalk, corners: Corners, fraction_bits: u32, row: i32) -> bool {
    let rows = corners.map(|(_, y)| ceil_pixel(y, fraction_bits));
    let (first, end) = rows
        .into_iter()
        .fold((i32::MAX, i32::MIN), |(first, end), row| (first.min(row), end.max(row)));
    if end <= row || first == end {
        return false;
    }
    let [.., ax, ay, bx, by, cx, cy, dx, dy] = words;
    for ([x_word, y_word], (x, y)) in [[ax, ay], [bx, by], [cx, cy], [dx, dy]].into_iter().zip(corners) {
        (*x_word, *y_word) = (x as u32, y as u32);
    }
    words[ENDS] = ends_word([first as i16; 2]);
    row < first || go_on(words, fraction_bits, row)
}

/// Sets up the edges that follow those that end in a row or above it. Returns `false` where the polygon ends with them.
pub(crate) fn go_on(words: &mut ConvexWalk, fraction_bits: u32, row: i32) -> bool {
    let [.., ax, ay, bx, by, cx, cy, dx, dy] = words.map(|word| word as i32);
    let corners = [(ax, ay), (bx, by), (cx, cy), (dx, dy)];
    let mut ends = ends_of(words);
    let edges = words.chunks_exact_mut(EdgeWalk::WORDS);
    for ((edge, end), runs_down) in edges.zip(&mut ends).zip([true, false]) {
        if i32::from(*end) > row {
            continue;
        }
        let Some((walk, end_row)) = side(&corners, fraction_bits, row, runs_down) else {
            return false;
        };
        if let Some(edge) = edge.first_chunk_mut() {
            (*edge, *end) = (walk, end_row);
        }
    }
    words[ENDS] = ends_word(ends);
    true
}

/// The rows in which the left edge and the right edge end.
const fn ends_of(words: &ConvexWalk) -> [i16; 2] {
    let ends = words[ENDS];
    [ends as i16, (ends >> 16) as i16]
}

const fn ends_word([left, right]: [i16; 2]) -> u32 {
    left as u16 as u32 | (right as u16 as u32) << 16
}

/// The row in which an edge of the polygon begins or ends.
#[inline]
pub(crate) fn change_row(words: &ConvexWalk) -> i32 {
    let [left, right] = ends_of(words);
    left.min(right).into()
}

/// The first column of the polygon in its row, and the one after the last.
#[inline]
pub(crate) const fn columns(words: &ConvexWalk) -> (i32, i32) {
    // The first word of an edge is its column.
    (words[0] as i32, words[EdgeWalk::WORDS] as i32)
}

/// The first column of the polygon in its row, and the one after the last; goes on to the next row.
#[inline(always)]
pub(crate) fn next_row(words: &mut ConvexWalk) -> (i32, i32) {
    let [left_x, left_error, left_step, left_error_step, left_height, rest @ ..] = words;
    let [right_x, right_error, right_step, right_error_step, right_height, ..] = rest;
    let left = step(left_x, left_error, [*left_step, *left_error_step, *left_height]);
    let right = step(right_x, right_error, [*right_step, *right_error_step, *right_height]);
    (left, right)
}

/// The column of an edge in its row; goes on to the next row.
#[inline(always)]
fn step(x: &mut u32, error: &mut u32, [step, error_step, height]: [u32; 3]) -> i32 {
    let mut walk = EdgeWalk::of_words([*x, *error, step, error_step, height]);
    let column = walk.x();
    walk.step();
    [*x, *error, ..] = walk.to_words();
    column
}

/// The edge of a direction that a row crosses, from there on, and the row in which it ends.
fn side(corners: &Corners, fraction_bits: u32, row: i32, runs_down: bool) -> Option<([u32; EdgeWalk::WORDS], i16)> {
    let [a, b, c, d] = *corners;
    [(a, b), (b, c), (c, d), (d, a)].into_iter().find_map(|(from, to)| {
        let (upper, lower) = if runs_down { (from, to) } else { (to, from) };
        let rows = ceil_pixel(upper.1, fraction_bits)..ceil_pixel(lower.1, fraction_bits);
        if !rows.contains(&row) {
            return None;
        }
        let edge = Edge::from_units(from, to, fraction_bits, Part::Stroke)?;
        Some((edge.walk_from(row).to_words(), edge.end_row as i16))
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
                let mut words = [0; WORDS];
                let mut goes_on = enter(&mut words, part, BITS, first);
                for (row, shown) in rows.clone().zip(&mut shown).skip((first + 3) as usize) {
                    goes_on &= change_row(&words) > row || go_on(&mut words, BITS, row);
                    if !goes_on {
                        break;
                    }
                    let (start, end) = next_row(&mut words);
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
