//! Antialiasing: how much of a pixel a shape covers.
//!
//! A coverage method is one file with the signature of [`CoverageMethod`]: the edges of one row of pixels in, spans with their
//! coverage out, integers only, in memory for one row that the caller lends. In 1/255 of a pixel, over the pixels that an edge
//! crosses:
//!
//! | method | how | row of 320 pixels | when |
//! |---|---|---|---|
//! | [`CentreSample`] (T0) | the centre of the pixel | 0 | 3D, and edges along the pixels |
//! | [`Rooks<4>`](Rooks) (T1) | 4 samples, one in each row and column | 160 B | where samples carry more than coverage, such as depth |
//! | [`Rooks<8>`](Rooks), [`Rooks<16>`](Rooks) (T1b) | 8 or 16 samples | 320, 640 B | many edges, little memory |
//! | [`SubScanlines`] (T2) | 4 rows of the pixel, exact in x | 642 B | crossing edges, nonzero rule |
//! | [`SignedArea`] (T3) | the exact area, one difference a pixel | 1,284 B | the default for 2D |
//! | [`InsideArea`] (T4) | the exact area, sides told apart where edges cross | 1,284 B | right everywhere |
//! | [`Grid`] | n x n samples, weighted | 642 B | the textbook's baseline |
//!
//! A coverage is a `u8`: 0 is nothing of a pixel, 255 all of it.
//!
//! Conservation: what two polygons on either side of an edge cover adds up to the whole pixel, within the rounding of a
//! coverage, by [`SignedArea`] and [`InsideArea`] (but where edges cross inside a pixel); by [`CentreSample`] and the other
//! sampling methods exactly.
//!
//! A pixel's coverage is a function of the outline and the pixel: windows and bands cut a picture without changing a pixel, by
//! every method.
//!
//! Samples and sub-scanlines meet an edge where it is rounded to: the positions at which it enters and leaves the row of
//! pixels to the nearest 1/8192 pixel, and the one between them, at the height of the samples, once more. Together that is
//! less than 1/8192 pixel, so a sample nearer than that to an edge may count as being on its other side; every other sample
//! is inside or outside by exact arithmetic.
//!
//! Where samples carry a colour each, a [`SamplePattern`] says which of them are covered: multisampling
//! ([`Band::multisample`](crate::band::Band::multisample)).
//!
//! Beside these methods, [`FilteredLine`](crate::draw::FilteredLine) (L, Gupta and Sproull) filters lines one pixel wide.

// Why small functions are `inline(always)`, measured on a Cortex-M4 with `inline` alone: in `area`, signed areas take up to 27
// % more instructions (near-vertical triangles); in `sweep`, a panel of instruments without a picture 4.7 %; in
// `monotone_chains`, rings of many edges 1.1 %; here and in `RowSegment::x_at`, four samples 3.1 % and sixteen rooks 1.4 %.

mod any_coverage;
mod area;
pub(crate) mod edges;
mod emit;
mod line;
#[cfg(test)]
mod rows_tests;
mod samples;
mod sweep;

pub use any_coverage::AnyCoverage;
pub(crate) use area::{
    AREA_BITS, Cell, Combination, CombinedArea, Mirror, RowParts, UnorderedRow, for_each_visible_cell, in_room,
};
pub use area::{InsideArea, SignedArea};
pub(crate) use edges::{COVER_BITS, RowSegment, Rows, X_BITS, X_ONE};
pub(crate) use emit::{ByReference, Emit, EmitRows};
pub(crate) use line::FilteredSegment;
pub use samples::{Bartlett, BoxFilter, CentreSample, Gaussian, Grid, Rooks, SamplePattern, SubScanlines};

use core::ops::Range;

use crate::{
    geometry::{Sub8, SubPixel},
    scan::polygon::scanline_polygon::FillRule,
};

/// How much of a pixel is covered: 0 is nothing, 255 all of it.
pub(crate) type Coverage = u8;

/// A coverage method: from the edges in a row of pixels to the coverage of each pixel.
///
/// Shapes call a method row by row, in a form that may change: programs choose one, lend it the cells of a row, and hand it to
/// what they draw, such as [`AntialiasedPolygon`](crate::draw::AntialiasedPolygon). No program implements one.
pub trait CoverageMethod {
    /// The type of an entry of the row memory.
    type Cell: Copy + Default + core::fmt::Debug;

    /// Number of cells that a row of `width` pixels takes.
    fn cells(width: usize) -> usize;

    /// Hands over the pixels of `columns` that have coverage, in spans of the same coverage, left to right, each pixel at
    /// most once.
    ///
    /// The segments come from left to right by their left ends; they may be put into another order.
    ///
    /// The cells are [`cells`](Self::cells) of the columns' number or more, all of them 0, and are so again afterwards.
    /// With fewer, columns on the right are left out.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    // `emit` by value: behind a reference, sampling methods take up to 5 % more instructions (Cortex-M0+).
    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [Self::Cell],
        emit: impl Emit<E>,
    ) -> Result<(), E>;

    /// Hands over the pixels of all rows of an outline: [`cover_row`](Self::cover_row) for each of them, unless a method
    /// knows how to do without the segments.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    #[inline(always)]
    fn cover_rows<E>(
        &self,
        rows: Rows<'_>,
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [Self::Cell],
        emit: &mut impl EmitRows<E>,
    ) -> Result<(), E> {
        rows.for_each(|y, segments| self.cover_row(segments, fill_rule, columns.clone(), cells, emit.row(y)))
    }
}

/// The farthest first column from which the distance to any edge in the domain of [`Sub8`], in 1/8192 pixel, is in the number
/// range.
const FARTHEST: i32 = i32::MAX / X_ONE - (Sub8::MAX_UNITS >> Sub8::FRACTION_BITS) - 1;

/// The first columns, as many as row memory has room for pixels; none where columns are reversed, or begin so far away from
/// all outlines, which lie in the domain of [`Sub8`], that no row memory reaches one.
#[inline(always)]
fn with_room(columns: &Range<i32>, pixels: usize) -> Range<i32> {
    if columns.start.unsigned_abs() > FARTHEST.unsigned_abs() {
        return 0..0;
    }
    let count = (columns.end.saturating_sub(columns.start).max(0) as usize).min(pixels);
    // At most from start to end, so that the sum is in the number range.
    columns.start..columns.start + count as i32
}
