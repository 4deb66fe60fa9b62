//! The signed areas of one row whose edges come in any order: their cells go into the accumulation buffer as they are made.
//!
//! ```text
//!   edges of a glyph in a row      \  (   |     |    /        added as the contours have them: nothing is sorted or kept
//!   buffer                       0 3 9 1 0 -4 .. 0 -2 ..      swept once, from left to right
//! ```
//!
//! Guarantees: bit for bit the pixels of [`SignedArea`](crate::coverage::SignedArea), because both add the same cells. Cost: about 30
//! instructions an edge that begins and ends in the row, 100 and up to two divisions for any other, and one a pixel of the
//! row. Prefer it where edges are not kept from row to row.
//!
//! Source: font-rs (Levien 2016).

use core::ops::Range;

use crate::coverage::{
    Emit,
    area::accumulation_buffer::{AccumulationBuffer, coverage_of_size, in_room},
    edges::{AntialiasedEdge, COVER_BITS, Y_BITS, Y_ONE, antialiased_edge::fine, from_corner},
    sweep::sweep_row,
};

/// Shift from 1/256 pixel to 1/16384 pixel.
const COVER_SHIFT: u32 = COVER_BITS - Y_BITS;

/// A row to which edges are added.
pub(crate) struct UnorderedRow<'c> {
    buffer: AccumulationBuffer<'c>,
    row: i32,
}

impl<'c> UnorderedRow<'c> {
    /// Some columns of a row without edges, or as many of the first ones as there are cells for: one for each, and one more. The
    /// cells are 0, as they are again after [`finish`](Self::finish).
    #[inline(always)]
    pub(crate) fn new(row: i32, columns: &Range<i32>, cells: &'c mut [i32]) -> Self {
        let (columns, cells) = in_room(columns, cells);
        Self {
            buffer: AccumulationBuffer::of(columns, cells),
            row,
        }
    }

    /// Adds what an edge has in the row, which it must have a part in, between two corners in 1/256 pixel from the centre of pixel
    /// (0, 0).
    #[inline(always)]
    pub(crate) fn add(&mut self, from: [i32; 2], to: [i32; 2]) {
        let ([from_x, from_y], [to_x, to_y]) = (from_corner(from), from_corner(to));
        let top = self.row * Y_ONE;
        let is_within = |y: i32| top <= y && y <= top + Y_ONE;
        if is_within(from_y) && is_within(to_y) {
            // Which end is the upper one does not matter to an area.
            self.buffer
                .add(fine(from_x), fine(to_x), (to_y - from_y) << COVER_SHIFT);
        } else {
            self.add_passing(from, to);
        }
    }

    /// Adds an edge that begins or ends in another row.
    #[inline(never)]
    fn add_passing(&mut self, from: [i32; 2], to: [i32; 2]) {
        if let Some(edge) = AntialiasedEdge::from_units(from, to) {
            let segment = edge.begin_at(0, self.row);
            self.buffer
                .add(segment.x_top, segment.x_bottom, segment.signed_height());
        }
    }

    /// Hands over the pixels that have coverage by the nonzero rule, in spans of equal coverage from left to right.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    #[inline(always)]
    pub(crate) fn finish<E>(self, emit: &mut impl Emit<E>) -> Result<(), E> {
        let AccumulationBuffer { cells, columns, .. } = self.buffer;
        sweep_row(columns, cells, |sum| coverage_of_size(sum.unsigned_abs()), emit)
    }
}
