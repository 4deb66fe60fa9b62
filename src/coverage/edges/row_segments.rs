//! The rows of a polygon with sub-pixel edges, each as the segments that lie in it: chains of edges and an active edge table
//! (Wylie et al. 1967) for antialiasing.
//!
//! Guarantees: every visible row in which an edge lies, top to bottom, once. Cost: about 20 instructions for each edge in
//! a row, besides what is done with it.

use core::ops::Range;

use heapless::VecView;

use crate::{
    coverage::edges::{RowSegment, edge_chains::Chains},
    scan::polygon::edge_table::insertion_sort,
};

/// Hands over the segments of each row, from left to right by their left ends. `segments` has room for all edges in one
/// row.
///
/// # Errors
/// The first of `cover`.
pub(crate) fn scan<E>(
    mut chains: Chains<'_>,
    segments: &mut VecView<RowSegment>,
    rows: Range<i32>,
    mut cover: impl FnMut(i32, &mut [RowSegment]) -> Result<(), E>,
) -> Result<(), E> {
    segments.clear();
    let mut row = chains.first_row().max(rows.start);
    // Before that row no edge begins or ends.
    let mut next_end = row;
    while row < rows.end {
        if row < next_end {
            step(segments);
        } else {
            next_end = change(&mut chains, segments, row);
        }
        if segments.is_empty() {
            row = next_end;
        } else {
            cover(row, segments.as_mut_slice())?;
            row = row.wrapping_add(1);
        }
    }
    Ok(())
}

/// Goes on to a row where all edges go on.
#[inline(always)]
fn step(segments: &mut [RowSegment]) {
    let (mut last, mut differences) = (i32::MIN / 2, 0);
    let mut rest = &mut *segments;
    while let [segment, others @ ..] = rest {
        segment.step();
        let left = segment.ends().0;
        // One question for all of them: negative where one is.
        differences |= left.wrapping_sub(last);
        (last, rest) = (left, others);
    }
    if differences < 0 {
        sort_by_left(segments);
    }
}

/// Goes on to a row where edges begin or end: the next row of that kind.
#[inline(never)]
fn change(chains: &mut Chains<'_>, segments: &mut VecView<RowSegment>, row: i32) -> i32 {
    segments.retain_mut(|segment| {
        let Some(edge) = chains.get(segment.place_in_table()) else {
            return false;
        };
        if segment.last_row() >= row {
            segment.advance(row, edge.ends()[1][0]);
            return true;
        }
        // What goes on from within the row above is in the table.
        let below = chains.below(segment.place_in_table(), edge);
        let below = below.filter(|(_, below)| below.first_row() == row);
        below
            .map(|(place, below)| *segment = below.begin_at(place, row))
            .is_some()
    });
    while let Some((place, edge)) = chains.begin(row) {
        // There is room: see above.
        let _ = segments.push(edge.begin_at(place, row));
    }
    // What goes on within the row below those that end in it.
    let mut index = 0usize;
    while let Some(segment) = segments.get(index) {
        if segment.last_row() == row {
            let edge = chains.get(segment.place_in_table());
            let below = edge.and_then(|edge| chains.below(segment.place_in_table(), edge));
            if let Some((place, below)) = below.filter(|(_, below)| below.first_row() == row) {
                let _ = segments.push(below.begin_at(place, row));
            }
        }
        index = index.wrapping_add(1);
    }
    sort_by_left(segments);
    let next_row = row.wrapping_add(1);
    // What begins in this row has its top there, not in the next one.
    let next_end = |segment: &RowSegment| {
        if segment.y_top > 0 {
            next_row
        } else {
            segment.last_row().max(next_row)
        }
    };
    segments.iter().map(next_end).fold(chains.first_row(), i32::min)
}

fn sort_by_left(segments: &mut [RowSegment]) {
    insertion_sort(segments, 1, |segment| segment.ends().0);
}

/// The rows of an outline that are visible: for a tier to walk through.
#[derive(Debug)]
pub struct Rows<'r> {
    pub(crate) chains: Chains<'r>,
    /// Has room for all edges in one row.
    pub(crate) segments: &'r mut VecView<RowSegment>,
    pub(crate) rows: Range<i32>,
    /// How many rows the outline has, visible or not.
    pub(crate) height: usize,
}

/// With fewer pixels an edge, what lies between edges is not worth a question.
const PIXELS_PER_EDGE: usize = 40;

impl Rows<'_> {
    /// Whether the rows are short for the number of edges, if the outline is about as wide as it is high. A window that is
    /// much lower than that, such as a band of one row, has too few of them for what has to be found out first.
    #[inline(always)]
    pub(crate) fn are_crowded(&self) -> bool {
        let rows = self.rows.end.wrapping_sub(self.rows.start) as usize;
        let pixels = self.height.saturating_mul(self.height);
        pixels < self.chains.edges().saturating_mul(PIXELS_PER_EDGE) && rows >= self.height / 2
    }

    /// Hands over the segments of each row, from left to right by their left ends.
    ///
    /// # Errors
    /// The first of `cover`.
    #[inline(always)]
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
