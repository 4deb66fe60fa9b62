//! The rows of an outline with sub-pixel edges, each as the segments that lie in it: y-monotone chains of edges and an active
//! edge table (Wylie et al. 1967).
//!
//! The segments of a row stay in one table. From row to row each of them steps by an addition, as long as no edge begins or
//! ends; in rows where one does (event rows) ended edges give way to their successors, and chains that begin are added. After
//! either, the table is in order by left ends but for edges that crossed: an insertion sort.
//!
//! Guarantees: every visible row in which an edge lies, top to bottom, once. Cost: about 20 instructions for each edge in
//! a row, besides what is done with it.

use core::ops::Range;

use heapless::VecView;

use crate::{
    coverage::edges::{RowSegment, monotone_chains::Chains},
    geometry::distance,
    scan::polygon::edge_table::insertion_sort,
};

/// Hands over the segments of each row, from left to right by their left ends. `segments` has room for all edges in one
/// row.
///
/// # Errors
/// The first error that `cover` returns.
pub(crate) fn scan<E>(
    mut chains: Chains<'_>,
    segments: &mut VecView<RowSegment>,
    rows: Range<i32>,
    mut cover: impl FnMut(i32, &mut [RowSegment]) -> Result<(), E>,
) -> Result<(), E> {
    segments.clear();
    let mut row = chains.first_row().max(rows.start);
    let mut event_row = row;
    while row < rows.end {
        if row < event_row {
            step(segments);
        } else {
            event_row = update(&mut chains, segments, row);
        }
        if segments.is_empty() {
            row = event_row;
        } else {
            cover(row, segments.as_mut_slice())?;
            row += 1;
        }
    }
    Ok(())
}

/// Steps all segments to a row that every edge passes.
#[inline]
pub(crate) fn step(segments: &mut [RowSegment]) {
    let (mut last, mut differences) = (i32::MIN / 2, 0);
    let mut rest = &mut *segments;
    while let [segment, others @ ..] = rest {
        segment.step();
        let left = segment.ends().0;
        // One test for all segments: negative where one is left of the segment before it.
        differences |= left - last;
        (last, rest) = (left, others);
    }
    if differences < 0 {
        sort_by_left(segments);
    }
}

/// Brings the segments to a row where edges begin or end, and returns the next such row: those before it are passed by all
/// edges.
#[inline(never)]
pub(crate) fn update(chains: &mut Chains<'_>, segments: &mut VecView<RowSegment>, row: i32) -> i32 {
    segments.retain_mut(|segment| {
        let Some(edge) = chains.get(segment.edge_index()) else {
            return false;
        };
        if segment.last_row() >= row {
            segment.step_to(row, edge.ends_x()[1]);
            return true;
        }
        // A successor that starts inside the previous row was pushed there; only one that starts at this row's top is taken
        // over here.
        let successor = chains.successor(segment.edge_index(), edge);
        let successor = successor.filter(|(_, successor)| successor.first_row() == row);
        successor
            .map(|(index, successor)| *segment = successor.begin_at(index, row))
            .is_some()
    });
    while let Some((index, edge)) = chains.begin(row) {
        let pushed = segments.push(edge.begin_at(index, row));
        debug_assert!(pushed.is_ok(), "there is room for all edges in a row");
    }
    // Successors that start inside this row, and theirs; and the next event row. Chains that have not begun begin below this
    // row.
    let next_row = row + 1;
    let mut event_row = chains.first_row();
    let mut index = 0usize;
    while let Some(segment) = segments.get(index) {
        index += 1;
        let last_row = segment.last_row();
        if last_row > row {
            // An edge that begins inside this row does not pass it, but the next one.
            let event = if segment.y_top > 0 { next_row } else { last_row };
            event_row = event_row.min(event);
            continue;
        }
        event_row = next_row;
        let edge = chains.get(segment.edge_index());
        let successor = edge.and_then(|edge| chains.successor(segment.edge_index(), edge));
        if let Some((index, successor)) = successor.filter(|(_, successor)| successor.first_row() == row) {
            let pushed = segments.push(successor.begin_at(index, row));
            debug_assert!(pushed.is_ok(), "there is room for all edges in a row");
        }
    }
    sort_by_left(segments);
    event_row
}

pub(crate) fn sort_by_left(segments: &mut [RowSegment]) {
    insertion_sort(segments, 1, |segment| segment.ends().0);
}

/// The visible rows of an outline, for a [`CoverageMethod`](crate::coverage::CoverageMethod) to go through.
#[derive(Debug)]
pub struct Rows<'r> {
    pub(crate) chains: Chains<'r>,
    /// The active edge table, with room for all edges in one row.
    pub(crate) segments: &'r mut VecView<RowSegment>,
    pub(crate) rows: Range<i32>,
    /// How many rows the outline has, visible or not.
    pub(crate) height: usize,
}

/// Below 40 bounding-box pixels an edge, an accumulation buffer is faster than sorted segments (measured on 16 px glyphs).
const DENSE_PIXELS_PER_EDGE: usize = 40;

impl Rows<'_> {
    /// Whether there are few pixels for the number of edges, if the outline is about as wide as it is high. In a window that is
    /// much lower than the outline, such as a band of one row, summing up densely does not pay: what it has to look up first
    /// takes as long as the rows.
    #[inline]
    pub(crate) fn are_dense(&self) -> bool {
        let rows = distance(self.rows.start, self.rows.end) as usize;
        let pixels = self.height.saturating_mul(self.height);
        pixels < self.chains.edges().saturating_mul(DENSE_PIXELS_PER_EDGE) && rows >= self.height / 2
    }

    /// Hands over the segments of each row, from left to right by their left ends.
    ///
    /// # Errors
    /// The first error that `cover` returns.
    #[inline]
    pub fn for_each<E>(self, cover: impl FnMut(i32, &mut [RowSegment]) -> Result<(), E>) -> Result<(), E> {
        scan(self.chains, self.segments, self.rows, cover)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Rows<'_> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Rows {} to {} of {} edges",
            self.rows.start,
            self.rows.end,
            self.chains.edges()
        );
    }
}
