//! Which of two faces is seen in the columns that both cover.

use core::marker::PhantomData;

use crate::{
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::{FaceTable, NONE},
        hidden_surfaces::span_scan_line::row_span::{RowSpan, SlotsInRow, SpanInSlot},
    },
};

/// What was done, modulo 2^32.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Counters {
    pub(super) intervals: u32,
    pub(super) splits: u32,
    pub(super) comparisons: u32,
    pub(super) pixels_compared: u32,
}

impl Counters {
    pub(super) const ZERO: Self = Self {
        intervals: 0,
        splits: 0,
        comparisons: 0,
        pixels_compared: 0,
    };
}

/// Compares faces of a table, and counts that.
pub(super) struct Comparison<'c, S, D, H, F> {
    pub(super) faces: &'c F,
    pub(super) counters: &'c mut Counters,
    look: PhantomData<(S, D, H)>,
}

impl<'c, S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>> Comparison<'c, S, D, H, F> {
    pub(super) fn new(faces: &'c F, counters: &'c mut Counters) -> Self {
        Self {
            faces,
            counters,
            look: PhantomData,
        }
    }

    /// An interval was handed over.
    #[inline]
    pub(super) fn count_interval(&mut self) {
        let counters = &mut *self.counters;
        counters.intervals = counters.intervals.wrapping_add(1);
    }

    /// The nearest of some spans at a column, at which all of them have begun and some may have ended.
    #[inline]
    pub(super) fn nearest(
        &mut self,
        (slots, spans): (&SlotsInRow<'_, S, H>, &[SpanInSlot]),
        column: i32,
    ) -> Option<RowSpan> {
        let mut there = spans.iter().filter(|span| span.after() > column);
        let mut nearest = there.next()?;
        let mut depth = D::from_interpolated(slots.depth_at(nearest, column)?);
        for span in there {
            self.count_comparison();
            let own = D::from_interpolated(slots.depth_at(span, column)?);
            if own > depth || (own == depth && self.comes_first(slots.node(span), slots.node(nearest))) {
                (nearest, depth) = (span, own);
            }
        }
        slots.with_depths(nearest)
    }

    /// Whether a face that is in a slot is hidden by another one at two columns that both cover, because it is so far behind that
    /// the stored depths differ. `false` where that takes a closer look.
    #[inline]
    pub(super) fn is_far_behind(
        &mut self,
        (slots, span): (&SlotsInRow<'_, S, H>, &SpanInSlot),
        other: &RowSpan,
        columns: [i32; 2],
    ) -> bool {
        columns.into_iter().all(|column| {
            self.count_comparison();
            let own = slots.depth_at(span, column).unwrap_or(0);
            let others = other.depth_at(column);
            own <= others && others - own >= Self::STORED_UNIT
        })
    }

    /// The nearer of two spans at a column; the second one begins there or left of it, and may have ended.
    pub(super) fn nearer(&mut self, nearest: Option<RowSpan>, span: &RowSpan, column: i32) -> Option<RowSpan> {
        if column >= span.after() {
            return nearest;
        }
        match nearest {
            Some(nearest) if !self.is_in_front(span, &nearest, column) => Some(nearest),
            _ => Some(*span),
        }
    }

    /// The end of an interval in which a face is seen: the first column from one on at which another one is seen in front of
    /// it, or else as it was.
    #[inline]
    pub(super) fn end_before(&mut self, nearest: &RowSpan, other: &RowSpan, start: i32, end: i32) -> i32 {
        let last = end.min(other.after());
        if start >= last {
            return end;
        }
        self.first_in_front(other, nearest, [start, last]).unwrap_or(end)
    }

    /// Whether a face is seen in front of another one at a column that both cover.
    #[inline]
    pub(super) fn is_in_front(&mut self, span: &RowSpan, other: &RowSpan, column: i32) -> bool {
        self.count_comparison();
        let (own, others) = (span.stored_at::<D>(column), other.stored_at::<D>(column));
        own > others || (own == others && self.comes_first(span.node, other.node))
    }

    /// Whether a face is hidden by another one at a column that both cover, and in all columns between this one and any other
    /// at which that is true.
    #[inline]
    fn is_behind(&mut self, span: &RowSpan, other: &RowSpan, column: i32) -> bool {
        self.count_comparison();
        let (own, others) = (span.depth_at(column), other.depth_at(column));
        // Not nearer, and so far behind that the stored depths differ, or later in the order of models.
        own <= others && (others - own >= Self::STORED_UNIT || self.comes_first(other.node, span.node))
    }

    /// The depths of two faces are compared at a column.
    #[inline]
    fn count_comparison(&mut self) {
        let counters = &mut *self.counters;
        counters.comparisons = counters.comparisons.wrapping_add(1);
    }

    /// The least difference of interpolated depths with which the stored ones differ always.
    const STORED_UNIT: u32 = if D::FRACTION_BITS == 16 { 1 << 16 } else { 1 };

    /// The first column from one on, and before another one, at which a face is seen in front of another. Both faces cover
    /// these columns, of which there is one at least.
    #[inline]
    fn first_in_front(&mut self, span: &RowSpan, other: &RowSpan, [start, end]: [i32; 2]) -> Option<i32> {
        let begins_behind = self.is_behind(span, other, start);
        if !begins_behind && self.is_in_front(span, other, start) {
            return Some(start);
        }
        let ends_behind = self.is_behind(span, other, end - 1);
        if begins_behind && ends_behind {
            return None;
        }
        self.search(span, other, [start, end], [begins_behind, ends_behind])
    }

    /// The first column after one at which a face is not seen in front of another, and before another column, at which it is.
    /// At one of the two ends, or at both, it is not surely behind.
    #[cold]
    #[inline(never)]
    fn search(
        &mut self,
        span: &RowSpan,
        other: &RowSpan,
        [start, end]: [i32; 2],
        [begins_behind, ends_behind]: [bool; 2],
    ) -> Option<i32> {
        let first = if begins_behind {
            self.first_not_behind(span, other, [start, end - 1])
        } else {
            start + 1
        };
        for column in first..end {
            if self.is_in_front(span, other, column) {
                self.counters.splits = self.counters.splits.wrapping_add(1);
                return Some(column);
            }
            self.counters.pixels_compared = self.counters.pixels_compared.wrapping_add(1);
            if ends_behind && self.is_behind(span, other, column) {
                return None;
            }
        }
        None
    }

    /// The first column up to one at which a face is not surely behind another, where it is not surely so. At an earlier column
    /// it is.
    fn first_not_behind(&mut self, span: &RowSpan, other: &RowSpan, [mut behind, mut not_behind]: [i32; 2]) -> i32 {
        while behind + 1 < not_behind {
            let middle = (behind + not_behind) >> 1;
            if self.is_behind(span, other, middle) {
                behind = middle;
            } else {
                not_behind = middle;
            }
        }
        not_behind
    }

    /// Whether a face comes before another one in the order of models.
    #[cold]
    #[inline(never)]
    fn comes_first(&self, node: u16, other: u16) -> bool {
        let (order, others) = (self.faces.order(node), self.faces.order(other));
        order < others || (order == others && self.comes_first_in_table(node, other))
    }

    /// Whether a part of a face comes before another part of it in the table.
    fn comes_first_in_table(&self, node: u16, other: u16) -> bool {
        let viewport = self.faces.viewport();
        for row in viewport.top..viewport.bottom {
            let mut current = self.faces.first_in_row(row);
            while current != NONE {
                if current == node || current == other {
                    return current == node;
                }
                current = self.faces.next(current);
            }
        }
        false
    }
}
