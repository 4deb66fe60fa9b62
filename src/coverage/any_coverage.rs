//! A coverage method that is chosen while the program runs.

use core::ops::Range;

use crate::{
    coverage::{
        CentreSample, CoverageMethod, Emit, EmitRows, InsideArea, SignedArea,
        edges::{RowSegment, Rows},
    },
    scan::polygon::scanline_polygon::FillRule,
};

/// One of three coverage methods, each exact for some shapes, chosen while the program runs. Links all three.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum AnyCoverage {
    /// T0: exact for edges along the boundaries of pixels.
    CentreSample,
    /// T3: exact for one contour that crosses itself nowhere.
    SignedArea,
    /// The exact area inside (T4), right for every shape.
    #[default]
    InsideArea,
}

impl CoverageMethod for AnyCoverage {
    type Cell = i32;

    fn cells(width: usize) -> usize {
        InsideArea::cells(width)
    }

    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i32],
        emit: impl Emit<E>,
    ) -> Result<(), E> {
        match self {
            Self::CentreSample => CentreSample.cover_row(segments, fill_rule, columns, &mut [], emit),
            Self::SignedArea => SignedArea.cover_row(segments, fill_rule, columns, cells, emit),
            Self::InsideArea => InsideArea.cover_row(segments, fill_rule, columns, cells, emit),
        }
    }

    fn cover_rows<E>(
        &self,
        rows: Rows<'_>,
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i32],
        emit: &mut impl EmitRows<E>,
    ) -> Result<(), E> {
        match self {
            Self::CentreSample => CentreSample.cover_rows(rows, fill_rule, columns, &mut [], emit),
            Self::SignedArea => SignedArea.cover_rows(rows, fill_rule, columns, cells, emit),
            Self::InsideArea => InsideArea.cover_rows(rows, fill_rule, columns, cells, emit),
        }
    }
}
