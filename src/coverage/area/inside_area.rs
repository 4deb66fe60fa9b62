//! The exact area of what is inside by the fill rule: edges that cross or lie over each other included.
//!
//! ```text
//!        A     B             B A           Edges that are disjoint from all others in the row are counted by themselves, if
//!   ------\---/---  y        windings      they lie between inside and outside. In an overlapping cluster a sweep line goes
//!          \ /               |  |          down the row: at each y in which segments begin, end or cross, the segments in
//!   --------X-----  cut      begins ends   order from left to right say which of them are sides of the inside now. A segment
//!          / \               |  |          is measured in one go for as long as it is a side of the same kind: A from its
//!   ------/---\---           A  B          top to the cut, where the inside begins at it, and below that, where it ends.
//! ```
//!
//! Cuts are at whole 1/16384 pixels, the first one below a crossing. There edges are in their new order, so each crossing is one
//! cut (or two, where rounded x say so); and a row has no more cuts than 1/16384 pixels, however many edges cross: bounded
//! work, and no memory besides the segments themselves.
//!
//! Guarantees: a pixel's coverage is a function of the outline and the pixel. Its error is that of rounding to 1/255 and of x
//! to 1/8192 pixel, as for [`SignedArea`](crate::coverage::SignedArea), and for each crossing in the pixel less than 1/32 of
//! 1/255: below 4/255 up to a hundred crossings of nearly level edges in one pixel, and in steeper ones, which lose far less,
//! any number. Tests hold random outlines of up to 60 corners, in boxes down to 1/32 pixel high, below 4/255.
//!
//! Source: the sweep line over segments (Bentley and Ottmann 1979), in each row by itself, over exact areas (analytic rows,
//! Pihlaja 2008, cairo).

use core::{num::NonZeroU32, ops::Range};

use crate::{
    coverage::{
        CoverageMethod, Emit, EmitRows,
        area::{
            accumulation_buffer::{AccumulationBuffer, coverage_of, in_room},
            sparse_row::{CountedEdges, cover},
        },
        edges::{COVER_BITS, RowSegment, Rows, Y_BITS},
    },
    geometry::coordinate_after,
    scan::polygon::{edge_table::insertion_sort, scanline_polygon::FillRule},
};

/// The exact area under both rules, whatever crosses: method T4.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InsideArea;

/// Shift from 1/256 pixel to 1/16384 pixel.
const COVER_SHIFT: u32 = COVER_BITS - Y_BITS;

/// The x of a segment that does not reach the y in question: right of all others.
const ABSENT: i32 = i32::MAX;

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
        mut emit: impl Emit<E>,
    ) -> Result<(), E> {
        let (columns, cells) = in_room(&columns, cells);
        let mut inside = Inside::of(segments, fill_rule);
        cover(segments, &columns, cells, &mut inside, coverage_of, &mut emit)
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
        let (columns, cells) = in_room(&columns, cells);
        rows.for_each(|y, segments| {
            let mut inside = Inside::of(segments, fill_rule);
            cover(segments, &columns, cells, &mut inside, coverage_of, &mut emit.row(y))
        })
    }
}

/// Winding numbers from left to right, and where by them the inside begins and ends.
pub(super) trait Sides: Copy {
    /// Whether the inside begins (1) or ends (-1) at a segment that is passed from left to right, or neither (0).
    fn pass(&mut self, segment: &RowSegment) -> i32;

    /// Passes a cluster of segments at once where none of them is a side of the inside, in whatever order they are. Returns
    /// `false`, and passes none, where that is not known.
    fn pass_all(&mut self, cluster: &[RowSegment]) -> bool;
}

/// The winding number left of the next segment, and the rule by which it is inside.
#[derive(Copy, Clone)]
struct OneWinding {
    fill_rule: FillRule,
    windings: i32,
}

impl Sides for OneWinding {
    #[inline(always)]
    fn pass(&mut self, segment: &RowSegment) -> i32 {
        let was_inside = self.fill_rule.includes(self.windings);
        self.windings += segment.winding;
        i32::from(self.fill_rule.includes(self.windings)) - i32::from(was_inside)
    }

    /// Passes a cluster where the winding number is so far from 0 that no order of its segments would make it 0.
    fn pass_all(&mut self, cluster: &[RowSegment]) -> bool {
        let (mut lowest, mut highest) = (self.windings, self.windings);
        for segment in cluster {
            lowest += segment.winding.min(0);
            highest += segment.winding.max(0);
        }
        let passes = self.fill_rule == FillRule::NonZero && (lowest > 0 || highest < 0);
        if passes {
            // Each segment's winding is in one of the two sums: this adds all of them.
            self.windings = lowest + highest - self.windings;
        }
        passes
    }
}

