//! Rows of a shape that is symmetric about its middle row and its middle column: computed once, used twice.
//!
//! Promises: each visible row once; work for visible rows only; positions inside the box are `u32` wherever the box is, so
//! that nothing overflows.

use core::ops::Range;

use embedded_graphics::geometry::Size;

use crate::{
    geometry::{Outline, Window},
    scan::{CurveNumber, ForwardDifference},
};

/// The box of a symmetric shape, and what of it is visible. Rows are counted from the top of the box.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MirroredBox {
    /// Position of the box modulo 2^32: whatever is visible has exact coordinates again.
    left: i32,
    top: i32,
    size: Size,
    /// Visible columns of the box.
    columns: Range<u32>,
    /// Rows of the upper half that are visible, and those whose mirrored row is; the middle row is in the first only.
    upper: Range<u32>,
    lower: Range<u32>,
}

impl MirroredBox {
    /// The box and what of it is in the window; `None` where nothing is.
    pub fn new(outline: Outline, window: &Window) -> Option<Self> {
        if window.is_empty() {
            return None;
        }
        let Size { width, height } = outline.size;
        let columns = visible(outline.left, width, window.left, window.right);
        let rows = visible(outline.top, height, window.top, window.bottom);
        if columns.is_empty() || rows.is_empty() {
            return None;
        }
        let (half, other_half) = (height - height / 2, height / 2);
        Some(Self {
            left: outline.left as i32,
            top: outline.top as i32,
            size: outline.size,
            columns,
            upper: rows.start..rows.end.min(half),
            lower: height - rows.end..(height - rows.start).min(other_half),
        })
    }

    /// The rows of the upper half that are visible or whose mirrored row is.
    pub fn rows(&self) -> Range<u32> {
        // The window is contiguous: where it has rows of both halves, both ranges end at the middle.
        if self.upper.is_empty() {
            self.lower.clone()
        } else if self.lower.is_empty() {
            self.upper.clone()
        } else {
            self.upper.start.min(self.lower.start)..self.upper.end
        }
    }

    /// A row and its mirrored row: the shape begins after `inset` columns and ends as many before the end of the box; its
    /// inside likewise after `hole_inset` columns, not less. Without a hole that is `u32::MAX`.
    #[inline]
    pub fn pair(&self, row: u32, inset: u32, hole_inset: u32) -> RowPair {
        let start = self.column(inset);
        let end = self.column(self.size.width.wrapping_sub(inset));
        let hole = if hole_inset < self.size.width {
            self.column(hole_inset)..self.column(self.size.width.wrapping_sub(hole_inset))
        } else {
            end..end
        };
        let mirrored = self.size.height.wrapping_sub(1).wrapping_sub(row);
        RowPair {
            upper: self.upper.contains(&row).then(|| self.top.wrapping_add_unsigned(row)),
            lower: self
                .lower
                .contains(&row)
                .then(|| self.top.wrapping_add_unsigned(mirrored)),
            columns: start..end,
            hole,
        }
    }

    /// The coordinate of a column of the box, moved into the window.
    #[inline]
    fn column(&self, column: u32) -> i32 {
        self.left
            .wrapping_add_unsigned(column.max(self.columns.start).min(self.columns.end))
    }
}

/// The part of `start..start + length` between `from` and `to`, counted from `start`.
fn visible(start: i64, length: u32, from: i32, to: i32) -> Range<u32> {
    let clamp = |position: i32| (i64::from(position) - start).clamp(0, i64::from(length)) as u32;
    clamp(from)..clamp(to)
}

/// Two rows with the same columns, clipped.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RowPair {
    /// The row above the middle or on it, where it is visible.
    pub upper: Option<i32>,
    /// The row below the middle, where it is visible.
    pub lower: Option<i32>,
    /// Columns of the shape; may be empty.
    pub columns: Range<i32>,
    /// Columns inside its stroke, a part of `columns`; empty and at their end where there are none.
    pub hole: Range<i32>,
}

/// The rows of a curve, with or without a second one inside it, from the outside to the middle.
#[derive(Debug, Clone)]
pub struct MirroredRows<N> {
    shape: MirroredBox,
    outer: ForwardDifference<N>,
    inner: ForwardDifference<N>,
    curve: Curve<N>,
    inner_size: Size,
    /// Columns of the box before the box of the inner curve, and rows above it.
    inner_left: u32,
    inner_top: u32,
    /// First row that the inner curve has.
    inner_start: u32,
    rows: Range<u32>,
}

/// The curve in a box: how to enter it at a row.
#[derive(Debug, Copy, Clone)]
pub struct Curve<N> {
    /// The first row that has a pixel, for a box that is not empty.
    pub first_row: fn(Size) -> u32,
    /// The curve in a row, from there to the middle row.
    pub enter: fn(Size, u32) -> ForwardDifference<N>,
}

impl<N: CurveNumber> MirroredRows<N> {
    /// The visible rows of the curve in `outer`, less those of the curve in `inner`, which lies in the middle of it or is
    /// empty. `None` where nothing is visible.
    pub fn new(outer: Outline, inner: Outline, curve: Curve<N>, window: &Window) -> Option<Self> {
        let shape = MirroredBox::new(outer, window)?;
        let mut rows = shape.rows();
        rows.start = rows.start.max((curve.first_row)(outer.size));
        if rows.is_empty() {
            return None;
        }
        let outer_walk = (curve.enter)(outer.size, rows.start);
        let (mut inner_walk, mut inner_left, mut inner_top, mut inner_start) = (outer_walk, 0, 0, u32::MAX);
        if !inner.is_empty() {
            // Inside the outer box, so both distances fit.
            inner_left = (inner.left - outer.left) as u32;
            inner_top = (inner.top - outer.top) as u32;
            inner_start = rows.start.max(inner_top + (curve.first_row)(inner.size));
            if inner_start < rows.end {
                inner_walk = (curve.enter)(inner.size, inner_start - inner_top);
            }
        }
        Some(Self {
            shape,
            outer: outer_walk,
            inner: inner_walk,
            curve,
            inner_size: inner.size,
            inner_left,
            inner_top,
            inner_start,
            rows,
        })
    }
}

impl<N: CurveNumber> Iterator for MirroredRows<N> {
    type Item = RowPair;

    #[inline]
    fn next(&mut self) -> Option<RowPair> {
        let row = self.rows.next()?;
        let has_hole = row >= self.inner_start;
        let hole_inset = if has_hole {
            self.inner_left.wrapping_add(self.inner.inset)
        } else {
            u32::MAX
        };
        let pair = self.shape.pair(row, self.outer.inset, hole_inset);
        if !self.rows.is_empty() {
            let next = row.wrapping_add(1);
            let (curve, outer_size, inner_size) = (self.curve, self.shape.size, self.inner_size);
            self.outer.advance(|| (curve.enter)(outer_size, next));
            if has_hole {
                let inner_next = next.wrapping_sub(self.inner_top);
                self.inner.advance(|| (curve.enter)(inner_size, inner_next));
            }
        }
        Some(pair)
    }
}

#[cfg(feature = "defmt")]
impl<N> defmt::Format for MirroredRows<N> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "MirroredRows {} of {}", self.rows, self.shape);
    }
}

#[cfg(feature = "defmt")]
impl<N> defmt::Format for Curve<N> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Curve");
    }
}
