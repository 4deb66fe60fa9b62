//! The parts of an edge that wait for the faces which they were not compared with yet.

/// A part of an edge between two parameters, that no face before one hides.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Segment {
    pub(super) start: u32,
    pub(super) end: u32,
    /// The place in the list of the face to go on with.
    pub(super) face: u16,
}

impl Segment {
    /// The entry of a new stack: all bits are zero.
    pub(super) const EMPTY: Self = Self {
        start: 0,
        end: 0,
        face: 0,
    };
}

/// A stack of segments, in memory that is lent. The last one that was pushed is that nearest to the first end of the edge.
#[derive(Debug)]
pub(super) struct SegmentStack<'s> {
    segments: &'s mut [Segment],
    filled: usize,
}

impl<'s> SegmentStack<'s> {
    pub(super) const fn new(segments: &'s mut [Segment]) -> Self {
        Self { segments, filled: 0 }
    }

    /// Whether there was room for a segment.
    pub(super) fn push(&mut self, segment: Segment) -> bool {
        let Some(free) = self.segments.get_mut(self.filled) else {
            return false;
        };
        *free = segment;
        self.filled += 1;
        true
    }

    pub(super) fn pop(&mut self) -> Option<Segment> {
        self.filled = self.filled.checked_sub(1)?;
        self.segments.get(self.filled).copied()
    }
}
