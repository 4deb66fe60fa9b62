//! Face against segment: each edge is compared with each face, and what no face hides is left.
//!
//! ```text
//!     P ------------------------------- Q      The whole edge begins with the first face. A face that hides its middle
//!            +---------+                       leaves two segments: the left one goes on with the next face, the right
//!     P -----|  face 0 |--------------- Q      one waits on a stack, with the face that it has to go on with.
//!            +---------+  +------+
//!     P -----             |face 1|----- Q      A segment that has come past the last face is visible. The next one is
//!     left            +---|-+    |             taken from the stack; what lies between the two is hidden.
//!     goes on         right, waits
//! ```
//!
//! The faces are in a list, the nearest ones first, each with the rectangle of pixels that it lies in. So a segment is past the
//! last face as soon as the rest of them lie behind all of the edge, and most of the others are left out by their rectangles.
//!
//! The left segment goes on first, so that segments leave the stack from the first to the second end of the edge. Where the
//! stack has no room for a right segment, that is dropped: what lies right of the left segment is then compared with all faces
//! once more.
//!
//! Guarantees: solids may be of any shape, open, concave or penetrating. A part is hidden exactly where a seen face covers it
//! and is nearer by more than a tolerance (2 units of depth, or 8 of depths with 24 bits, and what the depth of the face changes
//! over one unit of x and one of y); ends of parts are rounded to a unit. The size of the stack changes nothing in the parts.
//! Cost: for each edge a comparison of rectangles with each face that is nearer than the farthest end of the edge; the exact test
//! takes three to twelve products, most of them of 64 bits.
//!
//! Source: Galimberti and Montanari 1969, "An algorithm for hidden line elimination", for edges that are compared with the faces
//! of any solids; a stack of the segments that are left: Rogers 1985, "Procedural Elements for Computer Graphics".

mod segment_stack;

use crate::{
    geometry::TooSmall,
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::{
        face_box::{FaceBox, PixelBox, list_faces},
        hiding::HidingFace,
        intersection::for_each_intersection,
        line_part::LinePart,
        line_table::LineTable,
        method::Method,
        parts::{END, PartedLine, Parts},
    },
};
use segment_stack::{Segment, SegmentStack};

/// Each edge against each face, for solids of any shape ([`HiddenLines`](crate::visible::HiddenLines)): for at most so many
/// faces that are seen, with a stack of so many segments. Take it where solids are open or penetrate each other, or for a first
/// try.
///
/// A few segments are enough for the stack. With less room than an edge needs, down to none, edges of which nearer faces hide
/// several parts are compared with all faces once more for each of those parts; the parts are the same.
///
/// With `INTERSECTIONS`, the lines in which faces penetrate each other are handed over as well, after the edges. Two faces of
/// one model that have a corner in common do not penetrate each other, nor do those that only touch. It takes a comparison of
/// rectangles for each pair of faces.
///
/// RAM: 16 bytes a face, 12 bytes a segment, and 8.
///
/// Source: Galimberti and Montanari 1969; Rogers 1985.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FaceAgainstSegment<const FACES: usize, const STACK: usize, const INTERSECTIONS: bool = false> {
    faces: [FaceBox; FACES],
    segments: [Segment; STACK],
    counters: Counters,
}

/// What was counted.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Counters {
    faces_tested: u32,
    segments_repeated: u32,
}

impl<const FACES: usize, const STACK: usize, const INTERSECTIONS: bool>
    FaceAgainstSegment<FACES, STACK, INTERSECTIONS>
{
    /// Memory in which there are no faces yet.
    pub const fn new() -> Self {
        Self {
            faces: [FaceBox::EMPTY; FACES],
            segments: [Segment::EMPTY; STACK],
            counters: Counters {
                faces_tested: 0,
                segments_repeated: 0,
            },
        }
    }

    /// How often an edge was compared with a face since this was made, where their rectangles met.
    pub const fn faces_tested(&self) -> u32 {
        self.counters.faces_tested
    }

    /// How often a segment was compared with all faces once more since this was made, because the stack was full.
    pub const fn segments_repeated(&self) -> u32 {
        self.counters.segments_repeated
    }
}

