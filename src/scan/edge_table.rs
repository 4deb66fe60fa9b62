//! The edge table of Wylie, Romney, Evans and Erdahl (1967): the edges of a polygon by their first row.

use heapless::VecView;

use crate::scan::{Edge, ScanEdge};

/// Sorts the edges by their first row. Heap sort (Williams 1964): no worst case beyond n log n, no second table.
pub fn sort<G: ScanEdge + Copy>(edges: &mut VecView<G>) {
    sort_by_row(edges.as_mut_slice(), G::first_row);
}

/// The same for anything that begins in a row.
pub(super) fn sort_by_row<T: Copy>(items: &mut [T], first_row: impl Fn(&T) -> i32) {
    let cells = core::cell::Cell::from_mut(items).as_slice_of_cells();
    let row = |index: usize| cells.get(index).map(|cell| first_row(&cell.get()));
    let exchange = |one: usize, other: usize| {
        if let (Some(one), Some(other)) = (cells.get(one), cells.get(other)) {
            one.swap(other);
        }
    };
    let sift_down = |start: usize, end: usize| {
        let mut root = start;
        loop {
            let left = root.wrapping_mul(2).wrapping_add(1);
            let right = left.wrapping_add(1);
            let child = if right < end && row(right) > row(left) {
                right
            } else {
                left
            };
            if child >= end || row(child) <= row(root) {
                return;
            }
            exchange(root, child);
            root = child;
        }
    };
    let count = cells.len();
    for start in (0..count / 2).rev() {
        sift_down(start, count);
    }
    for end in (1..count).rev() {
        exchange(0, end);
        sift_down(0, end);
    }
}

/// The most edges that cross one row, of a sorted table. Cost: quadratic in the edges, once a polygon.
pub fn most_active(edges: &[Edge]) -> usize {
    edges
        .iter()
        .enumerate()
        .map(|(index, last_entered)| {
            // The number grows only where an edge enters; those that enter in the same row follow it in the table.
            let row = last_entered.first_row;
            edges
                .iter()
                .take(index.wrapping_add(1))
                .filter(|edge| edge.end_row > row)
                .count()
        })
        .max()
        .unwrap_or(0)
}
