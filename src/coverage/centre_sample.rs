//! Coverage by the centre of the pixel: all or nothing.
//!
//! Guarantees: the top-left rule, but for centres nearer than 1/8192 pixel to an edge, which may count as being on its other
//! side; on edges that run along pixel boundaries it is the exact coverage too. Elsewhere it is wrong by up to one pixel's
//! coverage, which is what the other tiers are for. No memory. Shapes that need no coverage are drawn without this, by the
//! exact scan-line fill.

use core::ops::Range;

use crate::{
    coverage::{Coverage, Share, in_units, sides_at},
    scan::{RowSegment, scanline_polygon::FillRule},
};

/// No antialiasing: for flat user interfaces and wherever speed counts most.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CentreSample;

impl Coverage for CentreSample {
    type Cell = ();

    fn cells(_width: usize) -> usize {
        0
    }

    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        _cells: &mut [()],
        mut emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
    ) -> Result<(), E> {
        let (mut start, mut emitted) = (columns.start, Ok(()));
        sides_at(segments, 128, fill_rule, 0, |x, sign| {
            // The first pixel whose centre is there or right of it.
            let column = (in_units(x).wrapping_add(127) >> 8).clamp(columns.start, columns.end);
            if sign > 0 {
                start = column;
            } else if start < column && emitted.is_ok() {
                emitted = emit(start..column, Share::MAX);
            }
        });
        emitted
    }
}
