//! An edge between two rows: what is kept of it while the rows of an outline are drawn one call at a time.
//!
//! A [`RowSegment`] is 64 bytes, most of them for the method that measures it. From row to row only the position at the
//! row's bottom, the step and the error term go on: 32 bytes, from which the next row's segment is made by an addition.
//!
//! Guarantees: the segments are those that [`RowSegment::step`] makes, to the bit.

use core::num::Wrapping;

use crate::coverage::edges::{
    antialiased_edge::{AntialiasedEdge, fine},
    chain_walk::PartSink,
    row_segment::{COVER_SHIFT, RowSegment, Y_ONE},
};

/// An edge that has begun, as it is at the bottom of a row.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ActiveEdge {
    /// x at the bottom of the row, in 1/8192 pixel.
    x: i32,
    /// Error term of [`RowSegment`].
    error: i32,
    /// Whole 1/8192 pixels from row to row, 1 too many unless the error term carries.
    step: i32,
    /// The amount that each row adds to the error term: the remainder of the edge's step.
    error_step: i32,
    /// Height of the whole edge, in 1/256 pixel; 0 where no edge is kept here.
    height: i32,
    /// The edge's index in its outline, and the y of its bottom in 1/256 pixel.
    edge: (u32, i32),
    /// x of the edge's bottom in 1/256 pixel, doubled, and 1 more where the outline goes up along the edge.
    bottom_x_and_direction: i32,
}

impl ActiveEdge {
    /// Memory in which no edge is kept.
    pub(crate) const FREE: Self = Self {
        x: 0,
        error: 0,
        step: 0,
        error_step: 0,
        height: 0,
        edge: (0, 0),
        bottom_x_and_direction: 0,
    };

    /// Memory that is reserved for an edge.
    pub(crate) const RESERVED: Self = Self {
        height: -1,
        ..Self::FREE
    };

    /// Whether no edge is kept here, and none is going to be.
    #[inline]
    pub(crate) const fn is_free(&self) -> bool {
        self.height == 0
    }

    /// The edge at the bottom of the row of one of its segments.
    #[inline]
    pub(crate) fn below(segment: &RowSegment, edge: &AntialiasedEdge) -> Self {
        let [_, [bottom_x, _]] = edge.ends();
        Self {
            x: segment.x_bottom,
            error: segment.error,
            step: segment.step,
            error_step: segment.error_step,
            height: segment.height,
            edge: segment.edge,
            bottom_x_and_direction: bottom_x << 1 | i32::from(segment.winding < 0),
        }
    }

    /// An edge that begins in a row and passes its bottom, a number of 1/256 pixels below the edge's top, and that has an index
    /// in its outline. It is as it is there. Cost: two divisions.
    #[inline]
    pub(crate) fn begin(edge: &AntialiasedEdge, index: u32, height: i32) -> Self {
        let [[top_x, top], [bottom_x, bottom]] = edge.ends();
        let whole_height = bottom - top;
        let (step, error_step) = edge.step_of(height);
        let mut active = Self {
            x: fine(top_x),
            error: (whole_height >> 1) - whole_height,
            step,
            error_step,
            height: whole_height,
            edge: (index, bottom),
            bottom_x_and_direction: bottom_x << 1 | i32::from(edge.winding() < 0),
        };
        active.step();
        if whole_height - height > Y_ONE {
            (active.step, active.error_step) = edge.step_of(Y_ONE);
        }
        active
    }

    /// An edge that ends at the bottom of a row: what is asked for to find its successor.
    #[inline]
    pub(crate) fn ended(edge: &AntialiasedEdge, index: u32) -> Self {
        let [_, [bottom_x, bottom]] = edge.ends();
        Self {
            x: fine(bottom_x),
            edge: (index, bottom),
            bottom_x_and_direction: bottom_x << 1 | i32::from(edge.winding() < 0),
            ..Self::RESERVED
        }
    }

    /// Moves to the bottom of the next row, in which the edge must lie, and adds its part there. `row_bottom` is the y of that
    /// bottom, in 1/256 pixel.
    #[inline(always)]
    pub(crate) fn add_next_part(&mut self, row_bottom: i32, parts: &mut impl PartSink) {
        let (top, mut height) = (self.x, Y_ONE);
        if self.edge.1 > row_bottom {
            self.step();
        } else {
            self.x = fine(self.bottom_x_and_direction >> 1);
            height += self.edge.1 - row_bottom;
        }
        let height = height << COVER_SHIFT;
        parts.add_part((top, self.x), if self.runs_up() { -height } else { height });
    }

    /// The edge's index in its outline.
    #[inline]
    pub(crate) const fn index(&self) -> u32 {
        self.edge.0
    }

    /// The edge's lower end, as (x, y) in 1/256 pixel.
    #[inline]
    pub(crate) const fn bottom(&self) -> [i32; 2] {
        [self.bottom_x_and_direction >> 1, self.edge.1]
    }

    /// Whether the outline goes up along the edge.
    #[inline]
    pub(crate) const fn runs_up(&self) -> bool {
        self.bottom_x_and_direction & 1 != 0
    }

    /// Moves to the bottom of the next row, in which the edge must lie, and returns its segment there. `row_bottom` is
    /// the y of that bottom, in 1/256 pixel.
    #[inline]
    pub(crate) fn next_segment(&mut self, row_bottom: i32) -> RowSegment {
        let mut segment = RowSegment {
            x_top: self.x,
            x_bottom: self.x,
            y_bottom: Y_ONE,
            winding: if self.runs_up() { -1 } else { 1 },
            edge: self.edge,
            ..RowSegment::default()
        };
        if self.edge.1 > row_bottom {
            self.step();
        } else {
            self.x = fine(self.bottom_x_and_direction >> 1);
            segment.y_bottom = self.edge.1 - (row_bottom - Y_ONE);
        }
        segment.x_bottom = self.x;
        segment.measure();
        segment
    }

    /// Moves to the bottom of the next row, which the edge must pass.
    #[inline]
    pub(crate) fn step(&mut self) {
        self.x = self.next_x();
        let error = self.error + self.error_step;
        self.error = error - (self.height & !(error >> 31));
    }

    /// x at the bottom of the next row, in 1/8192 pixel, where the edge passes it.
    #[inline]
    pub(crate) fn next_x(&self) -> i32 {
        let keeps = (self.error + self.error_step) >> 31;
        // Whoever steps on below the edge's end leaves the number range some time.
        (Wrapping(self.x) + Wrapping(self.step + keeps)).0
    }

    /// x at the bottom of the row, in 1/8192 pixel.
    #[inline]
    pub(crate) const fn x(&self) -> i32 {
        self.x
    }
}
