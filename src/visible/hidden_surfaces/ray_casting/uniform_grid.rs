//! How a box is cut into cells of one size, and which of them a part of it meets.

use core::num::NonZeroU64;

use crate::visible::hidden_surfaces::ray_casting::eye_space::EyeBox;

/// The number of cells along an axis is two to the power of this at most.
const MOST_BITS: u32 = 6;

/// The most cells along an axis.
pub(super) const MOST_ALONG_AXIS: i32 = 1 << MOST_BITS;

/// The cells of a box along one axis: two to the power of `bits`, each of the same `size` (1 at least).
#[derive(Debug, Copy, Clone)]
pub(super) struct GridAxis {
    pub(super) least: i64,
    pub(super) size: i64,
    bits: u32,
}

impl GridAxis {
    /// An axis of a box from its least to its greatest coordinate.
    fn new(least: i64, greatest: i64, bits: u32) -> Self {
        Self {
            least,
            size: ((greatest - least) >> bits) + 1,
            bits,
        }
    }

    /// How many cells there are.
    pub(super) const fn cells(&self) -> i32 {
        1 << self.bits
    }

    /// The coordinate at which a cell begins.
    pub(super) fn boundary(&self, cell: i32) -> i64 {
        self.least + self.size * i64::from(cell)
    }

    /// The cell in which a coordinate lies, or the nearest one.
    pub(super) fn cell_of(&self, coordinate: i64) -> i32 {
        let size = NonZeroU64::new(self.size as u64).unwrap_or(NonZeroU64::MIN);
        let cell = (coordinate - self.least).max(0) as u64 / size;
        cell.min((self.cells() - 1) as u64) as i32
    }
}

/// A uniform grid: a box that is cut into cells along its three axes.
#[derive(Debug, Copy, Clone)]
pub(super) struct UniformGrid {
    pub(super) axes: [GridAxis; 3],
}

impl UniformGrid {
    /// A box, cut into at most so many cells, each cut across the axis along which cells are longest by the given sides of the
    /// box.
    pub(super) fn new(all: &EyeBox, sides: [u64; 3], most_cells: usize) -> Self {
        let (mut bits, mut sides) = ([0; 3], sides);
        let mut cells = 1;
        while 2 * cells <= most_cells {
            let mut longest: Option<(&mut u64, &mut u32)> = None;
            for (side, bits) in sides.iter_mut().zip(&mut bits) {
                let is_longest = longest.as_ref().is_none_or(|(longest, _)| *side > **longest);
                if *bits < MOST_BITS && is_longest {
                    longest = Some((side, bits));
                }
            }
            let Some((side, bits)) = longest else {
                break;
            };
            *side >>= 1;
            *bits += 1;
            cells *= 2;
        }
        let ([a, b, c], [d, e, f], [x, y, z]) = (all.least, all.greatest, bits);
        Self {
            axes: [GridAxis::new(a, d, x), GridAxis::new(b, e, y), GridAxis::new(c, f, z)],
        }
    }

    /// How many cells there are.
    pub(super) fn cells(&self) -> usize {
        let [x, y, z] = self.axes.map(|axis| axis.bits);
        1 << (x + y + z)
    }

    /// The index of a cell, by its number along each axis.
    pub(super) fn index(&self, [x, y, z]: [i32; 3]) -> usize {
        let [bits_x, bits_y, _] = self.axes.map(|axis| axis.bits);
        ((((z << bits_y) | y) << bits_x) | x) as usize
    }

    /// Visits the indices of all cells that a box meets, which lies in that of the grid.
    pub(super) fn for_each_cell(&self, part: &EyeBox, mut visit: impl FnMut(usize)) {
        let [x, y, z] = self.axes;
        let ([a, b, c], [d, e, f]) = (part.least, part.greatest);
        let (columns, rows) = (x.cell_of(a)..=x.cell_of(d), y.cell_of(b)..=y.cell_of(e));
        for layer in z.cell_of(c)..=z.cell_of(f) {
            for row in rows.clone() {
                for column in columns.clone() {
                    visit(self.index([column, row, layer]));
                }
            }
        }
    }
}
