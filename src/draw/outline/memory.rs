//! The memory of antialiasing that all outlines of a picture share, because only one row is drawn at a time.

use core::{fmt, ops::Range};

use crate::{
    coverage::{
        ByReference, CoverageMethod, Emit, RowParts,
        edges::{ActiveEdge, RowSegment},
    },
    draw::{FillRule, antialiased::DOMAIN},
    geometry::TooSmall,
    scan::polygon::edge_table::insertion_sort,
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
///
/// [`Antialiased`](crate::draw::Antialiased) has an example, and
/// [`Picture::edges_needed`](crate::draw::Picture::edges_needed) one of how to find the capacities.
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

impl<'m> RowMemory<'m> {
    /// Room for a row of one outline, of which nothing is kept for the next row.
    pub(crate) const fn of(cells: &'m mut [i32], segments: &'m mut [RowSegment]) -> Self {
        Self {
            cells,
            segments,
            edges: &mut [],
            most_segments: 0,
            most_edges: 0,
        }
    }
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
            Err(TooSmall::PictureCells(LEAST_CELLS))
        } else if self.segments.len() < segments {
            Err(TooSmall::Segments(segments))
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

    /// The room for the segments of a row.
    pub(crate) const fn segments_mut(&mut self) -> &mut [RowSegment] {
        self.segments
    }

    /// The cells of a row, one more than the columns that are drawn at once, all 0 between two rows.
    pub(crate) const fn cells_mut(&mut self) -> &mut [i32] {
        self.cells
    }

    /// Puts the first segments into the order of their left ends.
    pub(crate) fn sort_segments(&mut self, count: usize) {
        sort_by_left(self.segments.get_mut(..count).unwrap_or_default());
    }

    /// Hands over what the first segments cover in some columns of their row, by a method that is exact for them: spans of equal
    /// coverage, from left to right. The segments are in order of their left ends. Nothing is handed over where there is no room
    /// for so many.
    #[inline(always)]
    pub(crate) fn cover_columns<E>(
        &mut self,
        count: usize,
        method: &impl CoverageMethod<Cell = i32>,
        fill_rule: FillRule,
        columns: Range<i32>,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        // Columns that are drawn at once.
        let step = i32::try_from(self.cells.len().saturating_sub(1)).unwrap_or(i32::MAX);
        let Some(segments) = self.segments.get_mut(..count) else {
            return Ok(());
        };
        // Columns outside the domain are cut off: their position in 1/8192 pixel could overflow.
        let (mut start, end) = (columns.start.max(DOMAIN.start), columns.end.min(DOMAIN.end));
        while start < end {
            let strip = start..end.min(start.saturating_add(step));
            if start > columns.start {
                // The method may have put them into another order.
                sort_by_left(segments);
            }
            start = strip.end;
            method.cover_row(segments, fill_rule, strip, self.cells, ByReference(emit))?;
        }
        Ok(())
    }

    /// A list for the parts of edges in some columns, without those outside the domain; `None` where there are not a cell for
    /// each column and one more.
    #[inline(always)]
    pub(super) fn parts_in<'c>(cells: &'c mut [i32], columns: &Range<i32>) -> Option<RowParts<'c>> {
        let columns = columns.start.max(DOMAIN.start)..columns.end.min(DOMAIN.end);
        if columns.is_empty() {
            return None;
        }
        // In the domain, so that the difference is in the number range.
        let width = (columns.end - columns.start) as usize;
        Some(RowParts::new(&columns, cells.get_mut(..=width)?))
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

/// Puts segments into the order of their left ends.
pub(super) fn sort_by_left(segments: &mut [RowSegment]) {
    insertion_sort(segments, 1, |segment| segment.ends().0);
}
