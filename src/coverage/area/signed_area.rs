//! The exact area of the shape in each pixel, from the signed areas right of its edges.
//!
//! Each edge makes a cell in every pixel that it passes: `cover`, what it adds to all pixels to the right, and `area`, what its
//! own pixel lacks of that, both negative where the outline goes up. Summed up from left to right, cover is the winding number
//! times the height of a row, and cover - area is the area of the shape in the pixel. Edges that are disjoint from their
//! neighbours are swept at once; where edges share pixels, their cells meet in an accumulation buffer first.
//!
//! Guarantees: the exact area of edges that pass from row to row at whole 1/8192 pixels, rounded once to 1/255; and so for up
//! to 8,191 shapes over each other. A pixel's coverage is a function of the outline and the pixel, whatever the window and the
//! band. Shapes that lie over each other or cross inside a pixel are the one failure of this method: there signed areas cancel
//! or add up (the crossing of a bow tie gets 0, where half is right). [`InsideArea`](crate::coverage::InsideArea) resolves that.
//!
//! Source: exact area by cells (FreeType's smooth rasterizer, Turner 2000), kept as differences (font-rs, Levien 2016).

use core::{num::Wrapping, ops::Range};

use crate::{
    coverage::{
        Coverage, CoverageMethod, Emit, EmitRows,
        area::{
            accumulation_buffer::{AREA_ONE, AccumulationBuffer, coverage_of_size, in_room},
            mirrored_rows::{self, Mirror},
            row_parts::RowParts,
            siblings::dense_rows,
            sparse_row::{ColumnSides, CountedEdges, cover},
            sparse_rows::cover_all,
        },
        edges::{RowSegment, Rows, X_ONE},
    },
    scan::polygon::scanline_polygon::FillRule,
};

/// The exact area: method T3, the default for 2D.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SignedArea;

impl SignedArea {
    /// Hands over what the parts of a row cover by the nonzero rule, in spans from left to right, and takes all parts out.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    #[inline(always)]
    pub(crate) fn cover_parts<E>(parts: &mut RowParts<'_>, emit: &mut impl Emit<E>) -> Result<(), E> {
        let sides = ColumnSides::of(&parts.buffer.columns);
        parts.cover(sides, coverage_by(FillRule::NonZero), emit)
    }

    /// Hands over the pixels of all rows whose right half is the mirror image of their left half, the edges of which are given.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    #[inline(always)]
    pub(crate) fn cover_mirrored_rows<E>(
        rows: Rows<'_>,
        mirror: Mirror,
        cells: &mut [i32],
        emit: &mut impl EmitRows<E>,
    ) -> Result<(), E> {
        mirrored_rows::cover_all(rows, mirror, cells, coverage_by(FillRule::NonZero), emit)
    }

    /// Hands over the pixels of a row whose right half is the mirror image of its left half, from the parts of the left half,
    /// and takes all parts out.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    #[inline(always)]
    pub(crate) fn cover_mirrored<E>(
        parts: &mut RowParts<'_>,
        mirror: Mirror,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        mirror.cover_parts(parts, coverage_by(FillRule::NonZero), emit)
    }
}

impl CoverageMethod for SignedArea {
    type Cell = i32;

    fn cells(width: usize) -> usize {
        width.saturating_add(1)
    }

    #[inline]
    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i32],
        mut emit: impl Emit<E>,
    ) -> Result<(), E> {
        let (columns, cells) = in_room(&columns, cells);
        cover(
            segments,
            &columns,
            cells,
            &mut Signed(fill_rule),
            coverage_by(fill_rule),
            &mut emit,
        )
    }

    #[inline(always)]
    fn cover_rows<E>(
        &self,
        rows: Rows<'_>,
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i32],
        emit: &mut impl EmitRows<E>,
    ) -> Result<(), E> {
        if rows.are_dense() {
            return dense_rows::cover(rows, &columns, cells, coverage_by(fill_rule), emit);
        }
        // A loop for each rule: looking it up takes three instructions a pixel, 4 % of a triangle in a mask (Cortex-M4).
        match fill_rule {
            FillRule::NonZero => {
                let coverage = coverage_by(FillRule::NonZero);
                cover_all(rows, &columns, cells, &mut Signed(FillRule::NonZero), coverage, emit)
            }
            // Seldom used: in rows between two edges a way of its own would take more flash than it is worth.
            FillRule::EvenOdd => {
                let (columns, cells) = in_room(&columns, cells);
                rows.for_each(|y, segments| {
                    let coverage = coverage_by(FillRule::EvenOdd);
                    let mut signed = Signed(FillRule::EvenOdd);
                    cover(segments, &columns, cells, &mut signed, coverage, &mut emit.row(y))
                })
            }
        }
    }
}

/// Returns the function from a sum of signed areas to coverage, by a fill rule. Under the nonzero rule an area counts
/// by its size; under the even-odd rule what is surrounded an even number of times is not covered: the size of the
/// sum's low bits alone, with their sign.
///
/// A number of bits, not a function for each rule, so that there is one copy of all that calls this: 3,700 bytes less for a family
/// of antialiased outlines at opt-level s.
#[inline(always)]
fn coverage_by(fill_rule: FillRule) -> impl Fn(i32) -> Coverage {
    let unused_bits = match fill_rule {
        FillRule::NonZero => 0,
        FillRule::EvenOdd => (2 * AREA_ONE).leading_zeros() + 1,
    };
    // Cells that were not 0 at first may give any sum, also the one that has no absolute value.
    move |sum| coverage_of_size((sum << unused_bits >> unused_bits).unsigned_abs())
}

/// Counts every segment by its winding, under a fill rule.
struct Signed(FillRule);

impl CountedEdges for Signed {
    /// In one pixel areas add up, whatever the order: a segment that begins in the pixel in which another one ends is disjoint.
    #[inline(always)]
    fn is_disjoint(&self, right: i32, next: i32) -> bool {
        next | (X_ONE - 1) >= right
    }

    #[inline(always)]
    fn height(&mut self, segment: &RowSegment) -> Option<i32> {
        Some(segment.signed_height())
    }

    #[inline(always)]
    fn skips(&mut self, _cluster: &[RowSegment]) -> bool {
        false
    }

    /// Under the nonzero rule, where windings add up; under the even-odd rule a larger sum may cover nothing.
    #[inline(always)]
    fn is_saturated(&self, sum: Wrapping<i32>) -> bool {
        self.0 == FillRule::NonZero && sum.0.unsigned_abs() >= AREA_ONE as u32
    }

    fn add_cluster(&mut self, cluster: &mut [RowSegment], buffer: &mut AccumulationBuffer<'_>) {
        for segment in cluster.iter() {
            buffer.add(segment.x_top, segment.x_bottom, segment.signed_height());
        }
    }
}
