//! Sub-scanlines: the pixel is cut into `N` rows, and in each the shape is measured along the middle of it.
//!
//! Guarantees: any polygon under both rules, edges that cross included. Sides are rounded to the nearest 1/256 pixel, from
//! positions within 1/8192 pixel: each is within 0.54/256 pixel of the edge. Nearly level edges are the weak side of this
//! method: coverage comes in steps of 1/N there. Source: the scanline with exact x coverage (Catmull 1984; Kiesewetter's
//! "tor", cairo 2008).

use core::ops::Range;

use crate::{
    coverage::{
        Coverage, CoverageMethod, Emit,
        edges::{RowSegment, X_ONE, Y_ONE},
        samples::scanline::sides_at,
        sweep::sweep_row,
        with_room,
    },
    scan::polygon::scanline_polygon::FillRule,
};

/// Coverage by `N` sub-scanlines a pixel, a power of two from 1 to 64: 4 is method T2.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SubScanlines<const N: i32>;

impl<const N: i32> CoverageMethod for SubScanlines<N> {
    type Cell = i16;

    fn cells(width: usize) -> usize {
        width.saturating_add(1)
    }

    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i16],
        mut emit: impl Emit<E>,
    ) -> Result<(), E> {
        const { assert!(N > 0 && N <= 64 && N.count_ones() == 1, "a power of two up to 64") };
        let columns = with_room(&columns, cells.len());
        for sub_scanline in 0..N {
            let y = Y_ONE / 2 * (sub_scanline * 2 + 1) / N;
            sides_at(segments, y, fill_rule, |x, sign| {
                let part = |x: i32| (Y_ONE - x, x);
                add_side(cells, &columns, nearest_unit(x), sign, part);
            });
        }
        let whole = Y_ONE * N;
        let bits = whole.trailing_zeros();
        // From 0 to 2^14, unless the cells were not 0 at first: then coverages are wrong, but nothing overflows.
        let coverage = |sum: i32| (sum.wrapping_mul(255).wrapping_add(whole / 2) >> bits) as Coverage;
        sweep_row(columns, cells, coverage, &mut emit)
    }
}

fn nearest_unit(x: i32) -> i32 {
    const PER_UNIT: i32 = X_ONE / Y_ONE;
    (x + PER_UNIT / 2) >> PER_UNIT.trailing_zeros()
}

/// Adds a side to the differences: `part` says how much of its pixel lies right of it and left of it.
#[inline]
pub(crate) fn add_side(
    cells: &mut [i16],
    columns: &Range<i32>,
    x: i32,
    sign: i32,
    part: impl FnOnce(i32) -> (i32, i32),
) {
    let from_left = (x - columns.start * Y_ONE).max(0);
    let (right, left) = part(from_left & (Y_ONE - 1));
    let column = (from_left >> 8) as usize;
    // Sides come and go in turns, so a cell's sum is below a whole pixel's: 64 * 256 fits, unless the cell was not 0 at first.
    let mut add = |index: usize, part: i32| {
        if let Some(cell) = cells.get_mut(index) {
            *cell = cell.wrapping_add((sign * part) as i16);
        }
    };
    add(column, right);
    add(column + 1, left);
}
