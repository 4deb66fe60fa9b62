//! Walking y-monotone chains down to a row of pixels: each chain has one entry in a table, however many of its edges lie in the
//! row.
//!
//! ```text
//!   row top  ---o--------------      an entry stands for the edge that passes the row's bottom: here C; the parts of A, B and
//!                \ A                 C in the row are handed over one by one, and the next row goes on along C
//!                 o
//!            B   /
//!               o
//!                `. C
//!   bottom   ------`.----------
//! ```
//!
//! Guarantees: the parts of an edge begin and end at the x at which its [`RowSegment`]s do. Cost: two divisions for each edge
//! that passes from row to row, none for any other.

use crate::coverage::edges::{
    AntialiasedEdge, RowSegment, Y_ONE,
    antialiased_edge::fine,
    monotone_chains::{Chains, neighbour},
    row_segment::COVER_SHIFT,
};

/// A row of pixels that chains are walked down to.
#[derive(Debug, Copy, Clone)]
pub(crate) struct ChainWalk {
    row: i32,
    /// y of the row's bottom, in 1/256 pixel.
    row_bottom: i32,
}

/// Takes the parts of edges that lie in a row of pixels, such as an accumulation buffer, which adds their cells up.
pub(crate) trait PartSink {
    /// Takes a part of an edge: x at its top and at its bottom, in 1/8192 pixel, and its height in 1/16384 pixel, negative
    /// where the outline goes up.
    fn add_part(&mut self, ends: (i32, i32), height: i32);
}

impl ChainWalk {
    #[inline(always)]
    pub(crate) fn to(row: i32) -> Self {
        Self {
            row,
            row_bottom: (row + 1) * Y_ONE,
        }
    }

    /// Whether the edge of an entry passes the row's bottom, so that it has one part in the row, from top to bottom.
    #[inline(always)]
    fn is_passed_by(&self, entry: &RowSegment) -> bool {
        entry.end_y() > self.row_bottom
    }

    /// Hands over the parts in the row of a chain that has an entry. Returns whether the chain goes on below; then the entry
    /// stands for the edge that does.
    #[inline(always)]
    pub(crate) fn step_down(&self, chains: &Chains<'_>, entry: &mut RowSegment, parts: &mut impl PartSink) -> bool {
        if !self.is_passed_by(entry) {
            return self.go_on(chains, entry, parts);
        }
        let ends = entry.step_bottom();
        parts.add_part(ends, signed(Y_ONE, entry.winding));
        true
    }

    /// Hands over the parts in the row of a chain whose edge ends in it or ended at its top. Returns whether the chain goes on
    /// below; then the entry stands for the edge that does.
    #[inline]
    fn go_on(&self, chains: &Chains<'_>, entry: &mut RowSegment, parts: &mut impl PartSink) -> bool {
        let height = entry.end_y() - self.row_bottom + Y_ONE;
        let index = entry.edge_index();
        let Some(edge) = chains.get(index) else { return false };
        if height > 0 {
            parts.add_part((entry.x_bottom, edge.ends_x()[1]), signed(height, entry.winding));
        }
        let successor = chains.successor(index, edge);
        successor.is_some_and(|(index, edge)| self.enter(chains, entry, index, edge, parts))
    }

    /// Hands over the parts in the row of a chain that begins in it or above, by an edge with a part in the row. Returns the
    /// chain's entry, if the chain goes on below.
    #[inline(never)]
    pub(crate) fn begin<'e>(
        &self,
        chains: &Chains<'e>,
        mut index: u32,
        mut edge: &'e AntialiasedEdge,
        parts: &mut impl PartSink,
    ) -> Option<RowSegment> {
        let mut entry = edge.chain_top();
        if edge.first_row() < self.row {
            entry = edge.begin_at(index, self.row);
            parts.add_part((entry.x_top, entry.x_bottom), entry.signed_height());
            if entry.end_y() > self.row_bottom {
                return Some(entry);
            }
            (index, edge) = chains.successor(index, edge)?;
        }
        self.enter(chains, &mut entry, index, edge, parts).then_some(entry)
    }

    /// Hands over the parts in the row of a chain, from an edge on that begins inside the row or below it. Returns whether the
    /// chain goes on below the row; then the entry stands for the edge that does.
    #[inline(never)]
    fn enter<'e>(
        &self,
        chains: &Chains<'e>,
        entry: &mut RowSegment,
        mut index: u32,
        mut edge: &'e AntialiasedEdge,
        parts: &mut impl PartSink,
    ) -> bool {
        let winding = entry.winding;
        let [[x, mut y], _] = edge.ends();
        let mut x = fine(x);
        loop {
            let [_, [x_end, y_end]] = edge.ends();
            if y_end > self.row_bottom {
                break;
            }
            let x_end = fine(x_end);
            parts.add_part((x, x_end), signed(y_end - y, winding));
            if edge.is_last() {
                return false;
            }
            (x, y) = (x_end, y_end);
            index = neighbour(index, winding);
            let Some(successor) = chains.get(index) else {
                return false;
            };
            edge = successor;
        }
        let height = self.row_bottom - y;
        if height > 0 {
            let ends = edge.step_bottom_along(entry, index, height);
            parts.add_part(ends, signed(height, winding));
        } else {
            // As if the edge above had ended at the bottom of this row.
            entry.wait_for_successor(neighbour(index, -winding), y);
        }
        true
    }
}

/// A height in 1/256 pixel, with the sign of a winding number, in 1/16384 pixel.
#[inline(always)]
pub(crate) fn signed(height: i32, winding: i32) -> i32 {
    (height << COVER_SHIFT) * winding
}
