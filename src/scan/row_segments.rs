//! The rows of a polygon with sub-pixel edges, each as the segments that lie in it: an edge table and an active edge
//! table (Wylie et al. 1967) for antialiasing.
//!
//! Promises: every visible row in which an edge lies, top to bottom, once. Cost: about 20 instructions for each edge in
//! a row, besides what is done with it.

use core::ops::Range;

use heapless::VecView;

use crate::scan::{RowSegment, SubEdge};

/// Sorts an edge table by first row.
pub fn sort(edges: &mut VecView<SubEdge>) {
    edges.as_mut_slice().sort_unstable_by_key(SubEdge::first_row);
}

/// The most edges that lie in one row, of a sorted table. Cost: quadratic in the edges, once a polygon.
pub fn most_active(edges: &[SubEdge]) -> usize {
    let active_with = |index: usize, last: &SubEdge| {
        let begun = edges.iter().take(index.wrapping_add(1));
        begun.filter(|edge| edge.end_row() > last.first_row()).count()
    };
    let counts = edges.iter().enumerate().map(|(index, last)| active_with(index, last));
    counts.max().unwrap_or(0)
}

/// Hands over the segments of each row, in the order in which the last row's were left. The edge table is sorted;
/// `segments` has room for all edges in one row.
///
/// # Errors
/// The first of `cover`.
pub fn scan<E>(
    edges: &[SubEdge],
    segments: &mut VecView<RowSegment>,
    rows: Range<i32>,
    mut cover: impl FnMut(i32, &mut [RowSegment]) -> Result<(), E>,
) -> Result<(), E> {
    segments.clear();
    let mut waiting = edges;
    let mut next_row = first_row(waiting);
    let mut row = next_row.max(rows.start);
    while row < rows.end {
        if next_row <= row {
            waiting = begin(waiting, segments, row);
            next_row = first_row(waiting);
        }
        if !segments.is_empty() {
            cover(row, segments.as_mut_slice())?;
        }
        row = row.wrapping_add(1);
        let mut all_go_on = true;
        for segment in segments.iter_mut() {
            all_go_on &= segment.advance(row);
        }
        if !all_go_on {
            segments.retain(|segment| segment.y_bottom > 0);
        }
        if segments.is_empty() {
            row = row.max(next_row);
        }
    }
    Ok(())
}

/// Of the first of the edges that wait; after all rows where none does.
fn first_row(waiting: &[SubEdge]) -> i32 {
    waiting.first().map_or(i32::MAX, SubEdge::first_row)
}

/// Begins the edges that have begun in a row or before; the others still wait.
#[inline(never)]
fn begin<'e>(waiting: &'e [SubEdge], segments: &mut VecView<RowSegment>, row: i32) -> &'e [SubEdge] {
    let begun = waiting.iter().take_while(|edge| edge.first_row() <= row);
    let mut count = 0usize;
    for edge in begun {
        count = count.wrapping_add(1);
        if edge.end_row() > row {
            // There is room: see above.
            let _ = segments.push(edge.begin(row));
        }
    }
    waiting.get(count..).unwrap_or_default()
}
