//! Rows between two straight sides, each stepped by one addition.

use core::iter;

use fixed::types::I12F20;

use crate::{geometry::Window, target::Span};

/// Rows between two straight sides.
///
/// Columns count from the first column of the target's window, rows from its first row. Every row lies in the window;
/// sides may lie beside it: whoever draws cuts the rows to the columns `first` to `last`.
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
    /// No row begins left of this column, which is in the window.
    pub first: i32,
    /// No row ends right of this column, which is in the window or, where nothing is visible, left of it.
    pub last: i32,
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
    pub fn spans(&self, window: &Window) -> impl Iterator<Item = Span> + use<> {
        let mut rest = *self;
        let Window { left, top, .. } = *window;
        iter::from_fn(move || {
            rest.rows = rest.rows.checked_sub(1)?;
            let first = (rest.left.column.to_bits() >> I12F20::FRAC_NBITS).max(rest.first);
            let last = (rest.right.column.to_bits() >> I12F20::FRAC_NBITS).min(rest.last);
            // Within the window, or left of it and empty.
            let column = |column: i32| left.wrapping_add(column.max(0));
            let span = Span::new(
                top.wrapping_add_unsigned(rest.row),
                column(first),
                column(last.wrapping_add(1)),
            );
            rest.row = rest.row.wrapping_add(1);
            rest.left.advance();
            rest.right.advance();
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
