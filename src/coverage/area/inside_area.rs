//! The exact area of what is inside by the fill rule: edges that cross or lie over each other included.
//!
//! A row is cut where edges begin or end. Edges that lie beside all others are measured exactly, as by
//! [`SignedArea`](crate::coverage::SignedArea), if they lie between inside and outside, or else do not count. Where edges
//! crowd they are put into order, and measured in the same way down to the first crossing, and from there to the next one.
//! What is left after eight crossings is sampled in rows of 1/16 pixel, exact in x.
//!
//! Source: analytic rows with a sampled fallback (Pihlaja 2008, cairo).

use core::{num::NonZeroU32, ops::Range};

use crate::{
    coverage::{
        Coverage, CoverageMethod, NOWHERE,
        area::area_row::{AreaRow, Heights, cover, coverage_of},
        edges::{HEIGHT_BITS, RowSegment, UNIT},
        sides_at, sort_by_place,
    },
    scan::polygon::scanline_polygon::FillRule,
};

/// The exact area under both rules, whatever crosses: tier T4.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InsideArea;

/// Crossings for which a slab is cut.
const MOST_CUTS: i32 = 8;

/// Height of a sampled row, in units.
const SAMPLED: i32 = UNIT / 16;

impl CoverageMethod for InsideArea {
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
        emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut inside = Inside::new(fill_rule);
        if let Some(slab) = common_slab(segments) {
            inside.slab = slab;
            return cover(segments, columns, cells, &mut inside, coverage_of, emit);
        }
        let mut row = AreaRow::new(&columns, cells);
        let mut top = 0;
        while let Some(bottom) = next_end(segments, top) {
            inside.windings = 0;
            inside.slab = top..bottom;
            inside.add_crowd(segments, &mut row);
            top = bottom;
        }
        row.cover(segments, coverage_of, emit)
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
    fn is_apart(right: i32, next: i32) -> bool {
        next >= right
    }

    #[inline(always)]
    fn height(&mut self, segment: &RowSegment) -> Option<i32> {
        let height = self.slab.end.wrapping_sub(self.slab.start) << HEIGHT_BITS;
        let was_inside = self.fill_rule.includes(self.windings);
        self.windings = self.windings.wrapping_add(segment.winding);
        match (was_inside, self.fill_rule.includes(self.windings)) {
            (false, true) => Some(height),
            (true, false) => Some(height.wrapping_neg()),
            _ => None,
        }
    }

    /// Where the winding number is so far from 0 that no order of the segments would make it 0.
    fn skips(&mut self, crowd: &[RowSegment]) -> bool {
        let windings = crowd.iter().map(|segment| segment.winding);
        let (mut lowest, mut highest) = (self.windings, self.windings);
        for winding in windings {
            lowest = lowest.wrapping_add(winding.min(0));
            highest = highest.wrapping_add(winding.max(0));
        }
        let skips = self.fill_rule == FillRule::NonZero && (lowest > 0 || highest < 0);
        if skips {
            // Every segment is in one of the two.
            self.windings = lowest.wrapping_add(highest).wrapping_sub(self.windings);
        }
        skips
    }

    #[inline(never)]
    fn add_crowd(&mut self, crowd: &mut [RowSegment], row: &mut AreaRow<'_>) {
        let (slab, windings) = (self.slab.clone(), self.windings);
        for _ in 0..MOST_CUTS {
            enter_slab(crowd, &self.slab);
            let crossing = first_crossing(crowd, &self.slab);
            if let Some(y) = crossing {
                self.slab.end = y;
                leave_slab(crowd, y);
            }
            self.windings = windings;
            self.measure(crowd, row);
            self.slab = self.slab.end..slab.end;
            if crossing.is_none() {
                break;
            }
        }
        if !self.slab.is_empty() {
            self.sample(crowd, windings, row);
        }
        self.slab = slab;
    }
}

/// The first ordinate after one where a segment begins or ends.
fn next_end(segments: &[RowSegment], after: i32) -> Option<i32> {
    let ends = segments.iter().flat_map(|segment| [segment.y_top, segment.y_bottom]);
    ends.filter(|end| *end > after).min()
}

/// Puts the segments into the order in which they enter a slab.
fn enter_slab(segments: &mut [RowSegment], slab: &Range<i32>) {
    for segment in segments.iter_mut() {
        let is_there = segment.y_top <= slab.start && slab.end <= segment.y_bottom;
        (segment.place, segment.end_place) = if is_there {
            (place_at(segment, slab.start), place_at(segment, slab.end))
        } else {
            (NOWHERE, NOWHERE)
        };
    }
    sort_by_place(segments);
}

/// Makes the slab end further up.
fn leave_slab(segments: &mut [RowSegment], y: i32) {
    for segment in segments.iter_mut().filter(|segment| segment.place != NOWHERE) {
        segment.end_place = place_at(segment, y);
    }
}

