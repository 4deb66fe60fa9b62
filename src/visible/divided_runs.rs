//! The runs of a span of a face whose attributes are divided by its depth, from left to right.
//!
//! Attributes are exact at both ends of the span and at each column of the picture that is a multiple of 16 (or of what a
//! shading says), and step evenly in between. What is divided, and by what, gains the same from pixel to pixel, so that a walk
//! from run to run keeps these numbers and the attributes at the end of the last run:
//!
//! ```text
//!     span    |----------------------------------------------------|
//!     divided *        *               *               *           *
//!     runs     [first ][ 16 pixels    ][ 16 pixels    ][ last      ]
//! ```

use core::num::Wrapping;

use crate::{
    shade::{Planes, Run, Shading},
    view::{DepthWidth, ScreenPrecision},
    visible::{active_face::ActiveFace, depth_plane::rounding},
};

/// How many pixels runs have but at the ends of a span, unless attributes are divided more often.
pub(super) const WHOLE_RUN: i32 = 16;

/// A walk over the runs of a span of a face whose attributes are not even.
pub(super) struct DividedRuns<'f, A: Planes> {
    planes: &'f A::Planes,
    dividends: A::Dividends,
    values: A::Values,
    /// The depth by which attributes are divided, without what rounds it when it is stored.
    depth: Wrapping<u32>,
    depth_per_column: Wrapping<u32>,
    /// The column of the row at which all these are.
    column: i32,
    /// The column after the last one of the span.
    end: i32,
    /// The first column of the row.
    first_column: i32,
}

impl<'f, A: Planes> DividedRuns<'f, A> {
    /// The runs of a span from the one in which a column lies. Columns count from the first of the row.
    #[inline(never)]
    pub(super) fn new<S: ScreenPrecision, D: DepthWidth, H: Shading<Attributes = A>>(
        face: &'f ActiveFace<S, H>,
        [start, end]: [i32; 2],
        [column, row]: [i32; 2],
        first_column: i32,
    ) -> Self {
        let past = (column + first_column) & (A::STEP - 1);
        let column = (column - past).max(start);
        let depth = face.plane.at(column, row) - rounding::<D>();
        let dividends = A::dividends(&face.attributes, column, row);
        Self {
            planes: &face.attributes,
            values: A::divided(&face.attributes, &dividends, depth, [column, row]),
            dividends,
            depth,
            depth_per_column: face.plane.per_column,
            column,
            end,
            first_column,
        }
    }

    /// Whether the next run is a whole one of [`WHOLE_RUN`] pixels that begins in this column, and not the last one of the
    /// span.
    #[inline(always)]
    pub(super) fn is_whole(&self, column: i32) -> bool {
        A::STEP == WHOLE_RUN
            && column == self.column
            && (column + self.first_column) & (WHOLE_RUN - 1) == 0
            && column + WHOLE_RUN < self.end
    }

    /// The last column of the span. Its run is no whole one: attributes are divided there, too.
    #[inline(always)]
    pub(super) fn last_column(&self) -> i32 {
        self.end - 1
    }

    /// The next run, where it is a [whole](Self::is_whole) one; goes to its end.
    #[inline]
    pub(super) fn next_whole_run(&mut self) -> Run<A::Values> {
        self.depth += self.depth_per_column * Wrapping(WHOLE_RUN as u32);
        let [per_column, there] = A::divided_run(self.planes, &mut self.dividends, &self.values, WHOLE_RUN, self.depth);
        self.column += WHOLE_RUN;
        Run {
            values: core::mem::replace(&mut self.values, there),
            per_column,
            end: self.column,
        }
    }

    /// The rest of the run in which a column lies, from this column on, and goes to the end of the run: the column lies before
    /// it and in the span.
    #[inline(never)]
    pub(super) fn next_run(&mut self, column: i32) -> Run<A::Values> {
        let past = (self.column + self.first_column) & (A::STEP - 1);
        let next = self.column + A::STEP - past;
        let columns = next.min(self.end - 1) - self.column;
        self.depth += self.depth_per_column * Wrapping(columns as u32);
        let [per_column, there] = A::divided_run(self.planes, &mut self.dividends, &self.values, columns, self.depth);
        let mut run = Run {
            values: self.values,
            per_column,
            end: next.min(self.end),
        };
        if self.column < column {
            A::step_by(&mut run.values, &per_column, column - self.column);
        }
        (self.column, self.values) = (run.end, there);
        run
    }
}
