//! The active edge table of Wylie, Romney, Evans and Erdahl (1967): the edges that cross the current row, left to right.

use core::cell::Cell;

use heapless::VecView;

use crate::scan::{Crossing, ScanEdge};

/// An edge that crosses the current row.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ActiveEdge {
    /// Where it crosses it.
    pub crossing: Crossing,
    /// Its place in the edge table.
    pub edge: usize,
}

/// Begins at a row: enters the edges that cross it and returns the place in the edge table of those still to come.
///
/// Edges that do not fit are left out: the caller has made the table large enough.
pub fn begin<G: ScanEdge>(active: &mut VecView<ActiveEdge>, edges: &[G], row: i32) -> usize {
    active.clear();
    let mut next = 0usize;
    for edge in edges.iter().take_while(|edge| edge.first_row() <= row) {
        if edge.end_row() > row {
            let _ = active.push(ActiveEdge {
                crossing: edge.crossing_at(row),
                edge: next,
            });
        }
        next = next.wrapping_add(1);
    }
    sort(active);
    next
}

/// Goes on to the row after: steps what crosses it, drops what has ended, enters what begins there.
///
/// Cost: about a dozen instructions an edge while their order stays the same.
pub fn advance<G: ScanEdge>(active: &mut VecView<ActiveEdge>, edges: &[G], next: &mut usize, row: i32) {
    active.retain_mut(|active| match edges.get(active.edge) {
        Some(edge) if edge.end_row() > row => {
            active.crossing = edge.next_crossing(active.crossing, row);
            true
        }
        _ => false,
    });
    while let Some(edge) = edges.get(*next).filter(|edge| edge.first_row() <= row) {
        let _ = active.push(ActiveEdge {
            crossing: edge.first_crossing(),
            edge: *next,
        });
        *next = next.wrapping_add(1);
    }
    sort(active);
}

/// By column; insertion sort, because neighbouring rows have nearly the same order.
fn sort(active: &mut VecView<ActiveEdge>) {
    let cells = Cell::from_mut(active.as_mut_slice()).as_slice_of_cells();
    for end in 1..cells.len() {
        let mut place = end;
        while let Some(before) = place.checked_sub(1) {
            let (Some(left), Some(right)) = (cells.get(before), cells.get(place)) else {
                break;
            };
            if left.get().crossing.x <= right.get().crossing.x {
                break;
            }
            left.swap(right);
            place = before;
        }
    }
}
