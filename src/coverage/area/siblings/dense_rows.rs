//! The area of a shape of many short edges: the cells of each edge go into the accumulation buffer as soon as they are made.
//!
//! ```text
//!   chain A   o                      Nothing is sorted, because areas add up in any order, and the few pixels between edges are
//!   row -------\---------            swept like all others. A chain has one entry in the table of active chains, however many
//!               o                    of its edges lie in a row: all of them go into the buffer, one after the other, and the
//!             .'  o                  last one waits in the entry for the next row.
//!   row ----.'-------\---
//! ```
//!
//! Guarantees: bit for bit the pixels of the rows from segments, because both add the same cells. Cost: about 30 instructions
//! an edge and row, and one a pixel of the row. Prefer it where there are few pixels for the number of edges (glyphs).
//!
//! Source: font-rs (Levien 2016).

use core::{num::Wrapping, ops::Range};

use heapless::VecView;

use crate::coverage::{
    Coverage, EmitRows,
    area::accumulation_buffer::{AccumulationBuffer, in_room},
    edges::{
        AntialiasedEdge, COVER_BITS, RowSegment, Rows, Y_BITS, Y_ONE,
        antialiased_edge::fine,
        monotone_chains::{Chains, neighbour},
    },
    sweep::sweep,
};

/// Shift from 1/256 pixel to 1/16384 pixel.
const COVER_SHIFT: u32 = COVER_BITS - Y_BITS;

/// With fewer pixels an edge, looking for the leftmost and the rightmost x of all edges takes longer than sweeping the pixels
/// where no shape is.
const PIXELS_PER_EDGE: usize = 8;

/// Hands over the spans of all rows. The table has room for all edges in one row.
///
/// # Errors
/// The first error that `emit` returns.
#[inline(never)]
pub(in crate::coverage::area) fn cover<E>(
    rows: Rows<'_>,
    columns: &Range<i32>,
    cells: &mut [i32],
    coverage: impl Fn(i32) -> Coverage,
    emit: &mut impl EmitRows<E>,
) -> Result<(), E> {
    let Rows {
        mut chains,
        segments: begun,
        rows,
        height,
    } = rows;
    begun.clear();
    let pixels = height.saturating_mul(columns.len());
    let buffer = if pixels < chains.edges().saturating_mul(PIXELS_PER_EDGE) {
        let (columns, cells) = in_room(columns, cells);
        AccumulationBuffer::of(columns, cells)
    } else {
        AccumulationBuffer::between(chains.ends(), columns, cells)
    };
    let mut active = DenseRow {
        buffer,
        row: 0,
        row_bottom: 0,
    };
    let mut row = chains.first_row().max(rows.start);
    while row < rows.end {
        active.row = row;
        active.row_bottom = (row + 1) * Y_ONE;
        let mut index = 0usize;
        while let Some(edge) = begun.get_mut(index) {
            if active.step_down(&chains, edge) {
                index += 1;
            } else {
                swap_remove(begun, index);
            }
        }
        while let Some((first, edge)) = chains.begin(row) {
            active.begin(&chains, first, edge, begun);
        }
        let x = active.buffer.columns.start;
        let swept = sweep(
            active.buffer.visible_differences(),
            x,
            Wrapping(0),
            &coverage,
            &mut emit.row(row),
        );
        if let Err(error) = swept {
            active.buffer.clear();
            return Err(error);
        }
        row = if begun.is_empty() { chains.first_row() } else { row + 1 };
    }
    active.buffer.clear();
    Ok(())
}

/// Adds a segment to the table, which has room for all chains of a row.
fn push(segments: &mut VecView<RowSegment>, segment: RowSegment) {
    let pushed = segments.push(segment);
    debug_assert!(pushed.is_ok(), "there is room for all chains of a row");
}

/// Replaces a segment by the last one of the table. (The `swap_remove` of `heapless` panics where there is none, which
/// the compiler cannot rule out.)
#[inline]
fn swap_remove(segments: &mut VecView<RowSegment>, index: usize) {
    if let Some(last) = segments.pop() {
        if let Some(ended) = segments.get_mut(index) {
            *ended = last;
        }
    }
}

/// The row of pixels whose edges are added.
struct DenseRow<'c> {
    buffer: AccumulationBuffer<'c>,
    row: i32,
    /// y of the row's bottom, in 1/256 pixel.
    row_bottom: i32,
}

impl DenseRow<'_> {
    /// Adds the edges of an active chain in the row. Returns whether the chain goes on below.
    // Always: with `inline` alone a star in 16 x 16 pixels takes 9.9 % more instructions, a ring 1.5 % (x86-64).
    #[inline(always)]
    fn step_down(&mut self, chains: &Chains<'_>, segment: &mut RowSegment) -> bool {
        if segment.end_y() > self.row_bottom {
            let ends = segment.step_bottom();
            self.add(ends, Y_ONE, segment.winding);
            return true;
        }
        let height = segment.end_y() - self.row_bottom + Y_ONE;
        let index = segment.edge_index();
        let Some(edge) = chains.get(index) else { return false };
        if height > 0 {
            self.add((segment.x_bottom, edge.ends_x()[1]), height, segment.winding);
        }
        let successor = chains.successor(index, edge);
        successor.is_some_and(|(index, edge)| self.enter(chains, segment, index, edge))
    }

    /// Adds the edges of a chain that begins in the row or above it, and makes the chain an active one if it goes on below.
    #[inline(never)]
    fn begin<'e>(
        &mut self,
        chains: &Chains<'e>,
        mut index: u32,
        mut edge: &'e AntialiasedEdge,
        begun: &mut VecView<RowSegment>,
    ) {
        let mut segment = edge.chain_top();
        if edge.first_row() < self.row {
            segment = edge.begin_at(index, self.row);
            self.add((segment.x_top, segment.x_bottom), segment.y_bottom, segment.winding);
            if segment.end_y() > self.row_bottom {
                push(begun, segment);
                return;
            }
            let Some(successor) = chains.successor(index, edge) else {
                return;
            };
            (index, edge) = successor;
        }
        if self.enter(chains, &mut segment, index, edge) {
            push(begun, segment);
        }
    }

    /// Adds the edges in the row, from a given one of a chain on, which begins inside the row or below it. Returns whether the
    /// chain goes on below the row; then the segment stands for the edge that does.
    #[inline(never)]
    fn enter<'e>(
        &mut self,
        chains: &Chains<'e>,
        segment: &mut RowSegment,
        mut index: u32,
        mut edge: &'e AntialiasedEdge,
    ) -> bool {
        let winding = segment.winding;
        let [[x, mut y], _] = edge.ends();
        let mut x = fine(x);
        loop {
            let [_, [x_end, y_end]] = edge.ends();
            if y_end > self.row_bottom {
                break;
            }
            let x_end = fine(x_end);
            self.add((x, x_end), y_end - y, winding);
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
            let ends = edge.step_bottom_along(segment, index, height);
            self.add(ends, height, winding);
        } else {
            // As if the edge above had ended at the bottom of this row.
            segment.wait_for_successor(neighbour(index, -winding), y);
        }
        true
    }

    /// Adds a part of an edge between two x in 1/8192 pixel, `height` in 1/256 pixel.
    #[inline]
    fn add(&mut self, (x_top, x_bottom): (i32, i32), height: i32, winding: i32) {
        self.buffer.add(x_top, x_bottom, (height << COVER_SHIFT) * winding);
    }
}
