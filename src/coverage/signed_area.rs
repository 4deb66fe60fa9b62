//! The exact area of the shape in each pixel, from the signed areas right of its edges: one difference a pixel, and a
//! prefix sum over the row.
//!
//! Promises: the exact area of edges that pass from row to row, and from pixel to pixel, at whole units of 1/256 pixel.
//! Shapes that lie over each other or cross inside a pixel are its one failure: there signed areas cancel or add up (the
//! crossing of a bow tie gets 0, where half is right). [`InsideArea`](crate::coverage::InsideArea) resolves that.
//!
//! Source: exact area by cells (FreeType's smooth rasterizer, Turner 2000), kept as differences (font-rs, Levien 2016).

use core::ops::Range;

use crate::{
    coverage::{Coverage, Share, sweep::sweep},
    scan::{RowSegment, UNIT, scanline_polygon::FillRule},
};

/// The exact area: tier T3, the default for 2D.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SignedArea;

/// A whole pixel: twice the area, in units.
pub(super) const WHOLE: i32 = 2 * UNIT * UNIT;

impl Coverage for SignedArea {
    type Cell = i32;

    fn cells(width: usize) -> usize {
        width.saturating_add(1)
    }

    #[inline]
    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i32],
        emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut row = AreaRow::new(&columns, cells);
        for segment in segments.iter() {
            let height = segment.y_bottom.wrapping_sub(segment.y_top);
            row.add(segment.x_top, segment.x_bottom, height.wrapping_mul(segment.winding));
        }
        match fill_rule {
            FillRule::NonZero => row.sweep(columns, |sum| share_of(sum.saturating_abs().min(WHOLE)), emit),
            FillRule::EvenOdd => row.sweep(columns, |sum| share_of(folded(sum)), emit),
        }
    }
}

/// What is surrounded an even number of times is not covered.
#[inline(always)]
fn folded(sum: i32) -> i32 {
    let rest = sum & (2 * WHOLE - 1);
    if rest > WHOLE { 2 * WHOLE - rest } else { rest }
}

/// Rounded to the nearest: 2^17 times 255 fits.
#[inline(always)]
pub(super) fn share_of(area: i32) -> Share {
    (area.wrapping_mul(255).wrapping_add(WHOLE / 2) >> 17) as Share
}

/// The differences of a row, and which of them are not 0.
pub(super) struct AreaRow<'c> {
    cells: &'c mut [i32],
    left: i32,
    /// Units from the left column to the right end.
    width: i32,
    /// What lies between, in units.
    low: i32,
    high: i32,
}

impl<'c> AreaRow<'c> {
    #[inline(always)]
    pub(super) fn new(columns: &Range<i32>, cells: &'c mut [i32]) -> Self {
        let most = cells.len().saturating_sub(1);
        let count = (columns.end.wrapping_sub(columns.start).max(0) as usize).min(most);
        let width = (count as i32).wrapping_mul(UNIT);
        Self {
            cells,
            left: columns.start.wrapping_mul(UNIT),
            width,
            low: width,
            high: 0,
        }
    }

    /// Adds the area right of a straight piece of an edge from `x_top` to `x_bottom`. `height` is negative where the
    /// winding number falls.
    #[inline(always)]
    pub(super) fn add(&mut self, x_top: i32, x_bottom: i32, height: i32) {
        let (one, other) = (x_top.wrapping_sub(self.left), x_bottom.wrapping_sub(self.left));
        // Which end is the upper one does not matter to an area.
        let (start, end) = (one.min(other), one.max(other));
        self.low = self.low.min(start);
        self.high = self.high.max(end);
        // One question for both ends: a negative number is a large one here.
        if (start | self.width.wrapping_sub(end)) < 0 {
            add_cut(self.cells, self.width, [start, end], height);
        } else if start >> 8 == end >> 8 {
            add_in_pixel(self.cells, start, end & (UNIT - 1), height);
        } else {
            add_along(self.cells, start, end, height);
        }
    }

    /// Adds up what is not 0 and hands over the spans.
    #[inline(always)]
    pub(super) fn sweep<E>(
        self,
        columns: Range<i32>,
        share: impl Fn(i32) -> Share,
        emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
    ) -> Result<(), E> {
        let first = self.low.max(0) >> 8;
        let end = (self.high.min(self.width) >> 8).wrapping_add(2);
        let right_end = self.left.wrapping_add(self.width) >> 8;
        let columns = columns.start.wrapping_add(first)..right_end;
        let end = (end as usize).min(self.cells.len());
        match self.cells.get_mut(first as usize..end) {
            Some(cells) => sweep(columns, cells, share, emit),
            None => Ok(()),
        }
    }
}

