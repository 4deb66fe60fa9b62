//! The shapes of a styled stroke one by one, each by a number: for strokes of which a part is needed at a time.
//!
//! ```text
//!      1                    the segment that begins at vertex 1 has shapes 0, 1 and 2: its dashes, or only shape 0,
//!     / \                   and the join at vertex 1 is its shape JOIN
//!    o   \ == == == 2
//! ```
//!
//! A shape is a convex polygon and up to two discs at its ends. Of vertices at one position that follow each other, the last one
//! counts. A path whose vertices all lie at one position is a dot: shape 0 of vertex 0.
//!
//! Guarantees: the shapes of [`StyledStroke`], the same corners. Cost: two square roots for shapes of one segment that follow each
//! other, and a step for each dash before them.

use core::ops::Range;

use crate::scan::stroke::{
    segment_dashes::{Ruler, SegmentDashes, StrokeEnds, distance},
    styled_stroke::{Primitive, StrokeSegment, StyledStroke},
    wide_stroke::{Corner, Segment},
};

/// The number of a join among the shapes of the segment behind it.
pub(crate) const JOIN: u16 = u16::MAX;

/// A shape: its polygon, which may have no corners, and the centres of its discs.
pub(crate) type Shape<'s> = (&'s [Corner], [Option<Corner>; 2]);

/// Bits of a state above the position in the pattern of dashes.
const BEGINS: u64 = 1 << 63;
const ENDS: u64 = 1 << 62;

/// What a segment is like besides its vertices.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct SegmentState {
    /// Where in the pattern of dashes it begins, below 2^57; 0 in a solid stroke.
    position: i64,
    /// Whether its begin is an end of the stroke.
    begins: bool,
    /// Whether its end is one.
    ends: bool,
}

impl SegmentState {
    /// Words of a state.
    pub(crate) const WORDS: usize = 2;

    pub(crate) fn to_words(self) -> [u32; Self::WORDS] {
        let flags = [(self.begins, BEGINS), (self.ends, ENDS)];
        let bits = flags.into_iter().filter(|(is_set, _)| *is_set).map(|(_, bit)| bit);
        let word = self.position as u64 | bits.sum::<u64>();
        [word as u32, (word >> 32) as u32]
    }

    pub(crate) const fn of_words([low, high]: [u32; Self::WORDS]) -> Self {
        let word = low as u64 | (high as u64) << 32;
        Self {
            position: (word & (ENDS - 1)) as i64,
            begins: word & BEGINS != 0,
            ends: word & ENDS != 0,
        }
    }

    const fn stroke_ends(self) -> StrokeEnds {
        StrokeEnds {
            begins: self.begins,
            ends: self.ends,
        }
    }
}

impl StyledStroke<'_> {
    /// The state of the segment that begins at a vertex, in a solid stroke.
    pub(crate) fn solid_state(&self, vertex: usize) -> SegmentState {
        let path = &self.path;
        let (_, to) = path.segment(vertex);
        SegmentState {
            position: 0,
            // A closed path has one before each segment.
            begins: path.before(vertex).is_none(),
            ends: !path.closed && path.after(vertex, to).is_none(),
        }
    }

    /// Whether the stroke can be generated shape by shape: no vertex is too far out, and no segment has more than so many dashes.
    pub(crate) fn has_at_most(&self, dashes: u16) -> bool {
        let mut fits = self.is_near();
        if let Some(cycle) = &self.dashes {
            self.each_segment(&mut |segment| {
                let mut others = cycle.dashes(segment.position, segment.length, (0, segment.length));
                fits &= others.nth(dashes.into()).is_none();
            });
        }
        fits
    }

    /// Calls with the state of each segment, and the number of the vertex that it begins at.
    pub(crate) fn each_state(&self, call: &mut dyn FnMut(usize, SegmentState)) {
        self.each_segment(&mut |segment| call(segment.number, segment.state()));
    }

    /// Calls with each shape, the number of the vertex at which its segment begins, and its number there.
    pub(crate) fn each_numbered_shape(&self, call: &mut dyn FnMut(usize, u16, Shape<'_>)) {
        let mut has_segment = false;
        self.each_segment(&mut |segment| {
            has_segment = true;
            let number = segment.number;
            self.numbered_shapes(number, segment.state(), 0..JOIN, &mut |shape, polygon| {
                call(number, shape, polygon);
            });
            if segment.comes_in {
                self.join_at(number, &mut |polygon| call(number, JOIN, polygon));
            }
        });
        if !has_segment {
            self.dot(None, &mut |primitive| call(0, 0, primitive.shape()));
        }
    }

    /// Generates the shapes with some numbers of the segment that begins at a vertex, each with its number.
    pub(crate) fn numbered_shapes(
        &self,
        vertex: usize,
        state: SegmentState,
        numbers: Range<u16>,
        call: &mut dyn FnMut(u16, Shape<'_>),
    ) {
        let (from, to) = self.path.segment(vertex);
        if from == to {
            return self.dot(None, &mut |primitive| call(0, primitive.shape()));
        }
        let mut segment = Segment::new(from, to);
        let Some(cycle) = &self.dashes else {
            return self.solid(&mut segment, state.stroke_ends(), None, &mut |primitive| {
                call(0, primitive.shape())
            });
        };
        let dashes = SegmentDashes {
            cycle,
            position: state.position,
            length: distance(from, to),
            ends: state.stroke_ends(),
        };
        let Some(ruler) = Ruler::along(&segment, dashes.length) else {
            return;
        };
        let all = dashes.between(0, dashes.length);
        for (number, dash) in numbers.clone().zip(all.skip(numbers.start.into())) {
            let part = (ruler.at(dash.from), ruler.at(dash.to));
            let ends = dashes.ends_of(&dash, &ruler);
            self.part(&mut segment, part, ends, None, &mut |primitive| {
                call(number, primitive.shape())
            });
        }
    }

    /// Generates what the join at a vertex adds.
    pub(crate) fn join_at(&self, vertex: usize, call: &mut dyn FnMut(Shape<'_>)) {
        let (from, to) = self.path.segment(vertex);
        if let Some(before) = self.path.before(vertex) {
            let (mut before, mut after) = (Segment::new(before, from), Segment::new(from, to));
            self.corner(&mut before, &mut after, None, &mut |primitive| call(primitive.shape()));
        }
    }
}

impl StrokeSegment {
    const fn state(&self) -> SegmentState {
        SegmentState {
            position: self.position,
            begins: self.ends.begins,
            ends: self.ends.ends,
        }
    }
}

impl<'p> Primitive<'p> {
    const fn shape(&self) -> Shape<'p> {
        (self.corners, self.discs)
    }
}
