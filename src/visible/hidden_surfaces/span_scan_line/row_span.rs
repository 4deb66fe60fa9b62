//! The span of a face in a row, with its depths.

use core::num::Wrapping;

use crate::{
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::active_face::ActiveFace,
};

/// The part of a face's span in a row that lies in the window, and its interpolated depth as a function of the column.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct RowSpan {
    /// The interpolated depth at column 0, modulo 2^32.
    depth: u32,
    /// What it gains from a column to the next, modulo 2^32.
    per_column: u32,
    /// The first column. A span without columns begins and ends at the end of the row.
    pub(super) start: i16,
    /// The column after the last one.
    pub(super) end: i16,
    /// The face's index in the table of faces.
    pub(super) node: u16,
    /// The slot in which the face is set up.
    pub(super) slot: u16,
}

impl RowSpan {
    pub(super) const EMPTY: Self = Self {
        depth: 0,
        per_column: 0,
        start: 0,
        end: 0,
        node: 0,
        slot: 0,
    };

    /// The span of a face in a row of so many columns, which it crosses. The face is in a slot.
    #[inline]
    pub(super) fn of<S: ScreenPrecision, H: Shading>(face: &ActiveFace<S, H>, slot: u16, row: i32, width: i32) -> Self {
        let [start, end] = face.span();
        let (start, end) = (start.max(0), end.min(width));
        let [start, end] = if start < end { [start, end] } else { [width; 2] };
        Self {
            depth: face.plane.at(0, row).0,
            per_column: face.plane.per_column.0,
            start: start as i16,
            end: end as i16,
            node: face.node,
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
