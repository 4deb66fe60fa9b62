//! Capacities of a [`Picture`](zrow::draw::Picture).

/// How large the tables of a picture are, or how much of each is taken.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
pub struct PictureCapacities {
    /// Slots, one an item.
    pub slots: usize,
    /// Words of the pool.
    pub words: usize,
    /// Segments of one antialiased item in one row.
    pub segments: usize,
    /// Chains of edges that go on from row to row, of all antialiased items together.
    pub edges: usize,
    /// Rectangles of what changes.
    pub damage_areas: usize,
}

impl PictureCapacities {
    /// The larger one of each capacity: tables of these sizes hold two pictures, one at a time.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self {
            slots: self.slots.max(other.slots),
            words: self.words.max(other.words),
            segments: self.segments.max(other.segments),
            edges: self.edges.max(other.edges),
            damage_areas: self.damage_areas.max(other.damage_areas),
        }
    }
}
