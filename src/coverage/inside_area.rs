//! The exact area of what is inside by the fill rule: edges that cross or lie over each other included.
//!
//! A row is cut where edges begin or end. In each slab the edges are put into order; where they keep it down to the
//! slab's bottom, those between inside and outside are measured exactly, as by
//! [`SignedArea`](crate::coverage::SignedArea), and the others do not count. Where edges cross inside, the slab is
//! sampled in rows of 1/16 pixel, exact in x.
//!
//! Source: analytic rows with a sampled fallback (Pihlaja 2008, cairo).

use core::ops::Range;

use crate::{
    coverage::{
        Coverage, NOWHERE, Share, sides_at,
        signed_area::{AreaRow, WHOLE, share_of},
        sort_by_place,
    },
    scan::{RowSegment, UNIT, scanline_polygon::FillRule},
};

/// The exact area under both rules, whatever crosses: tier T4.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InsideArea;

/// Height of a sampled row, in units.
const SAMPLED: i32 = UNIT / 16;

impl Coverage for InsideArea {
    type Cell = i32;

    fn cells(width: usize) -> usize {
        width.saturating_add(1)
    }

    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i32],
        emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut row = AreaRow::new(&columns, cells);
        let mut top = 0;
        while let Some(bottom) = next_end(segments, top) {
            enter_slab(segments, top, bottom);
            if keep_their_order(segments) {
                measure(segments, fill_rule, bottom.wrapping_sub(top), &mut row);
            } else {
                sample(segments, fill_rule, top..bottom, &mut row);
            }
            top = bottom;
        }
        // Sums lie between nothing and a whole pixel but for rounding.
        row.sweep(columns, |sum| share_of(sum.clamp(0, WHOLE)), emit)
    }
}

/// The first ordinate after one where a segment begins or ends.
fn next_end(segments: &[RowSegment], after: i32) -> Option<i32> {
    let ends = segments.iter().flat_map(|segment| [segment.y_top, segment.y_bottom]);
    ends.filter(|end| *end > after).min()
}

/// Puts the segments into the order in which they enter a slab.
fn enter_slab(segments: &mut [RowSegment], top: i32, bottom: i32) {
    for segment in segments.iter_mut() {
        let is_there = segment.y_top <= top && bottom <= segment.y_bottom;
        (segment.place, segment.end_place) = if !is_there {
            (NOWHERE, NOWHERE)
        } else {
            let at = |y: i32| match y {
                y if y == segment.y_top => segment.x_top,
                y if y == segment.y_bottom => segment.x_bottom,
                y => segment.x_at(y),
            };
            (at(top), at(bottom))
        };
    }
    sort_by_place(segments);
}

fn keep_their_order(segments: &[RowSegment]) -> bool {
    segments.is_sorted_by_key(|segment| segment.end_place)
}

/// Adds the areas of a slab whose edges do not cross.
fn measure(segments: &[RowSegment], fill_rule: FillRule, height: i32, row: &mut AreaRow<'_>) {
    let mut windings = 0i32;
    for segment in segments.iter().take_while(|segment| segment.place != NOWHERE) {
        let was_inside = fill_rule.includes(windings);
        windings = windings.wrapping_add(segment.winding);
        let height = match (was_inside, fill_rule.includes(windings)) {
            (false, true) => height,
            (true, false) => height.wrapping_neg(),
            _ => continue,
        };
        row.add(segment.place, segment.end_place, height);
    }
}

/// Adds the areas of a slab in rows of at most 1/16 pixel, each measured along its middle.
#[cold]
fn sample(segments: &mut [RowSegment], fill_rule: FillRule, slab: Range<i32>, row: &mut AreaRow<'_>) {
    let mut top = slab.start;
    while top < slab.end {
        let bottom = top.wrapping_add(SAMPLED).min(slab.end);
        let height = bottom.wrapping_sub(top);
        sides_at(segments, top.wrapping_add(height >> 1), fill_rule, |x, sign| {
            row.add(x, x, height.wrapping_mul(sign));
        });
        top = bottom;
    }
}
