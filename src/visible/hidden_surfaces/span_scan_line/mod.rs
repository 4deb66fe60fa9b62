//! The interval (span) scan-line algorithm: a row is cut where another face comes to be seen, and each interval is shaded once.
//!
//! ```text
//!     spans of the faces that cross a row, in the order of their first columns
//!
//!     A   |--------------------|              B begins in front of A: A is seen up to there.
//!     B          |-----------------|          C begins behind B, and stays behind at B's end: not seen.
//!     C              |---|                    D begins behind B and is nearer at B's end: they go through each other
//!     D                 |--------------|      where B is cut.
//!
//!     seen    AAAAAAABBBBBBBBBBBDDDDDDDD      three intervals: what is hidden is never shaded
//! ```
//!
//! The depth of a face gains the same integer from one column to the next, and its sums do not wrap in pixels that it covers. So
//! two faces that cover some columns are compared at the first and the last of these: who is nearer at both ends is nearer in
//! between. Where the one that is nearer changes, bisection finds the column.
//!
//! Of each face that crosses the row only its columns and its slot in the frame's active list are kept, in the order of first
//! columns, which is much the same from row to row. Its depth plane is looked up in the slot where depths are compared.
//!
//! What is compared by all methods are stored depths, without the fraction: two faces may be equally near in some columns, where
//! the first in the order of models is seen, and not in others. So a face is taken for hidden at an end only if it is a whole
//! unit of depth farther, or not nearer and later in the order; the columns that are left are compared one by one.
//!
//! Guarantees: the picture of the depth row; a pixel is shaded at most once. Cost: see [`SpanScanLine`].
//!
//! Source: Wylie, Romney, Evans and Erdahl 1967, "Half-tone perspective drawings by computer"; Bouknight 1970, "A procedure for
//! generation of three-dimensional half-toned computer graphics presentations"; Watkins 1970, "A real time visible surface
//! algorithm"; Foley, van Dam, Feiner and Hughes 1990, section 15.6.

mod comparison;
mod row_span;
mod sorted_spans;
mod unsorted_spans;

use comparison::{Comparison, Counters};
use sorted_spans::SortedSpans;
use unsorted_spans::{draw_set_up_anew, draw_unsorted};

use crate::{
    geometry::{TooSmall, Window},
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        active_faces::ActiveList,
        face_table::{FaceTable, NONE},
        painter::Painter,
        visibility::{Method, NewMethod},
    },
};

/// The interval (span) scan-line algorithm ([`Visibility`](crate::visible::Visibility)) for rows that up to `ACTIVE` faces cross. Take it for few large
/// faces that overlap and whose pixels take long to shade: each pixel is shaded once, and no row of depths is read or written.
/// Forty large textured faces, four deep in the mean pixel, take a third of the instructions of the depth row; a torus of many
/// small faces in one colour each takes 2.1 times as many.
///
/// RAM: 6 bytes a face that crosses a row, which is 3 an active edge, and up to 20 more. With the column, error term and step of the
/// edge itself that is 11 bytes at 1/16 pixel: like the depth planes, these are in the slots of the frame's memory, which the
/// depth row uses, too. A row with more faces than `ACTIVE` is drawn more slowly, and one with more than the frame has slots far
/// more slowly, because each face is then set up twice for each interval: the picture is the same.
///
/// Cost of a row: for each interval a comparison of depths at both ends with each face that is there, and setting up what varies
/// over the face that is seen; then its pixels. Bands from top to bottom carry the faces on.
///
/// What was done is counted from when the method was made, modulo 2^32.
///
/// Source: Wylie and others 1967; Watkins 1970.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SpanScanLine<const ACTIVE: usize> {
    spans: SortedSpans<ACTIVE>,
    counters: Counters,
}

impl<const ACTIVE: usize> SpanScanLine<ACTIVE> {
    /// The method, with nothing drawn.
    pub const fn new() -> Self {
        Self {
            spans: SortedSpans::EMPTY,
            counters: Counters::ZERO,
        }
    }

    /// The intervals that were handed over to be shaded, in each of which one face is seen.
    pub const fn intervals(&self) -> u32 {
        self.counters.intervals
    }

    /// How often two faces were found to go through each other, or to change places in order, inside an interval.
    pub const fn splits(&self) -> u32 {
        self.counters.splits
    }

    /// How often the depths of two faces were compared at a column.
    pub const fn comparisons(&self) -> u32 {
        self.counters.comparisons
    }

    /// How many of the [`comparisons`](Self::comparisons) were made column by column, because two faces were nearer to each
    /// other than a unit of depth.
    pub const fn pixels_compared(&self) -> u32 {
        self.counters.pixels_compared
    }
}

impl<const ACTIVE: usize> Default for SpanScanLine<ACTIVE> {
    fn default() -> Self {
        Self::new()
    }
}

impl<D: DepthWidth, const ACTIVE: usize> NewMethod<D> for SpanScanLine<ACTIVE> {
    const NEW: Self = Self::new();
}

impl<D: DepthWidth, const ACTIVE: usize> Method<D> for SpanScanLine<ACTIVE> {
    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        let width = window.width() as i32;
        for row in window.top..window.bottom {
            let at = [window.left, row];
            let mut comparison = Comparison::new(faces, &mut self.counters);
            let Some(list) = painter.active().and_then(|list| entered(list, faces, at)) else {
                draw_set_up_anew(&mut comparison, at, width, painter);
                continue;
            };
            if self.spans.take_up(list.in_use(), width) {
                self.spans.draw(&mut comparison, row, painter);
            } else {
                draw_unsorted(&mut comparison, row, width, painter);
            }
            if let Some(list) = painter.active() {
                list.take_all_down(row);
            }
        }
        Ok(())
    }
}

/// The active list at a row that begins at a column: all faces that cross it are set up in the first slots. `None` where there
/// are too few slots; then the list is entered anew at the next row.
fn entered<'l, S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
    list: &'l mut ActiveList<S, H>,
    faces: &F,
    [left, row]: [i32; 2],
) -> Option<&'l mut ActiveList<S, H>> {
    // The constant first: looks without passes, in which all rows fit, link none of this.
    if F::DRAWS_IN_PASSES && list.needs_passes() {
        if list.passes.crossing(faces, row) > list.capacity() {
            list.next_row = i32::MIN;
            return None;
        }
        // Of faces that have ended above the row, more may have begun in one row than there are slots.
        list.begin_passes(faces, [left, row]);
        return Some(list);
    }
    if list.next_row == row && list.first_column == left && !list.disjoint {
        list.close_gaps();
        let first = faces.first_in_row(row);
        if first != NONE {
            list.begin_faces(faces, first, false);
        }
    } else {
        list.first_column = left;
        list.enter(faces, row, false);
    }
    list.next_row = row + 1;
    Some(list)
}
