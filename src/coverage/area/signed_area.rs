//! The exact area of the shape in each pixel, from the signed areas right of its edges: one difference a pixel, and a
//! prefix sum over the row.
//!
//! Guarantees: the exact area of edges that pass from row to row at whole units of 1/8192 pixel, rounded once to 1/255;
//! and so for up to 8,191 shapes over each other.
//! Shapes that lie over each other or cross inside a pixel are its one failure: there signed areas cancel or add up (the
//! crossing of a bow tie gets 0, where half is right). [`InsideArea`](crate::coverage::InsideArea) resolves that.
//!
//! Source: exact area by cells (FreeType's smooth rasterizer, Turner 2000), kept as differences (font-rs, Levien 2016).

use core::ops::Range;

use crate::{
    coverage::{
        Coverage, CoverageMethod,
        area::{
            area_chains,
            area_row::{AreaRow, Heights, WHOLE, cover, coverage_of, rounded},
        },
        edges::{FINE, RowSegment, row_segments::Rows},
    },
    scan::polygon::scanline_polygon::FillRule,
    surface::Span,
};

/// The exact area: tier T3, the default for 2D.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SignedArea;

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
        emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        match fill_rule {
            FillRule::NonZero => cover(segments, columns, cells, &mut Signed, surrounded, emit),
            FillRule::EvenOdd => {
                let coverage = |sum: i32| coverage_of(folded(sum));
                cover(segments, columns, cells, &mut Signed, coverage, emit)
            }
        }
    }

    #[inline(always)]
    fn cover_rows<E>(
        &self,
        rows: Rows<'_>,
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i32],
        mut emit: impl FnMut(Span, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        if rows.are_crowded() {
            return match fill_rule {
                FillRule::NonZero => {
                    // Never negative.
                    let coverage = |sum: i32| rounded(sum.unsigned_abs().min(WHOLE as u32 - 1));
                    area_chains::cover(rows, &columns, cells, coverage, emit)
                }
                FillRule::EvenOdd => area_chains::cover(rows, &columns, cells, |sum| coverage_of(folded(sum)), emit),
            };
        }
        rows.for_each(|y, segments| {
            self.cover_row(segments, fill_rule, columns.clone(), cells, |columns, coverage| {
                emit(Span::new(y, columns.start, columns.end), coverage)
            })
        })
    }
}

/// The coverage of a sum under the nonzero rule.
#[inline(always)]
fn surrounded(sum: i32) -> Coverage {
    coverage_of(sum.wrapping_abs())
}

/// What is surrounded an even number of times is not covered: the low bits of a number alone, with their sign.
#[inline(always)]
fn folded(sum: i32) -> i32 {
    let unused_bits = (2 * WHOLE).leading_zeros() + 1;
    (sum << unused_bits >> unused_bits).wrapping_abs()
}

/// Every segment counts by its winding.
struct Signed;

impl Heights for Signed {
    /// Whether x `next` lies in the pixel of x `right`, or further to the right: in one pixel areas add up, whatever the
    /// order.
    #[inline(always)]
    fn is_apart(right: i32, next: i32) -> bool {
        next | (FINE - 1) >= right
    }

    #[inline(always)]
    fn height(&mut self, segment: &RowSegment) -> Option<i32> {
        Some(segment.signed_height())
    }

    #[inline(always)]
    fn skips(&mut self, _crowd: &[RowSegment]) -> bool {
        false
    }

    fn add_crowd(&mut self, crowd: &mut [RowSegment], row: &mut AreaRow<'_>) {
        for segment in crowd.iter() {
            row.add(segment.x_top, segment.x_bottom, segment.signed_height());
        }
    }
}
