//! Rows between two straight sides, each stepped by one addition.

use core::iter;

use fixed::{Wrapping, types::I12F20};

use crate::{geometry::Window, surface::Span};

/// Two trapezoids, the second right below the first, in a box of pixels of the target's window: a triangle's rows.
///
/// The box lies in the window. Sides may run out of the box, to its left and right: whoever draws cuts the rows to it.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Trapezoids {
    /// First row of the box, from the first one of the window.
    pub row: u32,
    /// First column of the box, from the first one of the window.
    pub column: u32,
    /// Columns of the box.
    pub columns: u32,
    /// The trapezoids that the shape is cut into, from top to bottom.
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

/// A straight side of a trapezoid: its column in the first row, and what each row adds. The whole part of a column counts, from
/// the first column of the box.
///
/// Columns are numbers modulo 2^12, from -2,048 to 2,047. So is the one after a row's last pixel: no row ends in column
/// 2,047.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct StraightSide {
    /// Column in the first row.
    pub column: I12F20,
    /// What each row adds.
    pub step: I12F20,
}

impl StraightSide {
    /// The part of the side that begins `rows` further down.
    #[inline]
    #[must_use]
    pub fn after(self, rows: i32) -> Self {
        let column = Wrapping(self.column) + Wrapping(self.step) * rows;
        Self {
            column: column.0,
            step: self.step,
        }
    }

    /// The column of the side in its first row, rounded down to a whole pixel.
    #[inline]
    pub fn pixel(self) -> i32 {
        self.column.to_bits() >> I12F20::FRAC_NBITS
    }
}

impl Trapezoids {
    /// Whether all rows and columns of the box are in the window.
    pub fn is_inside(&self, window: &Window) -> bool {
        let [upper, lower] = self.parts.each_ref().map(|part| part.rows);
        let fits = |start: u32, length: Option<u32>, room: u32| {
            length
                .and_then(|length| start.checked_add(length))
                .is_some_and(|end| end <= room)
        };
        fits(self.row, upper.checked_add(lower), window.height())
            && fits(self.column, Some(self.columns), window.width())
    }

    /// The spans of the trapezoids, clipped to their box, whose row and column count from those of the window. Some may
    /// be empty.
    pub fn spans(&self, window: &Window) -> impl Iterator<Item = Span> + use<> {
        let columns = i32::try_from(self.columns).unwrap_or(i32::MAX);
        // Inside the window if there is a row, or else its corner.
        let left = window.left.saturating_add_unsigned(self.column);
        let mut y = window.top.saturating_add_unsigned(self.row);
        self.parts
            .into_iter()
            .flat_map(Trapezoid::columns)
            .map(move |(first, end)| {
                let x = |column: i32| left + column.max(0).min(columns);
                let span = Span::new(y, x(first), x(end));
                y += 1;
                span
            })
    }
}

impl Trapezoid {
    /// The first column of each row, and the one after the last.
    fn columns(mut self) -> impl Iterator<Item = (i32, i32)> {
        self.right.column = (Wrapping(self.right.column) + Wrapping(I12F20::ONE)).0;
        iter::from_fn(move || {
            self.rows = self.rows.checked_sub(1)?;
            let columns = (self.left.pixel(), self.right.pixel());
            (self.left, self.right) = (self.left.after(1), self.right.after(1));
            Some(columns)
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
