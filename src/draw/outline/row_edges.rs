//! How many edges of an outline the fullest row of pixels has, counted.
//!
//! ```text
//!        edges        row    count
//!      \     /         0       2
//!       \   /\         1       3      each edge adds 1 to the rows in which it lies
//!        \_/  \        2       3
//! ```
//!
//! Guarantees: the number is exact where it is at most 65,534. Cost: all edges for every 128 rows, and 256 bytes of stack.

use core::ops::Range;

use crate::{coverage::edges::AntialiasedEdge, draw::SubOutline};

/// Rows that are counted at once.
const ROWS: usize = 128;

/// The most edges that one of some rows has, in which all edges of an outline lie; `at_most` where there are many.
#[inline(never)]
pub(crate) fn most_edges(outline: &dyn SubOutline, rows: Range<i32>, at_most: usize) -> usize {
    let mut most = 0;
    for first in rows.step_by(ROWS) {
        let mut counts = [0u16; ROWS];
        outline.edges(&mut |from, to| {
            let Some(edge) = AntialiasedEdge::from_units(from, to) else {
                return;
            };
            let index = |row: i32| usize::try_from(row - first).unwrap_or(0).min(ROWS);
            let counts = counts.get_mut(index(edge.first_row())..index(edge.end_row()));
            for count in counts.unwrap_or_default() {
                *count = count.saturating_add(1);
            }
        });
        most = counts.iter().copied().max().unwrap_or(0).max(most);
    }
    if most == u16::MAX { at_most } else { most.into() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Sub8, SubPoint};

    /// A zigzag at the bottom of an outline that is higher than the rows that are counted at once.
    #[test]
    fn the_fullest_row_may_be_anywhere() {
        let point = |x: i32, y: i32| SubPoint::<Sub8>::from_units(x * 256 + 128, y * 256 + 128).unwrap();
        let zigzag = [
            (0, -300),
            (90, -300),
            (90, 300),
            (80, 290),
            (70, 300),
            (60, 290),
            (50, 300),
        ];
        let zigzag = zigzag.map(|(x, y)| point(x, y));
        assert_eq!(most_edges(&[zigzag.as_slice()], -299..301, 7), 6);
    }

    #[test]
    fn hundreds_of_edges_in_a_row_are_counted() {
        let corner = |x: i32| SubPoint::<Sub8>::from_units(x * 256, x % 2 * 2_560).unwrap();
        let zigzag: [_; 300] = core::array::from_fn(|x| corner(x as i32));
        assert_eq!(most_edges(&[zigzag.as_slice()], 0..11, 1_000), 300);
    }
}