#[inline(always)]
fn place_at(segment: &RowSegment, y: i32) -> i32 {
    if y == segment.y_top {
        segment.x_top
    } else if y == segment.y_bottom {
        segment.x_bottom
    } else {
        segment.x_at(y)
    }
}

/// Where two of the segments cross first, below the top of the slab; those that do are neighbours there.
fn first_crossing(segments: &[RowSegment], slab: &Range<i32>) -> Option<i32> {
    let pairs = segments.iter().zip(segments.iter().skip(1));
    let crossings = pairs
        .filter(|(one, other)| one.end_place > other.end_place)
        .map(|(one, other)| crossing_of(one, other, slab));
    crossings.min()
}

/// Ordinate where two segments cross that are neighbours at the top of the slab and change their order in it: rounded down,
/// at least 1 below the top, at most the bottom.
///
/// Not inlined: inside the loop over all pairs it made rows without a crossing up to 3 % slower (Cortex-M4).
#[inline(never)]
fn crossing_of(one: &RowSegment, other: &RowSegment, slab: &Range<i32>) -> i32 {
    // Their distances at the top and at the bottom of the slab.
    let top = one.place.abs_diff(other.place);
    let bottom = one.end_place.abs_diff(other.end_place);
    // Where they are far apart, 2^27 at most for edges of the domain, the last bits do not matter.
    let unused_bits = if top | bottom < 1 << 22 { 0 } else { 6 };
    let (top, bottom) = (top >> unused_bits, bottom >> unused_bits);
    // Not 0: the bottom is not, and where that lost its last bits the sum is at least 2^16.
    let sum = NonZeroU32::new(top + bottom).unwrap_or(NonZeroU32::MIN);
    // Below 2^30 for edges of the domain. What does not fit is cut off, so that the quotient stays in the slab.
    let down = slab.end.abs_diff(slab.start).saturating_mul(top) / sum;
    slab.start.wrapping_add_unsigned(down.max(1))
}

impl Inside {
    /// Adds the areas of a slab whose edges keep their order.
    fn measure(&mut self, segments: &[RowSegment], row: &mut AreaRow<'_>) {
        for segment in segments.iter().take_while(|segment| segment.place != NOWHERE) {
            if let Some(height) = self.height(segment) {
                row.add(segment.place, segment.end_place, height);
            }
        }
    }

    /// Adds the areas of a crowd in rows of at most 1/16 pixel, each measured along its middle.
    #[cold]
    fn sample(&mut self, crowd: &mut [RowSegment], windings: i32, row: &mut AreaRow<'_>) {
        let mut top = self.slab.start;
        while top < self.slab.end {
            let bottom = top.wrapping_add(SAMPLED).min(self.slab.end);
            let height = bottom.wrapping_sub(top);
            let y = top.wrapping_add(height >> 1);
            sides_at(crowd, y, self.fill_rule, windings, |x, sign| {
                row.add(x, x, (height << HEIGHT_BITS).wrapping_mul(sign));
            });
            top = bottom;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two segments that change their order, at distances over the whole number range: against exact arithmetic, and in
    /// the slab.
    #[test]
    fn crossings_lie_in_their_slab() {
        let numbers = [
            i32::MIN,
            -(1 << 27),
            -8_192,
            -1,
            0,
            1,
            3,
            2_097_152,
            1 << 26,
            i32::MAX - 1,
        ];
        let slabs = [0..1, 0..256, 3..200, 255..256, 0..i32::MAX];
        let ordered = || numbers.into_iter().flat_map(|one| numbers.map(|other| (one, other)));
        for ((left, right), (end_left, end_right)) in ordered().flat_map(|top| ordered().map(move |end| (top, end))) {
            if left > right || end_left >= end_right {
                continue;
            }
            let at = |place, end_place| {
                let mut segment = RowSegment::default();
                (segment.place, segment.end_place) = (place, end_place);
                segment
            };
            let pair = [at(left, end_right), at(right, end_left)];
            for slab in &slabs {
                let y = first_crossing(&pair, slab).unwrap();
                let context = || (left, right, end_left, end_right, slab.clone());
                assert!(slab.start < y && y <= slab.end, "{:?}: {y}", context());
                let (top, bottom) = (
                    i64::from(right) - i64::from(left),
                    i64::from(end_right) - i64::from(end_left),
                );
                // Segments of edges in the domain.
                if top <= 1 << 27 && bottom <= 1 << 27 && slab.end <= UNIT {
                    let height = i64::from(slab.end - slab.start);
                    let exact = i64::from(slab.start) + (height * top / (top + bottom)).max(1);
                    // From 2^22 on the last bits are left out.
                    let error = i64::from(top | bottom >= 1 << 22);
                    assert!(
                        (i64::from(y) - exact).abs() <= error,
                        "{:?}: {y}, not {exact}",
                        context()
                    );
                }
            }
        }
    }
}
