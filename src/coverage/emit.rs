//! Where coverage goes: the pixels of a row, one by one along an edge and in spans between edges.
//!
//! ```text
//!     edge       edge
//!   . 1 5 F F F F F A 2 .        pixel, pixel, span, pixel, pixel: from left to right
//! ```
//!
//! A pixel on an edge has a coverage of its own, and most that are handed over are such: a target takes them without what a span
//! needs, its second end and a loop. Closures take all of them as spans.

use core::ops::Range;

use crate::{coverage::Coverage, surface::Span};

/// Takes the pixels of a row that have coverage.
pub trait Emit<E> {
    /// Takes a pixel.
    ///
    /// # Errors
    /// That of whatever takes it.
    #[inline(always)]
    fn pixel(&mut self, x: i32, coverage: Coverage) -> Result<(), E> {
        self.span(x..x + 1, coverage)
    }

    /// Takes pixels of equal coverage.
    ///
    /// # Errors
    /// That of whatever takes them.
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), E>;
}

impl<E, F: FnMut(Range<i32>, Coverage) -> Result<(), E>> Emit<E> for F {
    #[inline(always)]
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), E> {
        self(columns, coverage)
    }
}

/// What takes the pixels of a row, lent for a part of it.
#[derive(Debug)]
pub struct ByReference<'e, T>(pub(crate) &'e mut T);

impl<E, T: Emit<E>> Emit<E> for ByReference<'_, T> {
    #[inline(always)]
    fn pixel(&mut self, x: i32, coverage: Coverage) -> Result<(), E> {
        self.0.pixel(x, coverage)
    }

    #[inline(always)]
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), E> {
        self.0.span(columns, coverage)
    }
}

#[cfg(feature = "defmt")]
impl<T> defmt::Format for ByReference<'_, T> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "ByReference");
    }
}

/// Takes the pixels of an outline that have coverage, row by row.
pub trait EmitRows<E> {
    /// What takes the pixels of one row.
    type Row<'r>: Emit<E>
    where
        Self: 'r;

    /// Begins a row.
    fn row(&mut self, y: i32) -> Self::Row<'_>;
}

impl<E, F: FnMut(Span, Coverage) -> Result<(), E>> EmitRows<E> for F {
    type Row<'r>
        = RowOf<'r, F>
    where
        Self: 'r;

    #[inline(always)]
    fn row(&mut self, y: i32) -> RowOf<'_, F> {
        RowOf { y, emit: self }
    }
}

/// A row whose pixels go to a closure that takes spans of any row.
#[derive(Debug)]
pub struct RowOf<'r, F> {
    y: i32,
    emit: &'r mut F,
}

impl<E, F: FnMut(Span, Coverage) -> Result<(), E>> Emit<E> for RowOf<'_, F> {
    #[inline(always)]
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), E> {
        (self.emit)(Span::new(self.y, columns.start, columns.end), coverage)
    }
}

#[cfg(feature = "defmt")]
impl<F> defmt::Format for RowOf<'_, F> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "RowOf {}", self.y);
    }
}
