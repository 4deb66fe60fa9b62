//! The numbers of a part's vertices: row by row, so that cells share their corners without a search for equal ones.

use super::parts::{Part, Pole};

/// A part whose patches are cut into `cells` by `cells`, and its first vertex.
#[derive(Copy, Clone)]
pub(super) struct Grid<'p> {
    pub(super) part: &'p Part,
    pub(super) cells: usize,
    first: usize,
}

impl<'p> Grid<'p> {
    pub(super) const fn new(part: &'p Part, cells: usize, first: usize) -> Self {
        Self { part, cells, first }
    }

    /// Rows of cells.
    pub(super) const fn rows(&self) -> usize {
        self.part.patches.len() / self.part.columns * self.cells
    }

    /// Cells of a row.
    pub(super) const fn columns(&self) -> usize {
        self.part.columns * self.cells
    }

    /// Vertices of a row that is not a pole: at the seam there are two.
    const fn width(&self) -> usize {
        self.columns() + !self.part.mirrored as usize
    }

    /// Whether all vertices of a row are at one point.
    pub(super) const fn is_pole(&self, row: usize) -> bool {
        match self.part.pole {
            Pole::First => row == 0,
            Pole::Last => row == self.rows(),
            Pole::None => false,
        }
    }

    /// The first vertex of a row; of the row after the last, the first that is no vertex of the part.
    const fn row_start(&self, row: usize) -> usize {
        let poles_before = match self.part.pole {
            Pole::First => row > 0,
            Pole::Last => row > self.rows(),
            Pole::None => false,
        } as usize;
        self.first + (row - poles_before) * self.width() + poles_before * self.part.columns
    }

    /// The first vertex that is none of the part's.
    pub(super) const fn end(&self) -> usize {
        self.row_start(self.rows() + 1)
    }

    /// The vertex at a corner of a cell of a column of patches. A pole has a vertex for each of these columns.
    pub(super) const fn vertex(&self, patch_column: usize, row: usize, column: usize) -> usize {
        self.row_start(row)
            + if self.is_pole(row) {
                patch_column
            } else {
                column % self.width()
            }
    }

    /// Faces of the grid: two a cell, and one where a side is a point.
    pub(super) const fn face_count(&self) -> usize {
        let poles = !matches!(self.part.pole, Pole::None) as usize;
        (2 * self.rows() - poles) * self.columns()
    }

    /// The texture coordinates at a corner of a cell of a column of patches; of a pole, in the middle of the column.
    pub(super) const fn coordinates(&self, patch_column: usize, row: usize, column: usize) -> [i16; 2] {
        let (step, cells) = (self.part.u_step as i64, self.cells as i64);
        let around = if self.part.mirrored && column > self.columns() / 2 {
            self.columns() - column
        } else {
            column
        };
        let u = if self.is_pole(row) {
            step * patch_column as i64 + step / 2
        } else {
            step * around as i64 / cells
        };
        let (patch_row, within) = (row / self.cells, (row % self.cells) as i64);
        let above = self.part.v[patch_row] as i64;
        let v = if within == 0 {
            above
        } else {
            above + (self.part.v[patch_row + 1] as i64 - above) * within / cells
        };
        [u as i16, v as i16]
    }
}
