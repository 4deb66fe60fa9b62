//! The active edge table of Wylie, Romney, Evans and Erdahl (1967): the edges that cross the current row, left to right.

use core::cell::Cell;

use heapless::VecView;

use crate::scan::polygon::{Crossing, ScanEdge};

/// An edge that crosses the current row.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ActiveEdge<'e, G> {
    /// Column and error term of the crossing of this edge with the current row of pixel centres.
    pub crossing: Crossing,
    /// The edge in the edge table.
    pub edge: &'e G,
}

impl<G: ScanEdge> ActiveEdge<'_, G> {
    #[inline]
    fn step(&mut self, row: i32) {
        self.crossing = self.edge.next_crossing(self.crossing, row);
    }
}

/// Steps all active edges to row `row`, which all of them cross; sorts them again where two have changed sides.
///
/// Cost: about 15 instructions an edge while their order stays the same.
#[inline]
pub fn step<G: ScanEdge + Copy>(active: &mut [ActiveEdge<'_, G>], row: i32) {
    let mut last = i32::MIN;
    let mut edges = active.iter_mut();
    while let Some(edge) = edges.next() {
        edge.step(row);
        // Rare, and a loop of two ends is not unrolled: there are a few edges in a row.
        if edge.crossing.x < last {
            edges.for_each(|edge| edge.step(row));
            sort(active);
            return;
        }
        last = edge.crossing.x;
    }
}

/// Steps the active edges to row `row`, or begins there with an empty table: drops the edges that have ended, and
/// enters the waiting edges that cross the row. Returns the next row where an edge begins or ends.
///
/// Edges that do not fit are left out: the caller has made the table large enough.
#[inline(never)]
pub fn change<'e, G: ScanEdge + Copy>(active: &mut VecView<ActiveEdge<'e, G>>, waiting: &mut &'e [G], row: i32) -> i32 {
    let next_end = go_on(active, row);
    let next_change = enter(active, waiting, row, next_end);
    sort(active);
    next_change
}

/// Drops the edges that have ended and steps the others; returns the next row where one of these ends.
#[inline]
fn go_on<G: ScanEdge + Copy>(active: &mut VecView<ActiveEdge<'_, G>>, row: i32) -> i32 {
    let (mut kept, mut next_end) = (0usize, i32::MAX);
    let cells = Cell::from_mut(active.as_mut_slice()).as_slice_of_cells();
    for cell in cells {
        let mut active = cell.get();
        let end_row = active.edge.end_row();
        if end_row <= row {
            continue;
        }
        next_end = next_end.min(end_row);
        active.step(row);
        if let Some(index) = cells.get(kept) {
            index.set(active);
        }
        kept += 1;
    }
    active.truncate(kept);
    next_end
}

/// Enters the waiting edges that cross a row. Returns the next row where an edge begins, or one of these ends, or
/// `next_end`, the row where the first of the others ends.
#[inline]
fn enter<'e, G: ScanEdge>(
    active: &mut VecView<ActiveEdge<'e, G>>,
    waiting: &mut &'e [G],
    row: i32,
    next_end: i32,
) -> i32 {
    let (mut rest, mut next_change) = (*waiting, next_end);
    while let [edge, others @ ..] = rest {
        if edge.first_row() > row {
            next_change = next_change.min(edge.first_row());
            break;
        }
        rest = others;
        if edge.end_row() > row {
            next_change = next_change.min(edge.end_row());
            let crossing = edge.crossing_at(row);
            let pushed = active.push(ActiveEdge { crossing, edge });
            debug_assert!(pushed.is_ok(), "the table has room for every edge that crosses a row");
        }
    }
    *waiting = rest;
    next_change
}

/// Sorts active edges by their column: insertion sort, because neighbouring rows have nearly the same order.
#[inline(never)]
fn sort<G: Copy>(active: &mut [ActiveEdge<'_, G>]) {
    let cells = Cell::from_mut(active).as_slice_of_cells();
    for end in 1..cells.len() {
        let mut index = end;
        while let Some(before) = index.checked_sub(1) {
            let (Some(left), Some(right)) = (cells.get(before), cells.get(index)) else {
                break;
            };
            if left.get().crossing.x <= right.get().crossing.x {
                break;
            }
            // Not `Cell::swap`: that panics where two cells overlap, which the compiler cannot rule out.
            let edge = left.replace(right.get());
            right.set(edge);
            index = before;
        }
    }
}
