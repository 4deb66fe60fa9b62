//! The exact area of what is inside by the fill rule: edges that cross or lie over each other included.
//!
//! A row is cut where edges begin or end. Edges that share no column of pixels with another are measured exactly, as by
//! [`SignedArea`](crate::coverage::SignedArea), if they lie between inside and outside, or else do not count. Where edges
//! crowd they are put into order, and measured in the same way if they keep it down to the bottom of the slab. Where they
//! cross inside, the crowd is sampled in rows of 1/16 pixel, exact in x.
//!
//! Source: analytic rows with a sampled fallback (Pihlaja 2008, cairo).

use core::ops::Range;

use crate::{
    coverage::{
        Coverage, NOWHERE, Share,
        area_row::{AreaRow, Heights, cover, share_of},
        sides_at, sort_by_place,
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
        let mut inside = Inside::new(fill_rule);
        if let Some(slab) = common_slab(segments) {
            inside.slab = slab;
            return cover(segments, columns, cells, &mut inside, share_of, emit);
        }
        let mut row = AreaRow::new(columns, cells);
        let mut top = 0;
        while let Some(bottom) = next_end(segments, top) {
            inside.windings = 0;
            inside.slab = top..bottom;
            inside.add_crowd(segments, &mut row);
            top = bottom;
        }
        row.cover(share_of, emit)
    }
}

/// From where to where all segments go, if they all go from top to bottom of the same slab.
#[inline(always)]
fn common_slab(segments: &[RowSegment]) -> Option<Range<i32>> {
    let (first, others) = segments.split_first()?;
    let is_common = |other: &RowSegment| other.y_top == first.y_top && other.y_bottom == first.y_bottom;
    others.iter().all(is_common).then_some(first.y_top..first.y_bottom)
}

/// Only segments between inside and outside count.
struct Inside {
    fill_rule: FillRule,
    /// Left of the next segment.
    windings: i32,
    slab: Range<i32>,
}

impl Inside {
    #[inline(always)]
    fn new(fill_rule: FillRule) -> Self {
        Self {
            fill_rule,
            windings: 0,
            slab: 0..0,
        }
    }
}

impl Heights for Inside {
    #[inline(always)]
    fn height(&mut self, segment: &RowSegment) -> i32 {
        let height = self.slab.end.wrapping_sub(self.slab.start);
        let was_inside = self.fill_rule.includes(self.windings);
        self.windings = self.windings.wrapping_add(segment.winding);
        match (was_inside, self.fill_rule.includes(self.windings)) {
            (false, true) => height,
            (true, false) => height.wrapping_neg(),
            _ => 0,
        }
    }

    #[inline(never)]
    fn add_crowd(&mut self, crowd: &mut [RowSegment], row: &mut AreaRow<'_>) {
        enter_slab(crowd, &self.slab);
        if keep_their_order(crowd) {
            for segment in crowd.iter().take_while(|segment| segment.place != NOWHERE) {
                let height = self.height(segment);
                if height != 0 {
                    row.add(segment.place, segment.end_place, height);
                }
            }
        } else {
            self.sample(crowd, row);
        }
    }
}

/// The first ordinate after one where a segment begins or ends.
fn next_end(segments: &[RowSegment], after: i32) -> Option<i32> {
    let ends = segments.iter().flat_map(|segment| [segment.y_top, segment.y_bottom]);
    ends.filter(|end| *end > after).min()
}

/// Puts the segments into the order in which they enter a slab.
fn enter_slab(segments: &mut [RowSegment], slab: &Range<i32>) {
    let (top, bottom) = (slab.start, slab.end);
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

impl Inside {
    /// Adds the areas of a crowd in rows of at most 1/16 pixel, each measured along its middle.
    #[cold]
    fn sample(&mut self, crowd: &mut [RowSegment], row: &mut AreaRow<'_>) {
        let windings = self.windings;
        let mut top = self.slab.start;
        while top < self.slab.end {
            let bottom = top.wrapping_add(SAMPLED).min(self.slab.end);
            let height = bottom.wrapping_sub(top);
            let y = top.wrapping_add(height >> 1);
            sides_at(crowd, y, self.fill_rule, windings, |x, sign| {
                row.add(x, x, height.wrapping_mul(sign));
            });
            top = bottom;
        }
        self.windings = crowd
            .iter()
            .filter(|segment| segment.place != NOWHERE)
            .fold(windings, |sum, segment| sum.wrapping_add(segment.winding));
    }
}
