//! Which edges of a face are silhouettes, in one word, and a walk over them.

// Not re-exported.
/// Which edges of a face are silhouettes, and the next face that has some in the same row; of a row the first such face, and
/// how many edges are active in it; of the first row also whether a face of the frame is cut.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FaceEdges(u32);

impl FaceEdges {
    /// The entry of a new table, for a face or for a row: all bits are zero.
    pub(super) const EMPTY: Self = Self(0);

    const DRAWN: u32 = 1 << 16;
    const COUNTED: u32 = 1 << 19;
    const ALL_COUNTED: u32 = 7 << 19;
    const ALL_DRAWN: u32 = 7 << 16;
    const FRONT: u32 = 1 << 22;
    const REVERSED: u32 = 1 << 23;
    const IS_CUT: u32 = 1 << 24;
    const LEFT_OUT: u32 = 1 << 25;
    const ALL_LEFT_OUT: u32 = 7 << 25;

    /// A face none of whose edges is known: seen in the order of its corners, the other way round, or not at all.
    pub(crate) fn seen(is_front: bool, is_reversed: bool) -> Self {
        Self(if is_front { Self::FRONT } else { 0 } | if is_reversed { Self::REVERSED } else { 0 })
    }

    /// A face that a plane cuts.
    pub(crate) const CUT: Self = Self(Self::IS_CUT);

    /// Whether the face is seen.
    pub(crate) fn is_seen(self) -> bool {
        self.0 & (Self::FRONT | Self::REVERSED) != 0
    }

    /// Whether the corners of the face run counterclockwise on the screen.
    pub(crate) fn is_reversed(self) -> bool {
        self.0 & Self::REVERSED != 0
    }

    /// The face with what its edge of that number is, where another face is on its other side: in the same surface, no
    /// silhouette; where that one is cut, it counts in the number of surfaces alone; else a silhouette.
    pub(crate) fn with_neighbour(self, edge: u32, neighbour: Self) -> Self {
        const SIDES: u32 = FaceEdges::FRONT | FaceEdges::REVERSED;
        if neighbour.is_cut() {
            Self(self.0 | Self::COUNTED << edge)
        } else if neighbour.0 & SIDES == self.0 & SIDES {
            self
        } else {
            Self(self.0 | (Self::COUNTED | Self::DRAWN) << edge)
        }
    }

    /// Whether the face has an edge that is a silhouette, or counts.
    pub(crate) fn has_any(self) -> bool {
        self.0 & Self::ALL_COUNTED != 0
    }

    /// The three edges of the face, and of each whether it is a silhouette or only counts in the number of surfaces.
    #[inline(always)]
    pub(crate) fn edges(self) -> EdgesLeft {
        EdgesLeft(self.0 & (Self::ALL_COUNTED | Self::ALL_DRAWN | Self::ALL_LEFT_OUT))
    }

    /// The face with its edge of that number left out of the active edges, or not.
    #[inline]
    #[must_use]
    pub(crate) fn with_left_out(self, edge: u32, is_left_out: bool) -> Self {
        let bit = Self::LEFT_OUT << edge;
        Self(if is_left_out { self.0 | bit } else { self.0 & !bit })
    }

    /// The number of silhouette edges that are active in a row, by the entry of the row.
    pub(crate) fn active(self) -> usize {
        usize::from((self.0 >> 16) as u8)
    }

    /// Whether the face is cut; of the first row, whether a face of the frame is.
    pub(crate) fn is_cut(self) -> bool {
        self.0 & Self::IS_CUT != 0
    }

    /// The entry of the first row of a frame, with a note that a face of the frame is cut.
    #[must_use]
    pub(crate) fn with_cut_face(self) -> Self {
        Self(self.0 | Self::IS_CUT)
    }

    /// The entry of a row, with so many silhouette edges that are active in the row.
    #[must_use]
    pub(crate) fn with_active(self, count: usize) -> Self {
        Self(self.0 & (Self::IS_CUT | 0xffff) | (count as u32) << 16)
    }

    /// The next face of the row, or `NONE`.
    pub(crate) fn next(self) -> u16 {
        self.0 as u16
    }

    /// The entry of a face or a row, with the node of the next face that has silhouettes beginning in the same row, or `NONE`.
    #[must_use]
    pub(crate) fn with_next(self, next: u16) -> Self {
        Self(self.0 & !0xffff | u32::from(next))
    }
}

/// The edges of a face that a walk over them has not come to: the bits of [`FaceEdges`], moved down by one for each edge
/// passed.
#[derive(Debug, Copy, Clone)]
pub(crate) struct EdgesLeft(u32);

impl EdgesLeft {
    /// Whether one of the edges left is a silhouette, or counts in the number of surfaces.
    #[inline(always)]
    pub(crate) fn has_any(self) -> bool {
        self.0 & FaceEdges::ALL_COUNTED != 0
    }

    /// Of the first of the edges left: whether it counts in the number of surfaces, and whether it is a silhouette.
    #[inline(always)]
    pub(crate) fn first(self) -> (bool, bool) {
        (self.0 & FaceEdges::COUNTED != 0, self.0 & FaceEdges::DRAWN != 0)
    }

    /// Whether the first of the edges left began above the row, and was left out of the active edges.
    #[inline(always)]
    pub(crate) fn is_left_out(self) -> bool {
        self.0 & FaceEdges::LEFT_OUT != 0
    }

    /// The edges left after the first of them.
    #[inline(always)]
    #[must_use]
    pub(crate) fn others(self) -> Self {
        Self(self.0 >> 1)
    }
}
