//! The rows of a curve that is symmetric about the middle of its box: computed once, drawn twice.
//!
//! Guarantees: work for visible rows only, wherever the curve lies and however large it is.

use core::{num::Wrapping, ops::Range};

use embedded_graphics::geometry::Size;

use crate::{
    geometry::WideRectangle,
    scan::round::{CurveNumber, ForwardDifference, circle},
    surface::{Ring, RingEdge, SymmetricBox, SymmetricCurve, SymmetricSpan},
};

/// A kind of curve, by the functions that enter it in a box of a given size, which is not empty.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Curve<N> {
    /// The first row that has a pixel.
    pub first_row: fn(Size) -> u32,
    /// Enters the curve in a row, from where it is walked down to the middle row.
    pub enter: fn(Size, u32) -> ForwardDifference<N>,
}

/// The rows of a curve, less those of a smaller one in the middle of it, from the outside to the middle.
#[derive(Debug, Clone)]
pub(crate) struct SymmetricRows<N> {
    curve: Curve<N>,
    rows: Range<u32>,
    size: Size,
    outer: ForwardDifference<N>,
    inner_size: Size,
    inner: ForwardDifference<N>,
    /// Columns of the box before the box of the inner curve, and rows above it.
    inner_left: u32,
    inner_top: u32,
    /// First row that the inner curve has.
    inner_start: u32,
}

impl<N: CurveNumber> SymmetricRows<N> {
    /// The visible rows of the curve in `outer`, less those of the curve in `inner`, which lies in the middle of it or is
    /// empty. `shape` is what is visible of `outer`, and not before the first row of the curve.
    #[inline]
    pub fn new(outer: WideRectangle, inner: WideRectangle, curve: Curve<N>, shape: &SymmetricBox) -> Self {
        let rows = shape.rows.clone();
        let outer_walk = (curve.enter)(outer.size, rows.start);
        // Inside the outer box, so both distances fit.
        let inner_left = (inner.left - outer.left) as u32;
        let inner_top = (inner.top - outer.top) as u32;
        let inner_start = if inner.is_empty() {
            u32::MAX
        } else {
            rows.start.max(inner_top + (curve.first_row)(inner.size))
        };
        let inner_walk = if inner_start < rows.end {
            (curve.enter)(inner.size, inner_start - inner_top)
        } else {
            outer_walk
        };
        Self {
            curve,
            rows,
            size: outer.size,
            outer: outer_walk,
            inner_size: inner.size,
            inner: inner_walk,
            inner_left,
            inner_top,
            inner_start,
        }
    }
}

impl<N: CurveNumber> SymmetricCurve for SymmetricRows<N> {
    fn next_rows(&mut self, spans: &mut [SymmetricSpan]) {
        let row = self.rows.start;
        self.rows.start = row + spans.len() as u32;
        let end = self.rows.end;
        let enter_curve = self.curve.enter;
        let enter = |size| move |row| enter_curve(size, row);
        self.outer.walk(row..end, enter(self.size), spans, |span, inset| {
            *span = SymmetricSpan {
                outer: inset,
                inner: SymmetricSpan::NO_INNER,
            };
        });
        let without_hole = self.inner_start.saturating_sub(row) as usize;
        if let Some(spans) = spans.get_mut(without_hole..) {
            let (left, top) = (self.inner_left, self.inner_top);
            let rows = row.max(self.inner_start) - top..end - top;
            self.inner.walk(rows, enter(self.inner_size), spans, |span, inset| {
                span.inner = left + inset;
            });
        }
    }

    fn ring(&self) -> Option<Ring> {
        let (diameter, stroke) = (self.size.width, self.inner_left);
        let is_circle = diameter == self.size.height && self.inner_start != u32::MAX;
        // At the end of the number range a stroke may have no column of its own; every other ring has one in each row.
        if !is_circle || stroke == 0 || diameter.saturating_mul(stroke) > LONGEST_SIDE * LONGEST_SIDE {
            return None;
        }
        // Less than 0 in the middle row, and so modulo 2^32.
        let row_increment = Wrapping(self.outer.row_increment.narrowed()) + Wrapping(2);
        // The edge as it is in the row before the first.
        let edge = |column: u32, error_term: u32| RingEdge {
            column: Wrapping(column),
            error_term: (Wrapping(error_term) - Wrapping(1) + row_increment).0,
        };
        let inner = if self.rows.start < self.inner_start {
            edge(
                diameter - diameter / 2,
                circle::error_term_above(self.inner_size.width, (row_increment - Wrapping(1)).0),
            )
        } else {
            edge(stroke + self.inner.inset, self.inner.error_term.narrowed())
        };
        Some(Ring {
            outer: edge(self.outer.inset, self.outer.error_term.narrowed()),
            inner,
            sum: Wrapping(diameter),
            row_increment,
        })
    }
}

/// The longest side of a ring, in columns, that is drawn as a ring; an approximate limit.
const LONGEST_SIDE: u32 = 32;

#[cfg(feature = "defmt")]
impl<N> defmt::Format for Curve<N> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Curve");
    }
}

#[cfg(feature = "defmt")]
impl<N: CurveNumber> defmt::Format for SymmetricRows<N> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "SymmetricRows {}..{}", self.rows.start, self.rows.end);
    }
}