impl<const FACES: usize, const STACK: usize, const INTERSECTIONS: bool> Default
    for FaceAgainstSegment<FACES, STACK, INTERSECTIONS>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<D: DepthWidth, const FACES: usize, const STACK: usize, const INTERSECTIONS: bool> Method<D>
    for FaceAgainstSegment<FACES, STACK, INTERSECTIONS>
{
    fn visible_parts<S, T>(&mut self, table: &T, part: &mut impl FnMut(LinePart<S>)) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        T: LineTable<S, D>,
    {
        let faces = list_faces(&mut self.faces, table)?;
        let mut search = Search {
            table,
            faces,
            stack: SegmentStack::new(&mut self.segments),
            counters: &mut self.counters,
        };
        for edge in table.edges() {
            search.find_parts::<S, D>(PartedLine::of(&edge), part);
        }
        if INTERSECTIONS {
            for_each_intersection(table, faces, |line| search.find_parts::<S, D>(line, part));
        }
        Ok(())
    }
}

/// The faces that edges are compared with, and the segments that wait.
struct Search<'s, T> {
    table: &'s T,
    /// The nearest ones first.
    faces: &'s [FaceBox],
    stack: SegmentStack<'s>,
    counters: &'s mut Counters,
}

impl<T> Search<'_, T> {
    /// Hands over a line in parts.
    fn find_parts<S, D>(&mut self, line: PartedLine, part: &mut impl FnMut(LinePart<S>))
    where
        S: ScreenPrecision,
        D: DepthWidth,
        T: LineTable<S, D>,
    {
        let mut parts = Parts::new(line, part);
        let mut next = Some(Segment {
            start: 0,
            end: END,
            face: 0,
        });
        while let Some(mut segment) = next {
            let dropped = self.cut_down::<S, D>(&mut segment, &line);
            parts.until(segment.start, true);
            parts.until(segment.end, false);
            next = match dropped {
                None => self.stack.pop(),
                Some(end) => {
                    self.counters.segments_repeated = self.counters.segments_repeated.saturating_add(1);
                    let start = segment.end;
                    Some(Segment { start, end, face: 0 })
                }
            };
        }
        parts.until(END, true);
        parts.finish();
    }

    /// Goes with a segment of a line through all faces that it was not compared with, and leaves the part of it that is visible
    /// and nearest to the first end of the line, which may be empty. Returns the end of what was dropped right of it, if the
    /// stack was full.
    fn cut_down<S, D>(&mut self, segment: &mut Segment, line: &PartedLine) -> Option<u32>
    where
        S: ScreenPrecision,
        D: DepthWidth,
        T: LineTable<S, D>,
    {
        let pixels = PixelBox::around::<S>(&line.ends);
        let [one, other] = line.ends.map(|end| end.depth);
        let mut dropped = None;
        for (place, face) in (segment.face..).zip(self.faces.iter().skip(usize::from(segment.face))) {
            if face.nearest <= one.min(other) {
                // This face and all that follow lie behind the line.
                break;
            }
            if !face.meets(&pixels) {
                continue;
            }
            let Some([start, end]) = self.hidden::<S, D>(face, line) else {
                continue;
            };
            if end <= segment.start || segment.end <= start {
                continue;
            }
            match (start <= segment.start, segment.end <= end) {
                (true, true) => {
                    segment.start = segment.end;
                    break;
                }
                (true, false) => segment.start = end,
                (false, true) => segment.end = start,
                (false, false) => {
                    let right = Segment {
                        start: end,
                        end: segment.end,
                        face: place.saturating_add(1),
                    };
                    if !self.stack.push(right) && dropped.is_none() {
                        dropped = Some(segment.end);
                    }
                    segment.end = start;
                }
            }
        }
        dropped
    }

    /// The part of a line that a face hides.
    fn hidden<S, D>(&mut self, face: &FaceBox, line: &PartedLine) -> Option<[u32; 2]>
    where
        S: ScreenPrecision,
        D: DepthWidth,
        T: LineTable<S, D>,
    {
        self.counters.faces_tested = self.counters.faces_tested.saturating_add(1);
        let face = self.table.face(usize::from(face.index))?;
        HidingFace::new(face.corners)?.hidden::<D>(line.ends)
    }
}
