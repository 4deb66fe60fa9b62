//! The spans of a row in the order of their first columns.

use crate::{
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        active_face::ActiveFace,
        face_table::FaceTable,
        hidden_surfaces::span_scan_line::{
            comparison::Comparison,
            row_span::{RowSpan, SlotsInRow, SpanInSlot},
        },
        painter::Painter,
    },
};

/// The spans of a row. They are sorted by insertion from the order in which they were in the row above, which is much the same.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct SortedSpans<const ACTIVE: usize> {
    spans: [SpanInSlot; ACTIVE],
    /// How many there are. Their slots are all those before this one, in any order.
    count: u16,
}

impl<const ACTIVE: usize> SortedSpans<ACTIVE> {
    pub(super) const EMPTY: Self = Self {
        spans: [SpanInSlot::EMPTY; ACTIVE],
        count: 0,
    };

    /// Takes up the spans that active faces have in a row of so many columns. `false` if there are too many.
    pub(super) fn take_up<S: ScreenPrecision, H: Shading>(&mut self, faces: &[ActiveFace<S, H>], width: i32) -> bool {
        if faces.len() > ACTIVE {
            return false;
        }
        let earlier = core::mem::take(&mut self.count);
        for index in 0..earlier {
            // Not overwritten yet: at most as many were put back.
            if let Some(slot) = self.spans.get(usize::from(index)).map(|span| span.slot) {
                self.take_up_slot(faces, slot, width);
            }
        }
        for slot in earlier..faces.len() as u16 {
            self.take_up_slot(faces, slot, width);
        }
        true
    }

    /// Puts the span of the face in a slot where it belongs; nothing if the slot is free by now.
    #[inline(always)]
    fn take_up_slot<S: ScreenPrecision, H: Shading>(&mut self, faces: &[ActiveFace<S, H>], slot: u16, width: i32) {
        let (Some(face), Some(spans)) = (
            faces.get(usize::from(slot)),
            self.spans.get_mut(..=usize::from(self.count)),
        ) else {
            return;
        };
        self.count += 1;
        insert(spans, SpanInSlot::of(face, slot, width));
    }

    /// Hands over the faces that are seen in a row.
    pub(super) fn draw<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &self,
        comparison: &mut Comparison<'_, S, D, H, impl FaceTable<S, D, H>>,
        row: i32,
        painter: &mut impl Painter<S, H>,
    ) {
        // Those that have not begun, and before them those that have, from the first one on that has not ended.
        let mut spans = self.spans.get(..usize::from(self.count)).unwrap_or_default();
        let (mut column, mut begun) = (0, 0);
        loop {
            while let Some(others) = after_ended(spans, column) {
                spans = others;
                begun = begun.max(1) - 1;
            }
            begun += count_before(spans, begun, column + 1);
            let (there, waiting) = spans.split_at_checked(begun).unwrap_or_default();
            let slots = SlotsInRow {
                faces: painter.active().map(|list| list.in_use()).unwrap_or_default(),
                row,
            };
            let Some(nearest) = comparison.nearest((&slots, there), column) else {
                let Some(next) = waiting.first() else { return };
                column = next.first();
                continue;
            };
            let mut end = nearest.after();
            for other in there {
                if other.slot != nearest.slot() && other.after() > column {
                    end = end_before(comparison, (&slots, other), &nearest, [column, end]);
                }
            }
            // Those that begin in the interval may end it.
            for other in waiting {
                if other.first() >= end {
                    break;
                }
                begun += 1;
                end = end_before(comparison, (&slots, other), &nearest, [other.first(), end]);
            }
            comparison.count_interval();
            painter.span_of_active(nearest.slot(), row, [column, end]);
            column = end;
        }
    }
}

/// The spans after the first one, where that ends at a column or left of it.
#[inline]
fn after_ended(spans: &[SpanInSlot], column: i32) -> Option<&[SpanInSlot]> {
    let (first, others) = spans.split_first()?;
    (first.after() <= column).then_some(others)
}

/// The end of an interval in which a face is seen: the first column from one on at which another one is seen in front of it, or
/// else as it was.
#[inline]
fn end_before<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    comparison: &mut Comparison<'_, S, D, H, impl FaceTable<S, D, H>>,
    (slots, other): (&SlotsInRow<'_, S, H>, &SpanInSlot),
    nearest: &RowSpan,
    [start, end]: [i32; 2],
) -> i32 {
    let last = end.min(other.after()) - 1;
    if comparison.is_far_behind((slots, other), nearest, [start, last]) {
        return end;
    }
    match slots.with_depths(other) {
        Some(other) => comparison.end_before(nearest, &other, start, end),
        None => end,
    }
}

/// How many spans from an index on begin before a column.
#[inline]
fn count_before(spans: &[SpanInSlot], index: usize, column: i32) -> usize {
    let waiting = spans.get(index..).unwrap_or_default();
    waiting.iter().take_while(|span| span.first() < column).count()
}

/// Puts a span where it belongs among spans in the order of their first columns, the last of which is overwritten.
#[inline]
fn insert(mut spans: &mut [SpanInSlot], span: SpanInSlot) {
    while let [.., before, last] = spans {
        if before.start <= span.start {
            break;
        }
        *last = *before;
        let others = spans.len() - 1;
        spans = spans.get_mut(..others).unwrap_or_default();
    }
    if let [.., last] = spans {
        *last = span;
    }
}
