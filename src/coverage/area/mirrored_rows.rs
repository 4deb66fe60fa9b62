//! The areas of the rows of an outline whose right half is the mirror image of its left half.
//!
//! ```text
//!            axis            The left half is one y-monotone chain, which is walked down edge by edge. The coverage of a
//!      .-o---|---o-.         pixel on it is that of its mirror image too, and all pixels between the two are covered by as
//!    o'      |      'o       much as the row is high. In the column of the axis both halves lack the same area.
//!   /        |        \
//!  o         |         o     Half of the edges are set up, walked, cut into cells and converted to coverage.
//! ```
//!
//! Guarantees: the pixels of the left half are those of the rows from all edges. Those of the right half are their mirror
//! images, of which the coverage from all edges differs by at most 1, where heights at the sides of pixels are rounded the
//! other way.

use core::{num::Wrapping, ops::Range};

use crate::coverage::{
    Coverage, Emit, EmitRows,
    area::{
        accumulation_buffer::{AREA_ONE, in_room},
        row_parts::RowParts,
        sparse_row::{ColumnSides, CurrentCell},
    },
    edges::{
        RowSegment, Rows, Y_ONE,
        chain_walk::{ChainWalk, PartSink, signed},
    },
};

/// Hands over the pixels of all rows.
///
/// # Errors
/// The first error that `emit` returns.
#[inline(never)]
pub(super) fn cover_all<E>(
    rows: Rows<'_>,
    mirror: Mirror,
    cells: &mut [i32],
    coverage: impl Fn(i32) -> Coverage,
    emit: &mut impl EmitRows<E>,
) -> Result<(), E> {
    let (half, cells) = in_room(&mirror.left_half(), cells);
    let Rows { mut chains, rows, .. } = rows;
    let mut row = chains.first_row().max(rows.start);
    let (mut event_row, mut entry) = (row, None::<RowSegment>);
    while row < rows.end {
        let walk = ChainWalk::to(row);
        let mut parts = RowParts::new(&half, cells);
        match &mut entry {
            Some(entry) if row < event_row => {
                parts.add_part(entry.step_bottom(), signed(Y_ONE, entry.winding));
            }
            _ => {
                if let Some(last) = &mut entry {
                    if !walk.step_down(&chains, last, &mut parts) {
                        entry = None;
                    }
                }
                // Behind a level edge another chain goes on: of those that begin in a row one passes its bottom, or none.
                while let Some((index, edge)) = chains.begin(row) {
                    if let Some(begun) = walk.begin(&chains, index, edge, &mut parts) {
                        entry = Some(begun);
                    }
                }
                let end = entry.as_ref().map_or(i32::MAX, RowSegment::last_row);
                event_row = end.min(chains.first_row());
            }
        }
        mirror.cover_parts(&mut parts, &coverage, &mut emit.row(row))?;
        if event_row == i32::MAX {
            return Ok(());
        }
        row += 1;
    }
    Ok(())
}

/// Which pixels are mirror images of each other, and which of them are visible.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Mirror {
    /// The sum of a column and its mirror image.
    sum: i32,
    columns: [i32; 2],
}

impl Mirror {
    /// The visible columns, and the sum of a column and its mirror image.
    #[inline(always)]
    pub(crate) fn of(sum: i32, columns: &Range<i32>) -> Self {
        Self {
            sum,
            columns: [columns.start, columns.end],
        }
    }

    /// Hands over the pixels of a row, from the parts of edges of the left half in it, and takes all parts out.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    #[inline(always)]
    pub(super) fn cover_parts<E>(
        self,
        parts: &mut RowParts<'_>,
        coverage: impl Fn(i32) -> Coverage,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        let sides = ColumnSides::of(&parts.buffer.columns);
        let mut target = MirroredRow { emit, mirror: self };
        let current = parts.cover_but_last(sides, &coverage, &mut target)?;
        target.finish(&current, &coverage)
    }

    /// The columns of the left half that are visible, or whose mirror images are: no more than there are visible ones.
    #[inline(always)]
    pub(crate) fn left_half(self) -> Range<i32> {
        let [left, right] = self.columns;
        let center = self.sum >> 1;
        let last = if center < left {
            self.sum - left
        } else {
            center.min(right - 1)
        };
        left.min(self.sum - right + 1)..last + 1
    }
}

/// A row that takes the pixels of the left half, and their mirror images with them.
struct MirroredRow<'e, T> {
    emit: &'e mut T,
    mirror: Mirror,
}

impl<T> MirroredRow<'_, T> {
    /// Emits the last pixel of the left half, and what lies between it and its mirror image.
    #[inline(always)]
    fn finish<E>(&mut self, current: &CurrentCell, coverage: impl Fn(i32) -> Coverage) -> Result<(), E>
    where
        T: Emit<E>,
    {
        let Mirror {
            sum,
            columns: [left, right],
        } = self.mirror;
        let cell = &current.0;
        if cell.cover == Wrapping(0) {
            return Ok(());
        }
        let mirrored = sum - cell.x;
        if mirrored < cell.x {
            return Ok(());
        }
        if mirrored == cell.x {
            let coverage = coverage((cell.cover - cell.area - cell.area).0);
            return if coverage != 0 && left <= cell.x && cell.x < right {
                self.emit.pixel(cell.x, coverage)
            } else {
                Ok(())
            };
        }
        let first = current.coverage(&coverage);
        if cell.cover.0.abs() == AREA_ONE && left <= cell.x && mirrored < right {
            return self.emit.between(cell.x..mirrored + 1, first, first);
        }
        self.visible_between(cell.x..mirrored + 1, first, coverage(cell.cover.0))
    }

    /// Emits those pixels of a span that are visible, of which the first and the last one are covered otherwise.
    #[inline(never)]
    fn visible_between<E>(&mut self, columns: Range<i32>, ends: Coverage, inside: Coverage) -> Result<(), E>
    where
        T: Emit<E>,
    {
        let [left, right] = self.mirror.columns;
        let (start, end) = ((columns.start + 1).max(left), (columns.end - 1).min(right));
        if start < end && inside != 0 {
            self.emit.span(start..end, inside)?;
        }
        self.visible_pixels([columns.start, columns.end - 1], ends)
    }

    /// Emits those of two pixels that are visible.
    #[inline(never)]
    fn visible_pixels<E>(&mut self, columns: [i32; 2], coverage: Coverage) -> Result<(), E>
    where
        T: Emit<E>,
    {
        let [left, right] = self.mirror.columns;
        for x in columns {
            if left <= x && x < right && coverage != 0 {
                self.emit.pixel(x, coverage)?;
            }
        }
        Ok(())
    }
}

impl<E, T: Emit<E>> Emit<E> for MirroredRow<'_, T> {
    #[inline(always)]
    fn pixel(&mut self, x: i32, coverage: Coverage) -> Result<(), E> {
        let Mirror {
            sum,
            columns: [left, right],
        } = self.mirror;
        let mirrored = sum - x;
        if left <= x && mirrored < right {
            self.emit.two_pixels([x, mirrored], coverage)
        } else {
            self.visible_pixels([x, mirrored], coverage)
        }
    }

    #[inline(never)]
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), E> {
        let Mirror {
            sum,
            columns: [left, right],
        } = self.mirror;
        let mirrored = sum - columns.end + 1..sum - columns.start + 1;
        for columns in [columns, mirrored] {
            let (start, end) = (columns.start.max(left), columns.end.min(right));
            if start < end {
                self.emit.span(start..end, coverage)?;
            }
        }
        Ok(())
    }
}
