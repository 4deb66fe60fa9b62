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
    edges::{RowSegment, Rows, chain_walk::ChainWalk},
    sweep::sweep,
};

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
    let mut buffer = if pixels < chains.edges().saturating_mul(PIXELS_PER_EDGE) {
        let (columns, cells) = in_room(columns, cells);
        AccumulationBuffer::of(columns, cells)
    } else {
        AccumulationBuffer::between(chains.ends(), columns, cells)
    };
    let mut row = chains.first_row().max(rows.start);
    while row < rows.end {
        let walk = ChainWalk::to(row);
        let mut index = 0usize;
        while let Some(edge) = begun.get_mut(index) {
            if walk.step_down(&chains, edge, &mut buffer) {
                index += 1;
            } else {
                swap_remove(begun, index);
            }
        }
        while let Some((first, edge)) = chains.begin(row) {
            if let Some(entry) = walk.begin(&chains, first, edge, &mut buffer) {
                push(begun, entry);
            }
        }
        let x = buffer.columns.start;
        let swept = sweep(
            buffer.visible_differences(),
            x,
            Wrapping(0),
            &coverage,
            &mut emit.row(row),
        );
        if let Err(error) = swept {
            buffer.clear();
            return Err(error);
        }
        row = if begun.is_empty() { chains.first_row() } else { row + 1 };
    }
    buffer.clear();
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
