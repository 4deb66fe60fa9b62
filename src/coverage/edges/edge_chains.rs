//! The edges of an outline as chains that run down without a break, and the chains by their first row.
//!
//! Guarantees: every edge is in one chain, and the one below it in the outline comes next, so that only the first edges of
//! chains are put into order, by a merge sort of a linked list (von Neumann 1945). An outline has few chains: a convex
//! contour has two, or three where it begins between its top and its bottom. No second table. Cost: about a dozen
//! instructions an edge, and n log n of the chains.
//!
//! Source: the monotone chains of scan-line rasterizers (FreeType's profiles, Turner 1996).

use heapless::{Vec, VecView};

use crate::coverage::edges::{
    SubEdge,
    sub_edge::{NONE, Place, fine},
};

/// The edges of an outline, in chains.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Chains<'e> {
    edges: &'e [SubEdge],
    /// The first edge of the first chain.
    first: Place,
}

/// Puts an edge into a table, as the next one of an outline: where both go down or both go up, they are in one chain.
#[inline(always)]
pub(crate) fn push(edges: &mut VecView<SubEdge>, mut edge: SubEdge) {
    if let Some(last) = edges.last_mut() {
        last.join(&mut edge);
    }
    // Whoever calls counts them.
    let _ = edges.push(edge);
}

/// Puts the chains of edges into order by first row; returns the first edge of the first one, and the row after the last
/// one of all.
pub(crate) fn link(edges: &mut [SubEdge]) -> (Place, i32) {
    // The list at a place, if there is one, is of twice as many chains as the one after it, or of more.
    let mut lists = Vec::<Place, { u32::BITS as usize }>::new();
    let (mut count, mut place, mut end_row) = (0u32, 0, i32::MIN);
    while let Some(edge) = edges.get_mut(place as usize) {
        if edge.is_last() {
            end_row = end_row.max(edge.end_row());
        }
        if edge.is_first() {
            edge.set_next_chain(NONE);
            let mut list = place;
            for _ in 0..count.trailing_ones() {
                list = merge(edges, lists.pop().unwrap_or(NONE), list);
            }
            let _ = lists.push(list);
            count = count.wrapping_add(1);
        }
        place = place.wrapping_add(1);
    }
    let mut all = lists.pop().unwrap_or(NONE);
    while let Some(list) = lists.pop() {
        all = merge(edges, list, all);
    }
    (all, end_row)
}

/// Merges two lists of chains.
fn merge(edges: &mut [SubEdge], one: Place, other: Place) -> Place {
    let row = |edges: &[SubEdge], place: Place| first_row(edges, place);
    let (mut lower, mut upper) = if row(edges, one) <= row(edges, other) {
        (one, other)
    } else {
        (other, one)
    };
    let first = lower;
    while upper != NONE {
        let next = next(edges, lower);
        if next != NONE && row(edges, next) <= row(edges, upper) {
            lower = next;
        } else {
            set_next(edges, lower, upper);
            (lower, upper) = (upper, next);
        }
    }
    first
}

fn get(edges: &[SubEdge], place: Place) -> Option<&SubEdge> {
    edges.get(place as usize)
}

/// The first row of the edge at an index of the table; a row after all others where there is no edge.
#[inline(always)]
fn first_row(edges: &[SubEdge], place: Place) -> i32 {
    get(edges, place).map_or(i32::MAX, SubEdge::first_row)
}

/// The first edge of the next chain.
#[inline(always)]
fn next(edges: &[SubEdge], place: Place) -> Place {
    get(edges, place).map_or(NONE, SubEdge::next_chain)
}

fn set_next(edges: &mut [SubEdge], place: Place, next: Place) {
    if let Some(edge) = edges.get_mut(place as usize) {
        edge.set_next_chain(next);
    }
}

impl<'e> Chains<'e> {
    /// The chains of a table that was linked, from its first chain on.
    #[inline(always)]
    pub(crate) fn new(edges: &'e [SubEdge], first: Place) -> Self {
        Self { edges, first }
    }

    /// The first row of the chains that wait; after all rows where none does.
    #[inline(always)]
    pub(crate) fn first_row(&self) -> i32 {
        first_row(self.edges, self.first)
    }

    /// How many edges there are in all chains.
    #[inline(always)]
    pub(crate) fn edges(&self) -> usize {
        self.edges.len()
    }

    /// The left end of all edges and the right one, in fine units.
    pub(crate) fn ends(&self) -> [i32; 2] {
        let (mut left, mut right) = (i32::MAX, i32::MIN);
        let mut add = |x: i32| (left, right) = (left.min(x), right.max(x));
        for edge in self.edges {
            let [[top, _], [bottom, _]] = edge.ends();
            add(top);
            // Where others are below, it is the top of one.
            if edge.is_last() {
                add(bottom);
            }
        }
        [left, right].map(fine)
    }

    /// Takes the next chain, if it begins in a row or above: the first edge of it that does not end above the row.
    #[inline(always)]
    pub(crate) fn begin(&mut self, row: i32) -> Option<(Place, &'e SubEdge)> {
        loop {
            let place = self.first;
            let edge = get(self.edges, place).filter(|edge| edge.first_row() <= row)?;
            self.first = edge.next_chain();
            if edge.end_row() > row {
                return Some((place, edge));
            }
            let begun = self.skip_to(row, place, edge);
            if begun.is_some() {
                return begun;
            }
        }
    }

    /// The first edge below one that does not end above a row.
    #[inline(never)]
    fn skip_to(&self, row: i32, mut place: Place, mut edge: &'e SubEdge) -> Option<(Place, &'e SubEdge)> {
        // The same for a whole chain. In bands of one row most edges are skipped, time and again.
        let step = edge.winding() as Place;
        while edge.end_row() <= row {
            if edge.is_last() {
                return None;
            }
            place = place.wrapping_add(step);
            edge = self.get(place)?;
        }
        Some((place, edge))
    }

    /// The edge that goes on where one ends.
    #[inline(always)]
    pub(crate) fn below(&self, place: Place, edge: &SubEdge) -> Option<(Place, &'e SubEdge)> {
        if edge.is_last() {
            return None;
        }
        let below = place.wrapping_add(edge.winding() as Place);
        Some((below, get(self.edges, below)?))
    }

    /// The edge at a place.
    #[inline(always)]
    pub(crate) fn get(&self, place: Place) -> Option<&'e SubEdge> {
        get(self.edges, place)
    }

    /// The most edges that lie in one row. `begun` has room for as many places as there are edges. Cost: as many steps as
    /// there are pairs of an edge and a chain in a row, once a polygon.
    pub(crate) fn most_active(mut self, begun: &mut VecView<Place>) -> usize {
        begun.clear();
        let (mut most, mut row) = (0, self.first_row());
        // The number grows only where an edge begins.
        while row < i32::MAX {
            while let Some((place, _)) = self.begin(row) {
                let _ = begun.push(place);
            }
            let (mut active, mut next_row) = (0usize, self.first_row());
            begun.retain_mut(|place| {
                let edge = self.get(*place);
                let Some((first, edge)) = edge.and_then(|edge| self.skip_to(row, *place, edge)) else {
                    return false;
                };
                *place = first;
                active = active.wrapping_add(1);
                let (mut last, mut edge) = (first, edge);
                while let Some((below, next)) = self.below(last, edge) {
                    if next.first_row() > row {
                        next_row = next_row.min(next.first_row());
                        break;
                    }
                    active = active.wrapping_add(1);
                    (last, edge) = (below, next);
                }
                true
            });
            (most, row) = (most.max(active), next_row);
        }
        most
    }
}
