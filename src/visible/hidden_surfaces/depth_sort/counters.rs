//! What a depth sort has done.

/// What a [`DepthSort`](super::DepthSort) has done since it was made.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct DepthSortCounters {
    /// Rows that were painted without a sort, because no two faces had a column in common.
    pub disjoint_rows: u32,
    /// Pairs of faces that were tested, because their depths overlap.
    pub pairs: u32,
    /// Pairs of which test A found that they have no column or no row of pixels in common.
    pub extents_apart: u32,
    /// Pairs of which test B found the first face behind the plane of the other one, or C the other one in front of that of
    /// the first.
    pub ordered_by_planes: u32,
    /// Pairs of which test D found that their projections do not overlap.
    pub projections_apart: u32,
    /// Pairs whose stored depths were compared, row by row.
    pub compared_in_rows: u32,
    /// Faces that were moved to the front of the list.
    pub moves: u32,
    /// Faces and parts that were split.
    pub splits: u32,
    /// Faces and parts that were painted together with the others of their cycle, because there was no room to split them.
    pub in_cycles: u32,
    /// Pixels whose stored depths were compared one by one.
    pub pixels_compared: u32,
}

impl DepthSortCounters {
    /// Nothing was done.
    pub(super) const NONE: Self = Self {
        disjoint_rows: 0,
        pairs: 0,
        extents_apart: 0,
        ordered_by_planes: 0,
        projections_apart: 0,
        compared_in_rows: 0,
        moves: 0,
        splits: 0,
        in_cycles: 0,
        pixels_compared: 0,
    };
}

/// Counts: no frame takes so long that a counter ends.
pub(super) fn add(counter: &mut u32, number: u32) {
    *counter = counter.saturating_add(number);
}