/// Whether all segments go from the same top to the same bottom.
#[inline(always)]
fn is_one_slab(segments: &[RowSegment]) -> bool {
    let Some((first, others)) = segments.split_first() else {
        return true;
    };
    let is_alike = |other: &RowSegment| other.y_top == first.y_top && other.y_bottom == first.y_bottom;
    others.iter().all(is_alike)
}

/// Counts the segments between inside and outside.
pub(super) struct Inside<S> {
    /// The winding numbers left of the next segment.
    sides: S,
    /// Whether all segments of the row go from the same top to the same bottom. Where they do not, all of them are one cluster,
    /// because the winding number beside a segment changes from top to bottom.
    is_one_slab: bool,
}

impl Inside<OneWinding> {
    /// The state left of the first segment of a row.
    #[inline(always)]
    fn of(segments: &[RowSegment], fill_rule: FillRule) -> Self {
        Self::new(segments, OneWinding { fill_rule, windings: 0 })
    }
}

impl<S: Sides> Inside<S> {
    /// The state left of the first segment of a row; `sides` has the winding numbers there, which are 0.
    #[inline(always)]
    pub(super) fn new(segments: &[RowSegment], sides: S) -> Self {
        Self {
            sides,
            is_one_slab: is_one_slab(segments),
        }
    }

    /// Passes the segments that are at `y`, from left to right. One whose kind of side changes here is measured down to
    /// `y` first.
    fn pass_at(&mut self, cluster: &mut [RowSegment], y: i32, buffer: &mut AccumulationBuffer<'_>) {
        for segment in cluster.iter_mut().take_while(|segment| segment.x != ABSENT) {
            let side = self.sides.pass(segment);
            if side != sign_of(segment.side) {
                measure(segment, y, segment.x, buffer);
                segment.side = (y << 2 | side & 3) as u16;
            }
        }
    }
}

impl<S: Sides> CountedEdges for Inside<S> {
    #[inline(always)]
    fn is_disjoint(&self, right: i32, next: i32) -> bool {
        // Segments that touch are in one cluster, so that the clusters do not depend on the order of equal left ends.
        self.is_one_slab && next > right
    }

    #[inline(always)]
    fn height(&mut self, segment: &RowSegment) -> Option<i32> {
        let height = segment.signed_height() * segment.winding;
        match self.sides.pass(segment) {
            0 => None,
            1 => Some(height),
            _ => Some(-height),
        }
    }

    fn skips(&mut self, cluster: &[RowSegment]) -> bool {
        self.is_one_slab && self.sides.pass_all(cluster)
    }

    #[inline(never)]
    fn add_cluster(&mut self, cluster: &mut [RowSegment], buffer: &mut AccumulationBuffer<'_>) {
        let sides = self.sides;
        // Segments are no sides yet: each is none again once it has ended.
        let tops = cluster.iter().map(|segment| segment.y_top);
        let mut top = tops.min().unwrap_or(0);
        while let Some(bottom) = next_end(cluster, top) {
            enter(cluster, top, bottom);
            let mut slab = top << COVER_SHIFT..bottom << COVER_SHIFT;
            loop {
                sort(cluster);
                self.sides = sides;
                self.pass_at(cluster, slab.start, buffer);
                let Some(cut) = first_crossing(cluster, &slab).filter(|cut| *cut < slab.end) else {
                    break;
                };
                for segment in cluster.iter_mut().filter(|segment| segment.x != ABSENT) {
                    segment.x = segment.x_within_row(cut);
                }
                slab.start = cut;
            }
            for segment in cluster.iter_mut().filter(|segment| segment.y_bottom == bottom) {
                measure(segment, slab.end, segment.x_bottom, buffer);
                segment.side = 0;
            }
            top = bottom;
        }
    }
}

/// 1, -1 or 0, from a segment's `side`.
#[inline(always)]
fn sign_of(side: u16) -> i32 {
    i32::from((side << 14) as i16 >> 14)
}

/// Adds the area of a segment from where it became a side of the inside down to `y`, where it is at `x`; nothing if it
/// is no side.
#[inline(always)]
fn measure(segment: &RowSegment, y: i32, x: i32, buffer: &mut AccumulationBuffer<'_>) {
    let sign = sign_of(segment.side);
    if sign != 0 {
        let top = i32::from(segment.side >> 2);
        buffer.add(segment.x_within_row(top), x, (y - top) * sign);
    }
}

