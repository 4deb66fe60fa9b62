//! The span of a face in a row: what is kept of it, and its depths, which are looked up.

use core::num::Wrapping;

use crate::{
    geometry::Sub4,
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{active_face::ActiveFace, edge::EdgePair, face_table::NONE},
};

/// What is kept of a face's span in a row: the columns that lie in the window, and where the face is. Its depth plane is in the
/// slot, which the frame's memory has anyway.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct SpanInSlot {
    /// The first column. A span without columns begins and ends at the end of the row.
    pub(super) start: i16,
    /// The column after the last one.
    pub(super) end: i16,
    /// The slot in which the face is set up.
    pub(super) slot: u16,
}

/// An active edge takes at most 12 bytes: half of this, and in the slot its column with the error term and its step.
const _: () = assert!(size_of::<SpanInSlot>() + size_of::<EdgePair<Sub4>>() <= 2 * 12);

impl SpanInSlot {
    pub(super) const EMPTY: Self = Self {
        start: 0,
        end: 0,
        slot: 0,
    };

    /// The span of a face in a row of so many columns, which it crosses. The face is in a slot.
    #[inline]
    pub(super) fn of<S: ScreenPrecision, H: Shading>(face: &ActiveFace<S, H>, slot: u16, width: i32) -> Self {
        let [start, end] = face.span();
        let (start, end) = (start.max(0), end.min(width));
        let [start, end] = if start < end { [start, end] } else { [width; 2] };
        Self {
            start: start as i16,
            end: end as i16,
            slot,
        }
    }

    /// The first column.
    #[inline]
    pub(super) fn first(&self) -> i32 {
        self.start.into()
    }

    /// The column after the last one.
    #[inline]
    pub(super) fn after(&self) -> i32 {
        self.end.into()
    }
}

/// The slots of all faces that cross a row, in which the depths of their spans are looked up.
pub(super) struct SlotsInRow<'a, S: ScreenPrecision, H: Shading> {
    pub(super) faces: &'a [ActiveFace<S, H>],
    pub(super) row: i32,
}

impl<S: ScreenPrecision, H: Shading> SlotsInRow<'_, S, H> {
    /// The interpolated depth of the face of a span at a column that it covers. `None` where no face is in its slot.
    #[inline]
    pub(super) fn depth_at(&self, span: &SpanInSlot, column: i32) -> Option<u32> {
        let face = self.faces.get(usize::from(span.slot))?;
        Some(face.plane.at(column, self.row).0)
    }

    /// The index of the face of a span in the table of faces.
    pub(super) fn node(&self, span: &SpanInSlot) -> u16 {
        self.faces.get(usize::from(span.slot)).map_or(NONE, |face| face.node)
    }

    /// A span with its depths. `None` where no face is in its slot.
    #[inline]
    pub(super) fn with_depths(&self, span: &SpanInSlot) -> Option<RowSpan> {
        let face = self.faces.get(usize::from(span.slot))?;
        Some(RowSpan::at(*span, face, self.row))
    }
}

/// The part of a face's span in a row that lies in the window, and its interpolated depth as a function of the column.
#[derive(Debug, Copy, Clone)]
pub(super) struct RowSpan {
    /// The interpolated depth at column 0, modulo 2^32.
    depth: u32,
    /// What it gains from a column to the next, modulo 2^32.
    per_column: u32,
    /// The face's index in the table of faces.
    pub(super) node: u16,
    /// The columns and the slot.
    span: SpanInSlot,
}

impl RowSpan {
    /// The span of a face in a row of so many columns, which it crosses. The face is in a slot.
    #[inline]
    pub(super) fn of<S: ScreenPrecision, H: Shading>(face: &ActiveFace<S, H>, slot: u16, row: i32, width: i32) -> Self {
        Self::at(SpanInSlot::of(face, slot, width), face, row)
    }

    /// A span with the depths of its face in a row.
    #[inline]
    fn at<S: ScreenPrecision, H: Shading>(span: SpanInSlot, face: &ActiveFace<S, H>, row: i32) -> Self {
        Self {
            depth: face.plane.at(0, row).0,
            per_column: face.plane.per_column.0,
            node: face.node,
            span,
        }
    }

    /// The slot of the face.
    #[inline]
    pub(super) fn slot(&self) -> u16 {
        self.span.slot
    }

    /// The first column.
    #[inline]
    pub(super) fn first(&self) -> i32 {
        self.span.first()
    }

    /// The column after the last one.
    #[inline]
    pub(super) fn after(&self) -> i32 {
        self.span.after()
    }

    /// The interpolated depth at a column: exact, with the fraction, where the face covers it.
    #[inline]
    pub(super) fn depth_at(&self, column: i32) -> u32 {
        (Wrapping(self.depth) + Wrapping(self.per_column) * Wrapping(column as u32)).0
    }

    /// The stored depth at a column that the face covers.
    #[inline]
    pub(super) fn stored_at<D: DepthWidth>(&self, column: i32) -> D {
        D::from_interpolated(self.depth_at(column))
    }
}
