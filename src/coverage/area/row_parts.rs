//! The area of the shape in each pixel of a row, from a few parts of edges that come in any order.
//!
//! ```text
//!     \               |
//!      \              |        three parts: the upper and the lower edge of a chain on the left, and an edge on the right;
//!       o             |        the lower one begins in the pixel in which the upper one ends, so that each is swept by itself
//!        `.           |
//! ```
//!
//! Parts are put into order by their left ends when they come. Those that share pixels are swept through the accumulation
//! buffer, and so are all of them where they are too many for the list.
//!
//! Guarantees: bit for bit the pixels of the same parts as segments, because both add the same cells.

use core::ops::Range;

use heapless::Vec;

use crate::coverage::{
    Coverage, Emit,
    area::{
        accumulation_buffer::AccumulationBuffer,
        sparse_row::{ColumnSides, CurrentCell, sweep_cluster},
    },
    edges::{X_BITS, chain_walk::PartSink},
};

/// A part of an edge: its left and its right end in 1/8192 pixel, and the height that it counts with, in 1/16384 pixel.
#[derive(Copy, Clone, Default)]
struct Part {
    ends: [i32; 2],
    height: i32,
}

/// The most parts that are kept in order.
const MOST: usize = 8;

/// No columns: the first one is right of all others.
const NOWHERE: [i32; 2] = [i32::MAX, i32::MIN];

/// The parts of edges in a row.
pub(super) struct RowParts<'c> {
    parts: Vec<Part, MOST>,
    buffer: AccumulationBuffer<'c>,
    /// The columns in which the first and the last part lie that went into the buffer because they were too many.
    in_buffer: [i32; 2],
}

impl<'c> RowParts<'c> {
    /// No parts yet, and the columns that are drawn, with a cell for each and one more.
    #[inline(always)]
    pub(super) fn new(columns: &Range<i32>, cells: &'c mut [i32]) -> Self {
        Self {
            parts: Vec::new(),
            buffer: AccumulationBuffer::of(columns.clone(), cells),
            in_buffer: NOWHERE,
        }
    }

    /// Puts all parts into the buffer.
    #[cold]
    fn empty_into_buffer(&mut self) {
        let ([first, last], [start, end]) = (self.in_buffer, add_all(&self.parts, &mut self.buffer));
        self.in_buffer = [first.min(start), last.max(end)];
        self.parts.clear();
    }

    /// Emits the spans of the row, and takes all parts out.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    #[inline(never)]
    pub(super) fn cover<E>(
        &mut self,
        sides: ColumnSides,
        coverage: impl Fn(i32) -> Coverage,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        let swept = self.sweep(sides, coverage, emit);
        if swept.is_err() {
            self.buffer.clear();
        }
        self.parts.clear();
        swept
    }

    /// Emits the spans of the row. The buffer is empty afterwards, but not after an error.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    #[inline(always)]
    fn sweep<E>(
        &mut self,
        sides: ColumnSides,
        coverage: impl Fn(i32) -> Coverage,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        let mut current = CurrentCell::NOTHING;
        if self.in_buffer != NOWHERE {
            self.empty_into_buffer();
            let columns = core::mem::replace(&mut self.in_buffer, NOWHERE);
            current = sweep_cluster(columns, &mut self.buffer, current, &coverage, emit)?;
        }
        let mut parts = self.parts.as_slice();
        while let [part, others @ ..] = parts {
            let Part { ends, height } = *part;
            let ends_before = |next: &Part| ends[1] >> X_BITS <= next.ends[0] >> X_BITS;
            if others.first().is_none_or(ends_before) && ends.into_iter().all(|x| sides.are_around(x)) {
                current.go_to(ends[0] >> X_BITS, &coverage, emit)?;
                current.pass(ends, height, &coverage, emit)?;
                parts = others;
            } else {
                let (cluster, others) = parts.split_at_checked(overlapping(parts)).unwrap_or_default();
                let columns = add_all(cluster, &mut self.buffer);
                current = sweep_cluster(columns, &mut self.buffer, current, &coverage, emit)?;
                parts = others;
            }
        }
        current.emit_pixel(coverage, emit)
    }
}

impl PartSink for RowParts<'_> {
    #[inline(always)]
    fn add_part(&mut self, (top, bottom): (i32, i32), height: i32) {
        let ends = [top.min(bottom), top.max(bottom)];
        if self.parts.is_full() {
            self.empty_into_buffer();
        }
        let mut part = Part { ends, height };
        if self.parts.last().is_some_and(|last| last.ends[0] > ends[0]) {
            // Each of those further right moves on by one.
            for other in &mut self.parts {
                if other.ends[0] > part.ends[0] {
                    core::mem::swap(other, &mut part);
                }
            }
        }
        let pushed = self.parts.push(part);
        debug_assert!(pushed.is_ok(), "room was made");
    }
}

/// How many of the first parts share pixels, so that none of them can be swept by itself; one at least.
#[inline(never)]
fn overlapping(parts: &[Part]) -> usize {
    let mut last = None;
    let share = parts.iter().take_while(|Part { ends: [start, end], .. }| {
        let shares = last.is_none_or(|last| start >> X_BITS < last);
        last = last.max(Some(end >> X_BITS));
        shares
    });
    share.count()
}

/// Adds the cells of parts to the buffer. Returns the columns of their leftmost and their rightmost end.
#[inline(never)]
fn add_all(parts: &[Part], buffer: &mut AccumulationBuffer<'_>) -> [i32; 2] {
    parts.iter().fold(NOWHERE, |[first, last], part| {
        let [start, end] = part.ends;
        buffer.add(start, end, part.height);
        [first.min(start >> X_BITS), last.max(end >> X_BITS)]
    })
}
