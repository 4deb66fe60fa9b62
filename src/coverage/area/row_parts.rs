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

/// No columns.
const NOWHERE: [i16; 2] = [i16::MAX, i16::MIN];

/// The parts of edges in a row.
pub(crate) struct RowParts<'c> {
    parts: Vec<Part, MOST>,
    pub(super) buffer: AccumulationBuffer<'c>,
    /// The columns in which the first and the last part lie that went into the buffer because they were too many.
    in_buffer: [i16; 2],
}

impl<'c> RowParts<'c> {
    /// No parts yet, and the columns that are drawn, with a cell for each and one more.
    #[inline(always)]
    pub(crate) fn new(columns: &Range<i32>, cells: &'c mut [i32]) -> Self {
        Self {
            parts: Vec::new(),
            buffer: AccumulationBuffer::of(columns.clone(), cells),
            in_buffer: NOWHERE,
        }
    }

    /// Puts a part between the others, or makes room for it.
    #[inline(never)]
    fn insert(&mut self, mut part: Part) {
        if self.parts.is_full() {
            self.empty_into_buffer();
        }
        // Each of those further right moves on by one.
        for other in &mut self.parts {
            if other.ends[0] > part.ends[0] {
                core::mem::swap(other, &mut part);
            }
        }
        let pushed = self.parts.push(part);
        debug_assert!(pushed.is_ok(), "room was made");
    }

    /// Puts all parts into the buffer.
    #[cold]
    fn empty_into_buffer(&mut self) {
        let columns = add_all(&self.parts, &mut self.buffer);
        self.parts.clear();
        let [start, end] = around(self.in_buffer, columns);
        // In the domain, whose columns fit 16 bits.
        self.in_buffer = [start as i16, end as i16];
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
        self.cover_but_last(sides, &coverage, emit)?.emit_pixel(coverage, emit)
    }

    /// Emits the spans of the row but for the last pixel, whose cell is returned, and takes all parts out.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    #[inline(always)]
    pub(super) fn cover_but_last<E>(
        &mut self,
        sides: ColumnSides,
        coverage: impl Fn(i32) -> Coverage,
        emit: &mut impl Emit<E>,
    ) -> Result<CurrentCell, E> {
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
    ) -> Result<CurrentCell, E> {
        let mut current = CurrentCell::NOTHING;
        let mut parts = self.parts.as_slice();
        while let [part, others @ ..] = parts {
            let Part { ends, height } = *part;
            let ends_before = |next: &Part| ends[1] >> X_BITS <= next.ends[0] >> X_BITS;
            let is_alone = others.first().is_none_or(ends_before) && self.in_buffer == NOWHERE;
            if is_alone && sides.are_around(ends) {
                current.go_to(ends[0] >> X_BITS, &coverage, emit)?;
                current.pass(ends, height, &coverage, emit)?;
                parts = others;
                continue;
            }
            let in_buffer = core::mem::replace(&mut self.in_buffer, NOWHERE);
            let in_cluster = if in_buffer == NOWHERE {
                overlapping(parts)
            } else {
                parts.len()
            };
            let (cluster, others) = parts.split_at_checked(in_cluster).unwrap_or_default();
            let columns = around(in_buffer, add_all(cluster, &mut self.buffer));
            current = sweep_cluster(columns, &mut self.buffer, current, &coverage, emit)?;
            parts = others;
        }
        Ok(current)
    }
}

impl PartSink for RowParts<'_> {
    #[inline]
    fn add_part(&mut self, (top, bottom): (i32, i32), height: i32) {
        let part = Part {
            ends: [top.min(bottom), top.max(bottom)],
            height,
        };
        let is_last = self.parts.last().is_none_or(|last| last.ends[0] <= part.ends[0]);
        if !is_last || self.parts.push(part).is_err() {
            self.insert(part);
        }
    }
}

/// The number of parts of edges, at the beginning of a list in order of left ends, of which each shares a pixel with one before
/// it, so that their cells have to be added up before they are swept; at least 1.
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

/// From the first to the last of some columns and others.
fn around([start, end]: [i16; 2], [first, last]: [i32; 2]) -> [i32; 2] {
    [first.min(start.into()), last.max(end.into())]
}

/// Adds the cells of parts to the buffer. Returns the columns of their leftmost and their rightmost end.
#[inline(never)]
fn add_all(parts: &[Part], buffer: &mut AccumulationBuffer<'_>) -> [i32; 2] {
    parts.iter().fold([i32::MAX, i32::MIN], |[first, last], part| {
        let [start, end] = part.ends;
        buffer.add(start, end, part.height);
        [first.min(start >> X_BITS), last.max(end >> X_BITS)]
    })
}
