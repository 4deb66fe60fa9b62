//! The edge table of Wylie, Romney, Evans and Erdahl (1967): the edges of a polygon by their first row.

use heapless::VecView;

use crate::scan::polygon::{Edge, ScanEdge};

/// Sorts the edges by their first row.
pub fn sort<G: ScanEdge + Copy>(edges: &mut VecView<G>) {
    shell_sort(edges.as_mut_slice(), G::first_row);
}

/// Sorts items. Shell sort (Shell 1959) with gaps of Knuth (1973): no second table, and at most about n^1.5 steps; a few items,
/// or items that are nearly in order, are inserted at once.
pub(crate) fn shell_sort<T: Copy, K: PartialOrd>(items: &mut [T], key: impl Fn(&T) -> K) {
    // 1, 4, 13, 40, ...: the last one that is below a third of the items.
    let mut gap = 1usize;
    while gap < items.len() / 3 {
        gap = gap * 3 + 1;
    }
    while gap > 0 {
        insertion_sort(items, gap, &key);
        gap /= 3;
    }
}

/// Sorts each run of items that lie a gap apart: fast where they are nearly in order.
#[inline(never)]
pub(crate) fn insertion_sort<T: Copy, K: PartialOrd>(items: &mut [T], gap: usize, key: impl Fn(&T) -> K) {
    for end in gap..items.len() {
        let (Some(before), Some(last)) = (items.get(end - gap), items.get(end)) else {
            return;
        };
        let inserted_key = key(last);
        // Items are mostly in order already, and nothing is copied.
        if key(before) <= inserted_key {
            continue;
        }
        let (inserted, mut index) = (*last, end);
        let is_after = |before: &&T| key(before) > inserted_key;
        while let Some(before) = index
            .checked_sub(gap)
            .and_then(|before| items.get(before))
            .filter(is_after)
        {
            let before = *before;
            put(items, index, before);
            index -= gap;
        }
        put(items, index, inserted);
    }
}

fn put<T>(items: &mut [T], index: usize, item: T) {
    if let Some(here) = items.get_mut(index) {
        *here = item;
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
            edges.iter().take(index + 1).filter(|edge| edge.end_row > row).count()
        })
        .max()
        .unwrap_or(0)
}
