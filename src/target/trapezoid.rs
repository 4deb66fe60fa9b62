//! Rows between two straight sides, each stepped by one addition.

use core::iter;

use fixed::types::I12F20;

use crate::{geometry::Window, target::Span};

/// Rows between two straight sides.
///
/// Columns count from the first column of the target's window, rows from its first row. Every row lies in the window;
/// columns may lie beside it, and are clipped by whoever draws.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Trapezoid {
    /// First row.
    pub row: u32,
    /// Number of rows.
    pub rows: u32,
    /// Column of the first pixel: the whole part.
    pub left: StraightSide,
    /// Column of the last pixel: the whole part.
    pub right: StraightSide,
}

/// A column in the first row, and from one row to the next. The column after the last row may wrap.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct StraightSide {
    /// In the first row.
    pub column: I12F20,
    /// What each row adds.
    pub step: I12F20,
}

impl StraightSide {
    /// To the next row.
    #[inline(always)]
    pub fn advance(&mut self) {
        self.column = self.column.wrapping_add(self.step);
    }
}

impl Trapezoid {
    /// The spans, clipped to the window in which the columns and rows count. Some may be empty.
    pub fn spans(mut self, window: &Window) -> impl Iterator<Item = Span> + use<> {
        let Window { left, top, .. } = *window;
        let width = i32::try_from(window.width()).unwrap_or(i32::MAX);
        iter::from_fn(move || {
            self.rows = self.rows.checked_sub(1)?;
            let start = self.left.column.to_bits() >> I12F20::FRAC_NBITS;
            let end = (self.right.column.to_bits() >> I12F20::FRAC_NBITS).wrapping_add(1);
            // Within the window once they are clipped.
            let column = |column: i32| left.wrapping_add(column.clamp(0, width));
            let span = Span::new(top.wrapping_add_unsigned(self.row), column(start), column(end));
            self.row = self.row.wrapping_add(1);
            self.left.advance();
            self.right.advance();
            Some(span)
        })
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Trapezoid {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Trapezoid of {} rows from {}: {} to {} by {} and {} in 1/2^20",
            self.rows,
            self.row,
            self.left.column.to_bits(),
            self.right.column.to_bits(),
            self.left.step.to_bits(),
            self.right.step.to_bits()
        );
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
