//! The areas of the rows of an outline whose edges are longer than a row is high.
//!
//! ```text
//!        o
//!       / \      chains begin: all segments of the row are looked at and sorted
//!      /   \
//!     /     o    one edge ends and the next one of its chain begins: both chains are walked down to the bottom of the row,
//!    /       \   edge by edge, and the few parts of edges in it are put into order
//!   /         \
//!  o----.      \ two edges pass: nothing is looked up or sorted, and what lies between their pixels is filled without
//!               \ computing its coverage
//! ```
//!
//! Most rows of a convex outline, which has two chains, are of the second or third kind.
//!
//! Guarantees: bit for bit the pixels of the rows one by one, because all add the same cells.

use core::ops::Range;

use heapless::VecView;

use crate::coverage::{
    Coverage, EmitRows,
    area::{
        accumulation_buffer::in_room,
        row_parts::RowParts,
        sparse_row::{ColumnSides, CountedEdges, are_disjoint, cover, cover_between},
    },
    edges::{
        RowSegment, Rows, Y_ONE,
        chain_walk::ChainWalk,
        monotone_chains::Chains,
        row_segments::{sort_by_left, step, update},
    },
};

/// In fewer rows, the edges of each row are compared with the sides of the columns.
const LEAST_ROWS: usize = 8;

/// Hands over the spans of all rows.
///
/// # Errors
/// The first error that `emit` returns.
#[inline(always)]
pub(super) fn cover_all<E, C: CountedEdges>(
    rows: Rows<'_>,
    columns: &Range<i32>,
    cells: &mut [i32],
    counted: &mut C,
    coverage: impl Fn(i32) -> Coverage,
    emit: &mut impl EmitRows<E>,
) -> Result<(), E> {
    let (columns, cells) = in_room(columns, cells);
    let (sides, mut chains, segments) = (ColumnSides::of(&columns), rows.chains, rows.segments);
    // Looked up once for all rows, unless there are so few that it takes longer.
    let is_inside = rows.rows.len() >= LEAST_ROWS && sides.are_around(chains.ends());
    segments.clear();
    let (mut row, end) = (chains.first_row().max(rows.rows.start), rows.rows.end);
    let mut event_row = row;
    'rows: while row < end {
        if row >= event_row {
            if let Some(pair) = two_chains(&chains, segments, row) {
                let mut parts = RowParts::new(&columns, cells);
                event_row = go_on(&chains, pair, row, &mut parts);
                parts.cover(sides, &coverage, &mut emit.row(row))?;
                row += 1;
                continue;
            }
            event_row = update(&mut chains, segments, row);
            if segments.is_empty() {
                row = event_row;
                continue;
            }
        } else if let [left, right] = segments.as_mut_slice() {
            let (left_height, right_height) = (left.signed_height(), right.signed_height());
            let event_row = event_row.min(end);
            let (left_ends, right_ends) = loop {
                let (left_ends, right_ends) = (left.step_ends(), right.step_ends());
                let ([start, _], [_, end]) = (left_ends, right_ends);
                let are_inside = is_inside || sides.are_around([start, end]);
                if !(are_disjoint(left_ends, right_ends) && are_inside) {
                    break (left_ends, right_ends);
                }
                let (left, right) = ((left_ends, left_height), (right_ends, right_height));
                cover_between(left, right, &coverage, &mut emit.row(row))?;
                row += 1;
                if row >= event_row {
                    continue 'rows;
                }
            };
            left.go_between(left_ends);
            right.go_between(right_ends);
            if left_ends > right_ends {
                sort_by_left(segments);
            }
        } else {
            step(segments);
        }
        cover(segments, &columns, cells, counted, &coverage, &mut emit.row(row))?;
        row += 1;
    }
    Ok(())
}

/// The edges of two chains that go on in a row or below it, where no other chain begins or goes on in the row.
#[inline(always)]
fn two_chains<'s>(
    chains: &Chains<'_>,
    segments: &'s mut VecView<RowSegment>,
    row: i32,
) -> Option<&'s mut [RowSegment; 2]> {
    let pair = <&mut [RowSegment; 2]>::try_from(segments.as_mut_slice()).ok()?;
    let go_on = pair.iter().all(|segment| segment.end_y() >= row * Y_ONE);
    (go_on && row < chains.first_row()).then_some(pair)
}

/// Goes on along two chains to the bottom of a row, and adds the parts of their edges in the row. Returns the next row in which
/// an edge begins or ends.
#[inline(never)]
fn go_on(chains: &Chains<'_>, pair: &mut [RowSegment; 2], row: i32, parts: &mut RowParts<'_>) -> i32 {
    let [left, right] = pair;
    let walk = ChainWalk::to(row);
    let goes_on = walk.step_down(chains, left, parts) & walk.step_down(chains, right, parts);
    left.set_whole_height();
    right.set_whole_height();
    if left.x_bottom > right.x_bottom {
        core::mem::swap(left, right);
    }
    if goes_on {
        left.last_row().min(right.last_row()).min(chains.first_row())
    } else {
        row + 1
    }
}
