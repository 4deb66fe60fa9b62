//! The rows of a polygon with sub-pixel edges, each as the segments that lie in it: an edge table and an active edge
//! table (Wylie et al. 1967) for antialiasing.
//!
//! Promises: every visible row in which an edge lies, top to bottom, once. Cost: about 20 instructions for each edge in
//! a row, besides what is done with it.

use core::ops::Range;

use heapless::VecView;

use crate::scan::{
    RowSegment, SubEdge,
    edge_table::{insertion_sort, sort_by_row},
};

/// Sorts an edge table by first row.
pub fn sort(edges: &mut VecView<SubEdge>) {
    sort_by_row(edges.as_mut_slice(), SubEdge::first_row);
}

/// The most edges that lie in one row, of a sorted table. `ends` has room for as many numbers as there are edges. Cost: as
/// many steps as there are pairs of edges in a row, once a polygon.
pub fn most_active(edges: &[SubEdge], ends: &mut VecView<i32>) -> usize {
    ends.clear();
    let mut most = 0;
    for edge in edges {
        ends.retain(|end| *end > edge.first_row());
        let _ = ends.push(edge.end_row());
        most = most.max(ends.len());
    }
    most
}

/// Hands over the segments of each row, from left to right by their left ends. The edge table is sorted; `segments` has
/// room for all edges in one row.
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
    let mut row = first_row(waiting).max(rows.start);
    // Before that row no edge begins or ends.
    let mut next_end = row;
    while row < rows.end {
        if row < next_end {
            step(segments);
        } else {
            (waiting, next_end) = change(waiting, segments, row);
        }
        if segments.is_empty() {
            row = next_end;
        } else {
            cover(row, segments.as_mut_slice())?;
            row = row.wrapping_add(1);
        }
    }
    Ok(())
}

/// Goes on to a row where all edges go on.
#[inline(always)]
fn step(segments: &mut [RowSegment]) {
    let (mut last, mut differences) = (i32::MIN / 2, 0);
    let mut rest = &mut *segments;
    while let [segment, others @ ..] = rest {
        segment.step();
        let left = segment.ends().0;
        // One question for all of them: negative where one is.
        differences |= left.wrapping_sub(last);
        (last, rest) = (left, others);
    }
    if differences < 0 {
        sort_by_left(segments);
    }
}

/// Goes on to a row where edges begin or end: those that still wait, and the next row of that kind.
#[inline(never)]
fn change<'e>(waiting: &'e [SubEdge], segments: &mut VecView<RowSegment>, row: i32) -> (&'e [SubEdge], i32) {
    segments.retain(|segment| segment.last_row() >= row);
    for segment in segments.iter_mut() {
        segment.advance(row);
    }
    let begun = waiting.iter().take_while(|edge| edge.first_row() <= row).count();
    let (begun, waiting) = waiting.split_at_checked(begun).unwrap_or_default();
    for edge in begun.iter().filter(|edge| edge.end_row() > row) {
        // There is room: see above.
        let _ = segments.push(edge.begin(row));
    }
    sort_by_left(segments);
    let next_row = row.wrapping_add(1);
    // What begins in this row has its top there, not in the next one.
    let next_end = |segment: &RowSegment| {
        if segment.y_top > 0 {
            next_row
        } else {
            segment.last_row().max(next_row)
        }
    };
    let next_end = segments.iter().map(next_end).fold(first_row(waiting), i32::min);
    (waiting, next_end)
}

fn sort_by_left(segments: &mut [RowSegment]) {
    insertion_sort(segments, 1, |segment| segment.ends().0);
}

/// Of the first of the edges that wait; after all rows where none does.
fn first_row(waiting: &[SubEdge]) -> i32 {
    waiting.first().map_or(i32::MAX, SubEdge::first_row)
}
