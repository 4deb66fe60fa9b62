//! Rows between two straight sides, each stepped by one addition.

use core::iter;

use fixed::types::I12F20;

use crate::{geometry::Window, target::Span};

/// Two trapezoids, the second right below the first, in a box of pixels of the target's window: a triangle's rows.
///
/// Sides may run out of the box, to its left and right: whoever draws cuts the rows to it.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Trapezoids {
    /// First row of the box, from the first one of the window.
    pub row: u32,
    /// First column of the box, from the first one of the window.
    pub column: u32,
    /// Columns of the box.
    pub columns: u32,
    /// From top to bottom.
    pub parts: [Trapezoid; 2],
}

/// Rows between two straight sides; there may be none.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Trapezoid {
    /// Number of rows.
    pub rows: u32,
    /// Column of the first pixel.
    pub left: StraightSide,
    /// Column of the last pixel.
    pub right: StraightSide,
}

/// A column in the first row, and from one row to the next; its whole part counts, from the first one of the box.
///
/// The column after the last row may wrap.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct StraightSide {
    /// In the first row.
    pub column: I12F20,
    /// What each row adds.
    pub step: I12F20,
}

impl StraightSide {
    /// From `rows` further down on.
    #[inline(always)]
    #[must_use]
    pub fn after(self, rows: i32) -> Self {
        let moved = self.step.to_bits().wrapping_mul(rows);
        Self {
            column: self.column.wrapping_add(I12F20::from_bits(moved)),
            step: self.step,
        }
    }

    /// The whole part of its column in the first row.
    #[inline(always)]
    pub fn pixel(self) -> i32 {
        self.column.to_bits() >> I12F20::FRAC_NBITS
    }
}

impl Trapezoids {
    /// The spans, clipped to the box, which is in the window. Some may be empty.
    pub fn spans(&self, window: &Window) -> impl Iterator<Item = Span> + use<> {
        let columns = self.columns as i32;
        let left = window.left.wrapping_add_unsigned(self.column);
        let mut y = window.top.wrapping_add_unsigned(self.row);
        self.parts
            .into_iter()
            .flat_map(Trapezoid::pixels)
            .map(move |(first, last)| {
                let end = last.wrapping_add(1).min(columns).max(0);
                let span = Span::new(y, left.wrapping_add(first.max(0)), left.wrapping_add(end));
                y = y.wrapping_add(1);
                span
            })
    }
}

impl Trapezoid {
    /// First and last column of each row.
    fn pixels(mut self) -> impl Iterator<Item = (i32, i32)> {
        iter::from_fn(move || {
            self.rows = self.rows.checked_sub(1)?;
            let pixels = (self.left.pixel(), self.right.pixel());
            (self.left, self.right) = (self.left.after(1), self.right.after(1));
            Some(pixels)
        })
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for StraightSide {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "{} by {} in 1/2^20",
            self.column.to_bits(),
            self.step.to_bits()
        );
    }
}
