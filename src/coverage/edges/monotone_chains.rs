//! The edges of an outline as y-monotone chains, and the chains in order of their first row.
//!
//! ```text
//!        o               The outline runs down along the left and up along the right: two chains, A and B. The edges of a
//!    A0 / \ B2          chain lie beside each other in the table, upwards or downwards by the winding, so that the
//!      o   \            successor of an edge is its neighbour there. Only first edges of chains, A0 and B2, are put into
//!   A1 |    o B1         order; each has the index of the next chain's first edge (a linked list).
//!      o   /
//!    A2 \ / B0          table:  A0 A1 A2 B0 B1 B2        order:  A0, B2
//!        o
//! ```
//!
//! Guarantees: every edge is in one chain. The list is sorted by a merge sort (von Neumann 1945), without a second
//! table. An outline has few chains: a convex contour has two, or three where it begins between its top and its bottom.
//! Cost: about a dozen instructions an edge, and n log n of the chains.
//!
//! Source: the profiles of scan-line rasterizers (FreeType, Turner 1996).

use heapless::{Vec, VecView};

use crate::{
    coverage::edges::{
        AntialiasedEdge,
        antialiased_edge::{NO_EDGE, fine},
    },
    geometry::{Sub8, SubPixel},
};

/// The y-monotone chains of an outline that have not begun yet.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Chains<'e> {
    edges: &'e [AntialiasedEdge],
    /// The index of the first chain's first edge.
    first: u32,
}

/// Puts the edges of an outline into a table, one after the other in the order of its contours, and finds their
/// y-monotone chains on the way.
pub(crate) struct ChainBuilder<'t> {
    edges: &'t mut VecView<AntialiasedEdge>,
    /// The index at which the last chain begins in the table, with its first edge or with its last one.
    begin: usize,
    /// The number of edges that the table had no room for.
    left_out: usize,
    /// Negative where a corner is outside the domain of [`Sub8`].
    outside: i32,
}

impl<'t> ChainBuilder<'t> {
    /// A builder that fills an empty table.
    pub(crate) fn new(edges: &'t mut VecView<AntialiasedEdge>) -> Self {
        Self {
            edges,
            begin: 0,
            left_out: 0,
            outside: 0,
        }
    }

    /// Adds the next edge of the outline, by its ends in 1/256 pixel from the centre of pixel (0, 0); nothing where it
    /// is level.
    #[inline(always)]
    pub(crate) fn add(&mut self, from: [i32; 2], to: [i32; 2]) {
        if !self.continue_chain(from, to) {
            self.begin_chain(from, to);
        }
    }

    /// Adds an edge if it is in one chain with the edge before it, and returns whether it is.
    #[inline(always)]
    fn continue_chain(&mut self, from: [i32; 2], to: [i32; 2]) -> bool {
        let Some(edge) = self.edges.last_mut().and_then(|last| last.continued(from, to)) else {
            return false;
        };
        // The edge before it ended where this one begins.
        self.outside |= sign_outside(to);
        self.push(edge);
        true
    }

    /// Adds an edge that is not in one chain with the edge before it.
    // Not inlined: most edges continue a chain, and inlined this costs each of them 6 registers saved (ring of 224 edges
    // in 16 x 16 pixels, x86-64: 6 % of the time).
    #[inline(never)]
    fn begin_chain(&mut self, from: [i32; 2], to: [i32; 2]) {
        self.outside |= sign_outside(from) | sign_outside(to);
        if let Some(edge) = AntialiasedEdge::from_units(from, to) {
            self.end_chain();
            self.push(edge);
        }
    }

    #[inline(always)]
    fn push(&mut self, edge: AntialiasedEdge) {
        if self.edges.push(edge).is_err() {
            self.left_out = self.left_out.saturating_add(1);
        }
    }

    /// Notes the number of edges of the last chain, if there is one.
    fn end_chain(&mut self) {
        let count = self.edges.len() - self.begin;
        if let Some(edge) = self.edges.get_mut(self.begin) {
            edge.set_count(count as u32);
        }
        self.begin += count;
    }

    /// Whether all corners are in the domain of [`Sub8`].
    pub(crate) fn is_in_domain(&self) -> bool {
        self.outside >= 0
    }

    /// The number of edges that came, also of those which the table had no room for.
    pub(crate) fn needed(&self) -> usize {
        self.edges.len().saturating_add(self.left_out)
    }

    /// Sorts the chains by their first row, once all edges are in the table. Returns the index of the first chain's first
    /// edge, and the row after the last one that an edge lies in.
    pub(crate) fn finish(mut self) -> (u32, i32) {
        self.end_chain();
        link(self.edges)
    }
}

