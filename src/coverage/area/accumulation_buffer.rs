//! A row of pixels into which cells are added in any order, and the sweep that turns it into coverage.
//!
//! ```text
//!   cells added      pixel 2: cover 1, area 1/4      pixel 5: cover -1, area -1/2
//!   buffer           0    0   3/4  1/4   0  -1/2 -1/2   0      cover - area here, area in the next pixel
//!   sweep (sum)      0    0   3/4   1    1   1/2   0    0      the area of the shape in each pixel
//! ```
//!
//! The buffer keeps differences, one number a pixel, so that a cell's cover reaches every pixel to the right by adding to two
//! numbers. It is all zeros before and after each row.
//!
//! Source: the accumulation buffer of font-rs (Levien 2016), which is a summed-area table (Crow 1984) in one dimension.

use core::{num::Wrapping, ops::Range};

use crate::coverage::{
    Coverage,
    area::cell::{AREA_BITS, Cell, for_each_visible},
    edges::{X_BITS, X_ONE, chain_walk::PartSink},
    with_room,
};
use crate::geometry::offset_from;

/// The area of a whole pixel in fixed point.
pub(super) const AREA_ONE: i32 = 1 << AREA_BITS;

/// The differences of a row of pixels.
pub(super) struct AccumulationBuffer<'c> {
    pub(super) cells: &'c mut [i32],
    pub(super) columns: Range<i32>,
}

/// The columns, or as many of the first ones as there are cells for, and the cells of them: one more than columns, for what
/// lies right of them.
#[inline(always)]
pub(crate) fn in_room<'c>(columns: &Range<i32>, cells: &'c mut [i32]) -> (Range<i32>, &'c mut [i32]) {
    let columns = with_room(columns, cells.len().saturating_sub(1));
    let count = (columns.end - columns.start + 1) as usize;
    let (cells, _) = cells.split_at_mut(count.min(cells.len()));
    (columns, cells)
}

impl<'c> AccumulationBuffer<'c> {
    /// A buffer for the columns in which edges lie that reach from `start` to `end`, in 1/8192 pixel, or for as many of the
    /// first ones as there are cells for.
    #[inline(always)]
    pub(super) fn between([start, end]: [i32; 2], columns: &Range<i32>, cells: &'c mut [i32]) -> Self {
        let all = with_room(columns, cells.len().saturating_sub(1));
        let visible = |column: i32| column.max(all.start).min(all.end);
        let (first, last) = (visible(start >> X_BITS), visible((end >> X_BITS) + 1));
        // Two cells more than columns, for what lies right of them; one where the row ends there.
        let count = (last - first + 2) as usize;
        let (cells, _) = cells.split_at_mut(count.min(cells.len()));
        Self::of(first..last, cells)
    }

    /// A buffer for the columns, with a cell for each and one more.
    #[inline(always)]
    pub(super) fn of(columns: Range<i32>, cells: &'c mut [i32]) -> Self {
        Self { cells, columns }
    }

    /// Adds the cells of a part of an edge between `x_top` and `x_bottom`, in 1/8192 pixel. `height` is in 1/16384 pixel,
    /// negative where the winding number falls. Cost: a division where the part lies in two pixels, none where it lies in one.
    #[inline(always)]
    pub(super) fn add(&mut self, x_top: i32, x_bottom: i32, height: i32) {
        if (x_top ^ x_bottom) as u32 >> X_BITS == 0 {
            if let Some([here, next]) = self.cells_from(x_top) {
                Cell::within([x_top, x_bottom], height).add_to(here, next);
                return;
            }
        }
        // Which end is the upper one does not matter to an area.
        let (start, end) = (x_top.min(x_bottom), x_top.max(x_bottom));
        if (end >> X_BITS) - (start >> X_BITS) == 1 {
            if let Some([here, next, after]) = self.cells_from(start) {
                let [cell, second] = Cell::in_two([start, end], height);
                cell.add_to(here, next);
                second.add_to(next, after);
                return;
            }
        }
        self.add_long([start, end], height);
    }