/// The first y below `after` where a segment begins or ends, in 1/256 pixel.
fn next_end(segments: &[RowSegment], after: i32) -> Option<i32> {
    let ends = segments.iter().flat_map(|segment| [segment.y_top, segment.y_bottom]);
    ends.filter(|end| *end > after).min()
}

/// Sets the x at which each segment enters and leaves a slab in which none begins or ends: `top` and `bottom` are in
/// 1/256 pixel.
fn enter(segments: &mut [RowSegment], top: i32, bottom: i32) {
    for segment in segments.iter_mut() {
        let is_there = segment.y_top <= top && bottom <= segment.y_bottom;
        (segment.x, segment.end_x) = if is_there {
            (x_at_end(segment, top), x_at_end(segment, bottom))
        } else {
            (ABSENT, ABSENT)
        };
    }
}

/// The x of a segment at a y where one begins or ends, in 1/256 pixel.
#[inline(always)]
fn x_at_end(segment: &RowSegment, y: i32) -> i32 {
    if y == segment.y_top {
        segment.x_top
    } else if y == segment.y_bottom {
        segment.x_bottom
    } else {
        segment.x_at(y)
    }
}

/// Sorts segments by x at the y in question, then by x at the end of the slab, so that those which meet are in the order that
/// they have below; then by edges, so that the order depends on nothing but the outline.
fn sort(segments: &mut [RowSegment]) {
    insertion_sort(segments, 1, |segment| {
        // Absent segments stay as they are.
        let index = if segment.x == ABSENT { 0 } else { segment.edge_index() };
        (segment.x, segment.end_x, index)
    });
}

/// The cut for the first crossing of two segments below the top of the slab; those that cross first are neighbours there.
fn first_crossing(segments: &[RowSegment], slab: &Range<i32>) -> Option<i32> {
    let pairs = segments.iter().zip(segments.iter().skip(1));
    let crossings = pairs
        .filter(|(one, other)| one.end_x > other.end_x)
        .map(|(one, other)| crossing_of(one, other, slab));
    crossings.min()
}

/// Where two segments cross that are neighbours at the top of the slab and change their order in it: y rounded up, at least 1
/// below the top, at most the bottom.
///
/// Not inlined: inside the loop over all pairs it made rows without a crossing up to 3 % slower (Cortex-M4).
#[inline(never)]
fn crossing_of(one: &RowSegment, other: &RowSegment, slab: &Range<i32>) -> i32 {
    // Their distances at the top and at the bottom of the slab.
    let top = one.x.abs_diff(other.x);
    let bottom = one.end_x.abs_diff(other.end_x);
    // With 16 bits of each, a product with a height of 14 bits fits; the others would move the cut by at most 1.
    let unused_bits = 16u32.saturating_sub((top | bottom).leading_zeros());
    let (top, bottom) = (top >> unused_bits, bottom >> unused_bits);
    // Not 0: the bottom is not, and where that lost its last bits the sum is at least 2^15.
    let sum = NonZeroU32::new(top + bottom).unwrap_or(NonZeroU32::MIN);
    // Below 2^30 for slabs of a row. What does not fit is cut off, so that the quotient stays in the slab.
    let product = slab.end.abs_diff(slab.start).saturating_mul(top);
    let down = product.saturating_add(sum.get() - 1) / sum;
    coordinate_after(slab.start, down.max(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coverage::edges::COVER_ONE;

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
        let slabs = [0..1, 0..256, 3..200, 255..256, 0..1 << 14, 77..9_000, 0..i32::MAX];
        let ordered = || numbers.into_iter().flat_map(|one| numbers.map(|other| (one, other)));
        for ((left, right), (end_left, end_right)) in ordered().flat_map(|top| ordered().map(move |end| (top, end))) {
            if left > right || end_left >= end_right {
                continue;
            }
            let at = |x, end_x| {
                let mut segment = RowSegment::default();
                (segment.x, segment.end_x) = (x, end_x);
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
                if top <= 1 << 27 && bottom <= 1 << 27 && slab.end <= COVER_ONE {
                    let height = i64::from(slab.end - slab.start);
                    let sum = top + bottom;
                    let exact = i64::from(slab.start) + ((height * top + sum - 1) / sum).max(1);
                    // From 2^16 on the last bits are left out.
                    let error = i64::from(top | bottom >= 1 << 16);
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