/// Sorts the chains of a table by their first row. Returns the index of the first chain's first edge, and the row after
/// the last one that an edge lies in.
fn link(edges: &mut [AntialiasedEdge]) -> (u32, i32) {
    // The first edges of sorted lists; each list has at least twice as many chains as the one after it.
    let mut lists = Vec::<u32, { u32::BITS as usize }>::new();
    let (mut chains, mut begin, mut end_row) = (0u32, 0, i32::MIN);
    while let Some(edge) = edges.get_mut(begin as usize) {
        let (winding, others) = (edge.winding(), edge.count() - 1);
        let last_index = begin + others;
        let first = if winding > 0 { begin } else { last_index };
        if others == 0 {
            end_row = end_row.max(edge.end_row());
            edge.set_next_chain(NO_EDGE);
        } else {
            let lowest = get(edges, begin + last_index - first);
            end_row = end_row.max(lowest.map_or(end_row, AntialiasedEdge::end_row));
            set_next(edges, first, NO_EDGE);
            if let Some(second) = edges.get_mut(neighbour(first, winding) as usize) {
                second.set_edges_below(others - 1);
            }
        }
        let mut list = first;
        for _ in 0..chains.trailing_ones() {
            list = merge(edges, lists.pop().unwrap_or(NO_EDGE), list);
        }
        let pushed = lists.push(list);
        debug_assert!(pushed.is_ok(), "fewer than 2^32 chains have at most 32 lists");
        (chains, begin) = (chains + 1, last_index + 1);
    }
    let mut all = lists.pop().unwrap_or(NO_EDGE);
    while let Some(list) = lists.pop() {
        all = merge(edges, list, all);
    }
    (all, end_row)
}

/// A number that is negative where a corner is outside the domain of [`Sub8`]: no branch for each coordinate.
#[inline(always)]
fn sign_outside([x, y]: [i32; 2]) -> i32 {
    // Where one difference wraps, the coordinate is so far outside that the other one is negative.
    let sign = |units: i32| units.wrapping_sub(Sub8::MIN_UNITS) | Sub8::MAX_UNITS.wrapping_sub(units);
    sign(x) | sign(y)
}

/// The index so many edges further on in the table, or back. Modulo 2^32: an edge before the first one is none, but the one
/// behind that is the first again.
#[inline(always)]
pub(crate) const fn neighbour(index: u32, edges: i32) -> u32 {
    index.wrapping_add_signed(edges)
}

/// Merges two sorted lists of chains, each given by the index of its first edge.
fn merge(edges: &mut [AntialiasedEdge], one: u32, other: u32) -> u32 {
    let row = |edges: &[AntialiasedEdge], index: u32| first_row(edges, index);
    let (mut lower, mut upper) = if row(edges, one) <= row(edges, other) {
        (one, other)
    } else {
        (other, one)
    };
    let first = lower;
    while upper != NO_EDGE {
        let next = next(edges, lower);
        if next != NO_EDGE && row(edges, next) <= row(edges, upper) {
            lower = next;
        } else {
            set_next(edges, lower, upper);
            (lower, upper) = (upper, next);
        }
    }
    first
}

fn get(edges: &[AntialiasedEdge], index: u32) -> Option<&AntialiasedEdge> {
    edges.get(index as usize)
}

/// The first row of the edge at an index of the table; a row after all others where there is no edge.
#[inline(always)]
fn first_row(edges: &[AntialiasedEdge], index: u32) -> i32 {
    get(edges, index).map_or(i32::MAX, AntialiasedEdge::first_row)
}

/// The index of the first edge of the chain after one that begins with a given edge.
#[inline(always)]
fn next(edges: &[AntialiasedEdge], index: u32) -> u32 {
    get(edges, index).map_or(NO_EDGE, AntialiasedEdge::next_chain)
}

fn set_next(edges: &mut [AntialiasedEdge], index: u32, next: u32) {
    if let Some(edge) = edges.get_mut(index as usize) {
        edge.set_next_chain(next);
    }
}

impl<'e> Chains<'e> {
    /// The chains of a linked table, from the given first one on.
    #[inline(always)]
    pub(crate) fn new(edges: &'e [AntialiasedEdge], first: u32) -> Self {
        Self { edges, first }
    }

    /// The first row in which a chain begins that has not begun yet; after all rows where there is none.
    #[inline(always)]
    pub(crate) fn first_row(&self) -> i32 {
        first_row(self.edges, self.first)
    }

    /// The number of edges in the table.
    #[inline(always)]
    pub(crate) fn edges(&self) -> usize {
        self.edges.len()
    }

    /// The leftmost and the rightmost x of all edges, in 1/8192 pixel.
    pub(crate) fn ends(&self) -> [i32; 2] {
        let (mut left, mut right) = (i32::MAX, i32::MIN);
        let mut add = |x: i32| (left, right) = (left.min(x), right.max(x));
        for edge in self.edges {
            let [[top, _], [bottom, _]] = edge.ends();
            add(top);
            // Or else the top of the successor.
            if edge.is_last() {
                add(bottom);
            }
        }
        [left, right].map(fine)
    }

