//! The spans of a row in the order of their first columns.

use core::cell::Cell;

use crate::{
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        active_face::ActiveFace,
        face_table::FaceTable,
        hidden_surfaces::span_scan_line::{comparison::Comparison, row_span::RowSpan},
        painter::Painter,
    },
};

/// The spans of a row. They are sorted by insertion from the order in which they were in the row above, which is much the same.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct SortedSpans<const ACTIVE: usize> {
    spans: [RowSpan; ACTIVE],
    /// How many there are. Their slots are all those before this one, in any order.
    count: u16,
}

impl<const ACTIVE: usize> SortedSpans<ACTIVE> {
    pub(super) const EMPTY: Self = Self {
        spans: [RowSpan::EMPTY; ACTIVE],
        count: 0,
    };

    /// Takes up the spans that active faces have in a row of so many columns. `false` if there are too many.
    pub(super) fn take_up<S: ScreenPrecision, H: Shading>(
        &mut self,
        faces: &[ActiveFace<S, H>],
        row: i32,
        width: i32,
    ) -> bool {
        if faces.len() > ACTIVE {
            return false;
        }
        let earlier = core::mem::take(&mut self.count);
        for index in 0..earlier {
            // Not overwritten yet: at most as many were put back.
            if let Some(slot) = self.spans.get(usize::from(index)).map(|span| span.slot) {
                self.take_up_slot(faces, slot, row, width);
            }
        }
        for slot in earlier..faces.len() as u16 {
            self.take_up_slot(faces, slot, row, width);
        }
        true
    }

    /// Puts the span of the face in a slot where it belongs; nothing if the slot is free by now.
    #[inline(always)]
    fn take_up_slot<S: ScreenPrecision, H: Shading>(
        &mut self,
        faces: &[ActiveFace<S, H>],
        slot: u16,
        row: i32,
        width: i32,
    ) {
        let (Some(face), Some(spans)) = (
            faces.get(usize::from(slot)),
            self.spans.get_mut(..=usize::from(self.count)),
        ) else {
            return;
        };
        self.count += 1;
        insert(spans, RowSpan::of(face, slot, row, width));
    }

    /// Hands over the faces that are seen in a row.
    pub(super) fn draw<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        comparison: &mut Comparison<'_, S, D, H, impl FaceTable<S, D, H>>,
        row: i32,
        painter: &mut impl Painter<S, H>,
    ) {
        let spans = self.spans.get_mut(..usize::from(self.count)).unwrap_or_default();
        // So many spans have ended at a column or left of it, and so many have begun: these come first.
        let (mut column, mut ended, mut begun) = (0, 0, 0);
        loop {
            begun += count_before(spans, begun, column + 1);
            ended += move_ended_first(spans.get_mut(ended..begun).unwrap_or_default(), column);
            let there = spans.get(ended..begun).unwrap_or_default();
            if let Some(nearest) = comparison.nearest(there, column) {
                let end = comparison.end_among(nearest, there, column);
                // Those that begin in the interval may end it.
                let (end, more) = end_at_beginning(comparison, nearest, spans.get(begun..).unwrap_or_default(), end);
                begun += more;
                comparison.count_interval();
                painter.span_of_active(nearest.slot, row, [column, end]);
                column = end;
            } else if let Some(next) = spans.get(begun) {
                column = next.first();
            } else {
                return;
            }
        }
    }
}

/// Moves the spans that end at a column or left of it before the others. Returns how many these are.
#[inline]
fn move_ended_first(spans: &mut [RowSpan], column: i32) -> usize {
    let spans = Cell::from_mut(spans).as_slice_of_cells();
    let mut ended = 0;
    for span in spans {
        if span.get().after() <= column {
            if let Some(first) = spans.get(ended) {
                first.set(span.replace(first.get()));
            }
            ended += 1;
        }
    }
    ended
}

/// How many spans from an index on begin before a column.
#[inline]
fn count_before(spans: &[RowSpan], index: usize, column: i32) -> usize {
    let waiting = spans.get(index..).unwrap_or_default();
    waiting.iter().take_while(|span| span.first() < column).count()
}

/// The end of an interval in which a face is seen, up to which other spans may begin, in the order of their first columns, and
/// how many of these begin before it.
#[inline]
fn end_at_beginning<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    comparison: &mut Comparison<'_, S, D, H, impl FaceTable<S, D, H>>,
    nearest: &RowSpan,
    waiting: &[RowSpan],
    mut end: i32,
) -> (i32, usize) {
    let mut begun = 0;
    for other in waiting {
        if other.first() >= end {
            break;
        }
        begun += 1;
        end = comparison.end_before(nearest, other, other.first(), end);
    }
    (end, begun)
}

/// Puts a span where it belongs among spans in the order of their first columns, the last of which is overwritten.
#[inline]
fn insert(mut spans: &mut [RowSpan], span: RowSpan) {
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