/// A piece within one pixel, from `start` to `to` of the same pixel.
#[inline(always)]
fn add_in_pixel(cells: &mut [i32], start: i32, to: i32, height: i32) {
    let from = start & (UNIT - 1);
    let right = from.wrapping_add(to).wrapping_mul(height);
    let first = (start >> 8) as usize;
    if let Some([here, next]) = cells.get_mut(first..first.wrapping_add(2)) {
        *here = here.wrapping_add(height.wrapping_mul(2 * UNIT)).wrapping_sub(right);
        *next = next.wrapping_add(right);
    } else if let Some(last) = cells.last_mut() {
        // On the right end: nothing reads it, but the prefix sum is whole.
        *last = last.wrapping_add(height.wrapping_mul(2 * UNIT));
    }
}

/// Where a piece leaves the row it is cut: what is left of the row counts as if it were on its left end.
#[cold]
#[inline(never)]
fn add_cut(cells: &mut [i32], width: i32, [start, end]: [i32; 2], height: i32) {
    let length = end.wrapping_sub(start);
    // Lengths are below 2^22 units, heights at most 2^8.
    let height_to = |x: i32| {
        let part = x.clamp(start, end).wrapping_sub(start);
        height.wrapping_mul(part).checked_div(length).unwrap_or(0)
    };
    let (left, right) = if length == 0 {
        (if start < 0 { height } else { 0 }, height)
    } else {
        (height_to(0), height_to(width))
    };
    add_in_pixel(cells, 0, 0, left);
    if start <= width && end >= 0 {
        let (from, to) = (start.clamp(0, width), end.clamp(0, width));
        let height = right.wrapping_sub(left);
        if from >> 8 == to >> 8 {
            add_in_pixel(cells, from, to & (UNIT - 1), height);
        } else {
            add_along(cells, from, to, height);
        }
    }
}

/// A piece across several pixels: its height in each by quotient and remainder, two divisions in all.
#[inline(never)]
fn add_along(cells: &mut [i32], start: i32, end: i32, height: i32) {
    let length = end.wrapping_sub(start);
    let (from, to) = (start & (UNIT - 1), end & (UNIT - 1));
    let (magnitude, sign) = (height.wrapping_abs(), height.signum());
    let divide = |numerator: i32| {
        let quotient = numerator.checked_div(length).unwrap_or(0);
        (quotient, numerator.wrapping_sub(quotient.wrapping_mul(length)))
    };
    let (part, mut rest) = divide(magnitude.wrapping_mul(UNIT.wrapping_sub(from)));
    let (first, last) = ((start >> 8) as usize, (end >> 8) as usize);
    let Some([first_cell, middle @ .., last_cell]) = cells.get_mut(first..=last) else {
        return;
    };
    let mut left_over = magnitude.wrapping_sub(part);
    let part = part.wrapping_mul(sign);
    *first_cell = first_cell.wrapping_add(part.wrapping_mul(UNIT.wrapping_sub(from)));
    // What of a pixel's height is right of it, in the next one.
    let mut right = part.wrapping_mul(UNIT.wrapping_add(from));
    if !middle.is_empty() {
        let (step, rest_step) = divide(magnitude.wrapping_mul(UNIT));
        for cell in middle {
            let mut part = step;
            rest = rest.wrapping_add(rest_step);
            if rest >= length {
                rest = rest.wrapping_sub(length);
                part = part.wrapping_add(1);
            }
            left_over = left_over.wrapping_sub(part);
            let half = part.wrapping_mul(sign).wrapping_mul(UNIT);
            *cell = cell.wrapping_add(right).wrapping_add(half);
            right = half;
        }
    }
    let part = left_over.wrapping_mul(sign);
    let beyond = part.wrapping_mul(to);
    let here = part.wrapping_mul(2 * UNIT).wrapping_sub(beyond);
    *last_cell = last_cell.wrapping_add(right).wrapping_add(here);
    if let Some(cell) = cells.get_mut(last.wrapping_add(1)) {
        *cell = cell.wrapping_add(beyond);
    }
}