    /// Takes the next chain, if it begins in `row` or above: the first edge of it that does not end above the row, with
    /// its index.
    #[inline(always)]
    pub(crate) fn begin(&mut self, row: i32) -> Option<(u32, &'e AntialiasedEdge)> {
        loop {
            let index = self.first;
            let edge = get(self.edges, index).filter(|edge| edge.first_row() <= row)?;
            self.first = edge.next_chain();
            if edge.end_row() > row {
                return Some((index, edge));
            }
            let begun = self.search(row, index, edge);
            if begun.is_some() {
                return begun;
            }
        }
    }

    /// The first edge of a chain that does not end above `row`, with its index, from the chain's first edge, which
    /// does: a binary search, because in bands of one row most edges are skipped, time and again.
    #[inline(never)]
    fn search(&self, row: i32, index: u32, first: &AntialiasedEdge) -> Option<(u32, &'e AntialiasedEdge)> {
        let (second_index, second) = self.successor(index, first)?;
        // All edges of a chain have one winding.
        let winding = first.winding();
        let at = |offset: u32| {
            let index = neighbour(second_index, winding * offset as i32);
            Some((index, self.get(index)?))
        };
        // Offsets count from the second edge. All before `start` end above the row, all from `end` on below it.
        let edges = second.edges_below() + 1;
        let (mut start, mut end) = (0, edges);
        while start < end {
            let middle = (start + end) / 2;
            if at(middle)?.1.end_row() > row {
                end = middle;
            } else {
                start = middle + 1;
            }
        }
        if start < edges { at(start) } else { None }
    }

    /// The first edge of a chain, from any edge of it on, that does not end above `row`, with its index.
    fn skip_to(&self, row: i32, mut index: u32, mut edge: &'e AntialiasedEdge) -> Option<(u32, &'e AntialiasedEdge)> {
        while edge.end_row() <= row {
            (index, edge) = self.successor(index, edge)?;
        }
        Some((index, edge))
    }

    /// The edge that goes on where a given one ends, with its index.
    #[inline(always)]
    pub(crate) fn successor(&self, index: u32, edge: &AntialiasedEdge) -> Option<(u32, &'e AntialiasedEdge)> {
        if edge.is_last() {
            return None;
        }
        let successor = neighbour(index, edge.winding());
        Some((successor, get(self.edges, successor)?))
    }

    /// The edge at an index of the table.
    #[inline(always)]
    pub(crate) fn get(&self, index: u32) -> Option<&'e AntialiasedEdge> {
        get(self.edges, index)
    }

    /// Whether no row has more than `most` edges, as far as that is seen from edges that are a fixed number apart in their
    /// chain; `false` where it is not. Cost: two comparisons of rows an edge.
    pub(crate) fn have_at_most(&self, most: usize) -> bool {
        let (mut chains, mut first) = (0usize, self.first);
        while let Some(edge) = get(self.edges, first) {
            (chains, first) = (chains + 1, edge.next_chain());
        }
        // A row with more has more than that many of one chain, side by side in the table.
        let Some(apart) = most.checked_div(chains).filter(|&apart| apart > 0) else {
            return false;
        };
        let others = self.edges.get(apart..).unwrap_or_default();
        self.edges.iter().zip(others).all(|(edge, other)| {
            let is_below = edge.end_row() <= other.first_row() || other.end_row() <= edge.first_row();
            is_below || edge.winding() != other.winding()
        })
    }

    /// The most edges that lie in one row. `begun` has room for as many numbers as there are edges. Cost: as many steps
    /// as there are pairs of an edge and a chain in a row, once a polygon.
    pub(crate) fn most_active(mut self, begun: &mut VecView<u32>) -> usize {
        begun.clear();
        let (mut most, mut row) = (0, self.first_row());
        // The number grows only where an edge begins.
        while row < i32::MAX {
            while let Some((index, _)) = self.begin(row) {
                let pushed = begun.push(index);
                debug_assert!(pushed.is_ok(), "there is room for as many numbers as edges");
            }
            let (mut active, mut next_row) = (0usize, self.first_row());
            begun.retain_mut(|index| {
                let edge = self.get(*index);
                let Some((first, edge)) = edge.and_then(|edge| self.skip_to(row, *index, edge)) else {
                    return false;
                };
                *index = first;
                active += 1;
                let (mut last, mut edge) = (first, edge);
                while let Some((successor, next)) = self.successor(last, edge) {
                    if next.first_row() > row {
                        next_row = next_row.min(next.first_row());
                        break;
                    }
                    active += 1;
                    (last, edge) = (successor, next);
                }
                true
            });
            (most, row) = (most.max(active), next_row);
        }
        most
    }
}
