//! The rows of a polygon with sub-pixel edges, each as the segments that lie in it: an edge table and an active edge
//! table (Wylie et al. 1967) for antialiasing.
//!
//! Promises: every visible row in which an edge lies, top to bottom, once. Cost: about 30 instructions for each edge in
//! a row, besides what is done with it.

use core::ops::Range;

use heapless::VecView;

use crate::scan::{ActiveSubEdge, RowSegment, SubEdge};

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

/// Hands over the segments of each row. The edge table is sorted; the other two have room for all edges in one row.
///
/// # Errors
/// The first of `cover`.
pub fn scan<E>(
    edges: &[SubEdge],
    active: &mut VecView<ActiveSubEdge>,
    segments: &mut VecView<RowSegment>,
    rows: Range<i32>,
    mut cover: impl FnMut(i32, &mut [RowSegment]) -> Result<(), E>,
) -> Result<(), E> {
    active.clear();
    let mut waiting = edges.iter().peekable();
    let Some(first) = edges.first() else { return Ok(()) };
    let mut row = first.first_row().max(rows.start);
    while row < rows.end {
        while let Some(edge) = waiting.next_if(|edge| edge.first_row() <= row) {
            if edge.end_row() > row {
                // There is room: see above.
                let _ = active.push(edge.begin(row));
            }
        }
        segments.clear();
        active.retain_mut(|edge| {
            let _ = segments.push(edge.next_segment(row));
            edge.end_row() > row.wrapping_add(1)
        });
        if !segments.is_empty() {
            cover(row, segments.as_mut_slice())?;
        }
        row = row.wrapping_add(1);
        if active.is_empty() {
            match waiting.peek() {
                Some(edge) => row = row.max(edge.first_row()),
                None => break,
            }
        }
    }
    Ok(())
}