    /// The differences of the pixel that `x`, in 1/8192 pixel, lies in, and of the next ones.
    #[inline(always)]
    fn cells_from<const COUNT: usize>(&mut self, x: i32) -> Option<&mut [i32; COUNT]> {
        // As an unsigned number, a column left of the row is far right of it.
        let first = offset_from(self.columns.start, x >> X_BITS) as usize;
        // Beyond the number range, where the end wraps, there is no cell either.
        self.cells.get_mut(first..first.wrapping_add(COUNT))?.first_chunk_mut()
    }

    /// Adds the cells of a part of an edge that lies in three pixels or more, or leaves the row. Cost: two divisions.
    #[inline(never)]
    fn add_long(&mut self, [start, end]: [i32; 2], height: i32) {
        if (end >> X_BITS) - (start >> X_BITS) == 2 {
            if let Some([here, next, after, last]) = self.cells_from(start) {
                let [cell, second, third] = Cell::in_three([start, end], height);
                cell.add_to(here, next);
                second.add_to(next, after);
                third.add_to(after, last);
                return;
            }
        }
        let left = Wrapping(self.columns.start) * Wrapping(X_ONE);
        let ends = [start, end].map(|x| (Wrapping(x) - left).0);
        let width = self.columns.end - self.columns.start;
        for_each_visible(ends, height, width, |cell| {
            let first = cell.x as usize;
            if let Some([here, next]) = self.cells.get_mut(first..first + 2) {
                cell.add_to(here, next);
            }
        });
    }

    /// `column`, clamped to the columns of the buffer and the one after its last.
    #[inline(always)]
    pub(super) fn visible(&self, column: i32) -> i32 {
        column.max(self.columns.start).min(self.columns.end)
    }

    /// The differences of `columns`, which the buffer has, and the two after them, as far as there are any.
    #[inline(always)]
    pub(super) fn differences(&mut self, columns: &Range<i32>) -> &mut [i32] {
        let [first, end] = [columns.start, columns.end].map(|x| (x - self.columns.start) as usize);
        let end = (end + 2).min(self.cells.len());
        self.cells.get_mut(first..end).unwrap_or_default()
    }

    /// The differences of all columns.
    #[inline(always)]
    pub(super) fn visible_differences(&mut self) -> &mut [i32] {
        let width = (self.columns.end - self.columns.start) as usize;
        self.cells.get_mut(..width).unwrap_or_default()
    }

    /// Empties the buffer: after an error, and right of the columns, where nobody reads it.
    pub(super) fn clear(&mut self) {
        self.cells.fill(0);
    }
}

impl PartSink for AccumulationBuffer<'_> {
    #[inline]
    fn add_part(&mut self, (x_top, x_bottom): (i32, i32), height: i32) {
        self.add(x_top, x_bottom, height);
    }
}

/// Converts an area to coverage in 255ths, rounded to the nearest. An area below 0 counts as none, one of more than a
/// pixel as a whole pixel.
#[inline(always)]
pub(super) fn coverage_of(area: i32) -> Coverage {
    // Limited to a power of two less 1, for which some processors have an instruction: that has the coverage of a whole
    // pixel.
    rounded(area.clamp(0, AREA_ONE - 1) as u32)
}

/// Converts an area without its sign to coverage in 255ths, rounded to the nearest. An area of more than a pixel counts as a
/// whole pixel.
#[inline(always)]
pub(super) fn coverage_of_size(area: u32) -> Coverage {
    if HAS_SATURATION {
        coverage_of(area as i32)
    } else {
        rounded(area.min(AREA_ONE as u32 - 1))
    }
}

/// Whether one instruction limits a number to a power of two less 1, and below to 0, as `usat` does.
const HAS_SATURATION: bool = cfg!(all(target_arch = "arm", target_has_atomic = "32"));

/// Converts an area of less than a pixel to coverage in 255ths, rounded to the nearest.
#[inline(always)]
pub(super) fn rounded(area: u32) -> Coverage {
    ((area * 255 + AREA_ONE as u32 / 2) >> AREA_BITS) as Coverage
}
