//! Takers of the covered pixels of a row: a coverage method hands them over one by one along an edge, and in spans between edges.
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

/// Takes the pixels that a shape covers in a row: a target's blender, or a closure that gets all of them as spans.
pub trait Emit<E> {
    /// Takes the pixel of a column, and how much of it is covered.
    ///
    /// # Errors
    /// The error of the target or the closure that takes the pixel.
    #[inline(always)]
    fn pixel(&mut self, x: i32, coverage: Coverage) -> Result<(), E> {
        self.span(x..x + 1, coverage)
    }

    /// Takes the pixels of two columns, both covered as much.
    ///
    /// # Errors
    /// The error of the target or the closure that takes the pixels.
    #[inline(always)]
    fn two_pixels(&mut self, columns: [i32; 2], coverage: Coverage) -> Result<(), E> {
        columns.into_iter().try_for_each(|x| self.pixel(x, coverage))
    }

    /// Takes the pixels of some columns, all covered as much.
    ///
    /// # Errors
    /// The error of the target or the closure that takes the pixels.
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), E>;

    /// Takes two pixels or more that are wholly covered, but for the first and the last one: those between two edges.
    ///
    /// # Errors
    /// The error of the target or the closure that takes the pixels.
    #[inline(always)]
    fn between(&mut self, columns: Range<i32>, first: Coverage, last: Coverage) -> Result<(), E> {
        let inside = columns.start + 1..columns.end - 1;
        if first != 0 {
            self.pixel(columns.start, first)?;
        }
        if !inside.is_empty() {
            self.span(inside, Coverage::MAX)?;
        }
        match last {
            0 => Ok(()),
            last => self.pixel(columns.end - 1, last),
        }
    }
}

impl<E, F: FnMut(Range<i32>, Coverage) -> Result<(), E>> Emit<E> for F {
    #[inline(always)]
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), E> {
        self(columns, coverage)
    }
}

/// An [`Emit`] behind a reference, for a coverage method that covers a part of a row: methods take theirs by value.
#[derive(Debug)]
pub struct ByReference<'e, T>(pub(crate) &'e mut T);

impl<E, T: Emit<E>> Emit<E> for ByReference<'_, T> {
    #[inline(always)]
    fn pixel(&mut self, x: i32, coverage: Coverage) -> Result<(), E> {
        self.0.pixel(x, coverage)
    }

    #[inline(always)]
    fn two_pixels(&mut self, columns: [i32; 2], coverage: Coverage) -> Result<(), E> {
        self.0.two_pixels(columns, coverage)
    }

    #[inline(always)]
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), E> {
        self.0.span(columns, coverage)
    }

    #[inline(always)]
    fn between(&mut self, columns: Range<i32>, first: Coverage, last: Coverage) -> Result<(), E> {
        self.0.between(columns, first, last)
    }
}

#[cfg(feature = "defmt")]
impl<T> defmt::Format for ByReference<'_, T> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "ByReference");
    }
}

/// Takes the pixels that an outline covers, row by row: a target's blender, or a closure that gets all of them as spans.
pub trait EmitRows<E> {
    /// The [`Emit`] that takes the covered pixels of one row.
    type Row<'r>: Emit<E>
    where
        Self: 'r;

    /// Begins the row `y`: the covered pixels that are handed over to what is returned lie in it.
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
