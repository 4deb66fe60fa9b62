//! Which samples of a pixel a shape covers: coverage as a mask, for multisampling.
//!
//! A sample belongs to the inside by the rule of the centre of a pixel: on a top or left edge it does, on a bottom or
//! right edge it does not. Edges are rounded to 1/8192 pixel, so a sample nearer than that to an edge may count as being on
//! its other side. Polygons that share an edge round it alike: they share no sample, and leave none out.

use core::ops::Range;

use crate::{
    coverage::{CoverageMethod, edges::RowSegment},
    scan::polygon::scanline_polygon::FillRule,
};

/// A method that takes samples, all of them alike: [`Rooks`](crate::coverage::Rooks), and grids of 2 x 2
/// and 4 x 4.
///
/// Polygons that share an edge share no sample of it, and leave none out. A sample nearer than 1/8192 pixel to an edge may
/// count as being on its other side, because edges are rounded.
pub trait SamplePattern: CoverageMethod + Default {
    /// Samples of a pixel: 4, 8 or 16.
    const SAMPLES: usize;

    /// Where the samples are: column and row in 1/256 pixel from the corner of the pixel, sample 0 first.
    fn positions() -> impl Iterator<Item = [i32; 2]>;

    /// Hands over spans as [`CoverageMethod::cover_row`] does, with a mask for each instead of a coverage: bit `n`
    /// stands for sample `n`.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    fn sample_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [Self::Cell],
        emit: impl FnMut(Range<i32>, u32) -> Result<(), E>,
    ) -> Result<(), E>;
}

/// Hands over the spans of a row: `flips` takes the bits that change at a pixel, and leaves none there. The columns are those
/// that [`with_room`](crate::coverage::with_room) leaves.
#[inline]
pub(crate) fn spans<E>(
    columns: Range<i32>,
    mut flips: impl FnMut(usize) -> u32,
    mut emit: impl FnMut(Range<i32>, u32) -> Result<(), E>,
) -> Result<(), E> {
    let (mut bits, mut start, mut emitted) = (0u32, columns.start, Ok(()));
    for (index, column) in columns.clone().enumerate() {
        let changed = flips(index);
        if changed == 0 {
            continue;
        }
        // The loop goes on after an error, so that no bit stays.
        if emitted.is_ok() && bits != 0 && start < column {
            emitted = emit(start..column, bits);
        }
        bits ^= changed;
        start = column;
    }
    if emitted.is_ok() && bits != 0 && start < columns.end {
        emitted = emit(start..columns.end, bits);
    }
    emitted
}
