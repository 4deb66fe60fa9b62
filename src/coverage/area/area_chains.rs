//! The area of a shape of many short edges: each piece goes into the row memory as soon as it is cut off.
//!
//! Guarantees: the same pixels as row by row from segments. Nothing is put into order, because areas add up in any order,
//! and a chain of edges is one entry in the table, however many of them lie in a row. Cost: about 30 instructions an edge
//! and row, and one a pixel of the row. (As font-rs, Levien 2016, of which the row memory is.)

use core::ops::Range;

use heapless::VecView;

use crate::{
    coverage::{
        Coverage,
        area::area_row::{AreaRow, CrowdedRow},
        edges::{HEIGHT_BITS, RowSegment, SubEdge, UNIT, edge_chains::Chains, row_segments::Rows, sub_edge::Place},
    },
    surface::Span,
};

/// How many pixels are passed as quickly as an edge is asked for its ends.
const PIXELS_PER_QUESTION: usize = 8;

/// Hands over the spans of all rows. The table has room for all edges in one row.
///
/// # Errors
/// The first of `emit`.
#[inline(never)]
pub(crate) fn cover<E>(
    rows: Rows<'_>,
    columns: &Range<i32>,
    cells: &mut [i32],
    coverage: impl Fn(i32) -> Coverage,
    mut emit: impl FnMut(Span, Coverage) -> Result<(), E>,
) -> Result<(), E> {
    let Rows {
        mut chains,
        segments: begun,
        rows,
        height,
    } = rows;
    begun.clear();
    // With fewer pixels an edge, to look for its ends takes longer than to pass those where no shape is.
    let pixels = height.saturating_mul(columns.len());
    let area = if pixels < chains.edges().saturating_mul(PIXELS_PER_QUESTION) {
        AreaRow::new(columns, cells)
    } else {
        AreaRow::between(chains.ends(), columns, cells)
    };
    let mut row_area = RowArea {
        area: CrowdedRow::new(area),
        row: 0,
        row_bottom: 0,
    };
    let mut row = chains.first_row().max(rows.start);
    while row < rows.end {
        row_area.row = row;
        row_area.row_bottom = row.wrapping_add(1).wrapping_mul(UNIT);
        let mut index = 0usize;
        while let Some(edge) = begun.get_mut(index) {
            if row_area.go_down(&chains, edge) {
                index = index.wrapping_add(1);
            } else {
                swap_remove(begun, index);
            }
        }
        while let Some((place, edge)) = chains.begin(row) {
            row_area.begin(&chains, place, edge, begun);
        }
        let handed_over = row_area.area.hand_over(&coverage, |columns, coverage| {
            emit(Span::new(row, columns.start, columns.end), coverage)
        });
        if handed_over.is_err() {
            row_area.area.clear();
            return handed_over;
        }
        row = if begun.is_empty() {
            chains.first_row()
        } else {
            row.wrapping_add(1)
        };
    }
    row_area.area.clear();
    Ok(())
}

/// Puts the last segment where one has ended. (That of `heapless` panics where there is none, which the compiler cannot
/// rule out.)
#[inline(always)]
fn swap_remove(segments: &mut VecView<RowSegment>, index: usize) {
    if let Some(last) = segments.pop() {
        if let Some(ended) = segments.get_mut(index) {
            *ended = last;
        }
    }
}

/// A row to which pieces of edges are added.
struct RowArea<'c> {
    area: CrowdedRow<'c>,
    row: i32,
    /// In units.
    row_bottom: i32,
}

impl RowArea<'_> {
    /// Adds what of a chain lies in the row; whether it goes on below.
    #[inline(always)]
    fn go_down(&mut self, chains: &Chains<'_>, segment: &mut RowSegment) -> bool {
        if segment.end_y() > self.row_bottom {
            let ends = segment.fall();
            self.add(ends, UNIT, segment.winding);
            return true;
        }
        let left_over = segment.end_y().wrapping_sub(self.row_bottom).wrapping_add(UNIT);
        let place = segment.place_in_table();
        let Some(edge) = chains.get(place) else { return false };
        if left_over > 0 {
            self.add((segment.bottom_x(), edge.columns()[1]), left_over, segment.winding);
        }
        let below = chains.below(place, edge);
        below.is_some_and(|(place, edge)| self.enter(chains, segment, place, edge))
    }

    /// Adds what a chain covers that begins in the row or above it, and puts the chain into the table of active ones if it
    /// reaches into the next row.
    #[inline(never)]
    fn begin<'e>(
        &mut self,
        chains: &Chains<'e>,
        mut place: Place,
        mut edge: &'e SubEdge,
        begun: &mut VecView<RowSegment>,
    ) {
        let mut segment = RowSegment::before(edge);
        if edge.first_row() < self.row {
            segment = edge.begin_at(place, self.row);
            self.add(segment.ends(), segment.y_bottom, segment.winding);
            if segment.end_y() > self.row_bottom {
                let _ = begun.push(segment);
                return;
            }
            let Some(below) = chains.below(place, edge) else { return };
            (place, edge) = below;
        }
        if self.enter(chains, &mut segment, place, edge) {
            let _ = begun.push(segment);
        }
    }

    /// Adds what lies in the row of a chain whose edges above end in the row or above; whether it goes on below.
    #[inline(never)]
    fn enter<'e>(
        &mut self,
        chains: &Chains<'e>,
        segment: &mut RowSegment,
        mut place: Place,
        mut edge: &'e SubEdge,
    ) -> bool {
        let winding = segment.winding;
        loop {
            let [[_, y_top], [_, y_bottom]] = edge.ends();
            let height = self.row_bottom.wrapping_sub(y_top);
            if y_bottom > self.row_bottom {
                if height > 0 {
                    let ends = segment.fall_along(place, edge, height);
                    self.add(ends, height, winding);
                } else {
                    segment.wait_below(place.wrapping_sub(winding as Place), y_top);
                }
                return true;
            }
            self.add(edge.columns().into(), y_bottom.wrapping_sub(y_top), winding);
            let Some(below) = chains.below(place, edge) else {
                return false;
            };
            (place, edge) = below;
        }
    }

    #[inline(always)]
    fn add(&mut self, (x_top, x_bottom): (i32, i32), height: i32, winding: i32) {
        self.area
            .add(x_top, x_bottom, (height << HEIGHT_BITS).wrapping_mul(winding));
    }
}
