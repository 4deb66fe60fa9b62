//! The plane of a number over the screen, in 32-bit arithmetic modulo 2^32.

use core::num::Wrapping;

// Not re-exported: what a face keeps of its corners is the library's own.
/// A number that changes evenly over the screen: its value at an origin, and what it gains from pixel to pixel.
///
/// Sums may wrap on the way, so that what arrives at a pixel whose number fits is right, however steep the plane is.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScreenPlane {
    /// The number at the first column of the rows, in row 0 of the picture.
    pub origin: Wrapping<u32>,
    /// What the number gains from one pixel to the next.
    pub per_column: Wrapping<u32>,
    /// What the number gains from one row to the next.
    pub per_row: Wrapping<u32>,
}

impl ScreenPlane {
    /// The plane that is 0 everywhere.
    pub const ZERO: Self = Self {
        origin: Wrapping(0),
        per_column: Wrapping(0),
        per_row: Wrapping(0),
    };

    /// The number at a pixel, by its column in the row.
    #[inline]
    pub fn at(&self, column: i32, row: i32) -> Wrapping<u32> {
        self.origin + self.per_row * Wrapping(row as u32) + self.per_column * Wrapping(column as u32)
    }
}
