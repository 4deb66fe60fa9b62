//! The memory of antialiasing that all outlines of a picture share, because only one row is drawn at a time.

use core::fmt;

use crate::{
    coverage::edges::{ActiveEdge, RowSegment},
    geometry::{Table, TooSmall},
};

/// Memory for the antialiased outlines of a [`Picture`](crate::draw::Picture), which all of them share.
///
/// - `CELLS`: one more than the columns of a band, 4 bytes each. Wider bands are drawn in strips, which costs time.
/// - `SEGMENTS`: the most edges that one outline has in one row, 64 bytes each. Fewer are an error of
///   [`Picture::add`](crate::draw::Picture::add), which says how many are needed.
/// - `EDGES`: chains of edges that go on from row to row, of all outlines in a row together, 32 bytes each. Outlines that
///   find no room are begun anew in each row, which costs time.
///
/// All zero bits when new, so that a `static` lies in `.bss`.
pub struct AntialiasingMemory<const CELLS: usize, const SEGMENTS: usize, const EDGES: usize> {
    cells: [i32; CELLS],
    segments: [RowSegment; SEGMENTS],
    edges: [ActiveEdge; EDGES],
}

impl<const CELLS: usize, const SEGMENTS: usize, const EDGES: usize> AntialiasingMemory<CELLS, SEGMENTS, EDGES> {
    /// Memory in which nothing is drawn yet.
    pub const fn new() -> Self {
        Self {
            cells: [0; CELLS],
            segments: [RowSegment::EMPTY; SEGMENTS],
            edges: [ActiveEdge::FREE; EDGES],
        }
    }

    /// The memory, its capacities forgotten.
    pub(crate) const fn lend(&mut self) -> RowMemory<'_> {
        RowMemory {
            cells: &mut self.cells,
            segments: &mut self.segments,
            edges: &mut self.edges,
            most_segments: 0,
            most_edges: 0,
        }
    }
}

impl<const CELLS: usize, const SEGMENTS: usize, const EDGES: usize> Default
    for AntialiasingMemory<CELLS, SEGMENTS, EDGES>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<const CELLS: usize, const SEGMENTS: usize, const EDGES: usize> fmt::Debug
    for AntialiasingMemory<CELLS, SEGMENTS, EDGES>
{
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "AntialiasingMemory<{CELLS}, {SEGMENTS}, {EDGES}>")
    }
}

#[cfg(feature = "defmt")]
impl<const CELLS: usize, const SEGMENTS: usize, const EDGES: usize> defmt::Format
    for AntialiasingMemory<CELLS, SEGMENTS, EDGES>
{
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "AntialiasingMemory<{}, {}, {}>", CELLS, SEGMENTS, EDGES);
    }
}

/// An [`AntialiasingMemory`] of any capacities.
#[derive(Debug)]
pub(crate) struct RowMemory<'m> {
    /// The accumulation buffer of a row, all 0 between two rows.
    pub(super) cells: &'m mut [i32],
    /// The segments of the outline and row that are drawn.
    pub(super) segments: &'m mut [RowSegment],
    /// Edges that go on from row to row: each outline that is active has some of them, side by side.
    pub(super) edges: &'m mut [ActiveEdge],
    /// The most segments that a row of an outline was found to have.
    most_segments: usize,
    /// So many edges would have had room for all outlines that were active at the same time so far.
    most_edges: u16,
}

impl RowMemory<'_> {
    /// Room for nothing.
    pub(crate) const fn none() -> Self {
        Self {
            cells: &mut [],
            segments: &mut [],
            edges: &mut [],
            most_segments: 0,
            most_edges: 0,
        }
    }

    /// Whether there is room for a row of an outline that has so many segments at most.
    ///
    /// # Errors
    /// [`TooSmall`] with the cells or the segments that are needed.
    pub(crate) const fn check(&mut self, segments: usize) -> Result<(), TooSmall> {
        /// The cells of one column.
        const LEAST_CELLS: usize = 2;
        if segments > self.most_segments {
            self.most_segments = segments;
        }
        if self.cells.len() < LEAST_CELLS {
            Err(TooSmall {
                table: Table::Cells,
                needed: LEAST_CELLS,
            })
        } else if self.segments.len() < segments {
            Err(TooSmall {
                table: Table::ActiveEdges,
                needed: segments,
            })
        } else {
            Ok(())
        }
    }

    /// The most segments that there is room for in a row.
    pub(crate) const fn most_segments(&self) -> usize {
        self.segments.len()
    }

    /// The most segments that were asked for in a row, whether there was room for them or not.
    pub(crate) const fn segments_needed(&self) -> usize {
        self.most_segments
    }

    /// The most edges that were asked for at the same time, whether there was room for them or not.
    pub(crate) const fn edges_needed(&self) -> usize {
        self.most_edges as usize
    }

    /// Columns that are drawn at once.
    pub(super) const fn columns(&self) -> usize {
        self.cells.len().saturating_sub(1)
    }

    /// Reserves so many edges side by side, the first ones that are free, and returns the index of the first one. Cost: as
    /// many steps as there are edges.
    pub(super) fn reserve(&mut self, count: u16) -> Option<u16> {
        let mut free = 0;
        let len = u16::try_from(self.edges.len()).unwrap_or(u16::MAX);
        for index in 0..len {
            free = if self.edges.get(usize::from(index))?.is_free() {
                free + 1
            } else {
                0
            };
            if free >= count && count != 0 {
                let first = index + 1 - count;
                self.edges_at(first, count).fill(ActiveEdge::RESERVED);
                self.most_edges = self.most_edges.max(index + 1);
                return Some(first);
            }
        }
        // Those at the end that are free would be the first of them.
        self.most_edges = self.most_edges.max((len - free).saturating_add(count));
        None
    }

    /// Gives edges back.
    pub(super) fn free(&mut self, first: u16, count: u16) {
        self.edges_at(first, count).fill(ActiveEdge::FREE);
    }

    /// Gives all edges back.
    pub(crate) fn free_all(&mut self) {
        self.edges.fill(ActiveEdge::FREE);
    }

    /// So many edges from one on.
    pub(super) fn edges_at(&mut self, first: u16, count: u16) -> &mut [ActiveEdge] {
        let first = usize::from(first);
        self.edges
            .get_mut(first..first + usize::from(count))
            .unwrap_or_default()
    }
}
