//! A band as embedded-graphics' `DrawTarget` and as zrow's `Target`: writes words, never reads them.

use core::{convert::Infallible, hint::black_box, num::Wrapping, ops::Range, slice};

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    primitives::Rectangle,
};

use fixed::types::I12F20;

use crate::{
    band::{Band, fill::symmetric::fill_symmetric, rows::BandRows},
    geometry::{Window, coordinate_after},
    scan::line::bresenham_runs::LineRuns,
    surface::{
        BandColor, BatchTarget, LineSteps, Order, PixelWord, Span, SymmetricBox, SymmetricCurve, SymmetricSpan, Target,
        Trapezoid, Trapezoids, contiguous::ContiguousRows, fill_symmetric_row, not_constant,
    },
};

impl<C: BandColor, O: Order> Dimensions for Band<'_, C, O> {
    fn bounding_box(&self) -> Rectangle {
        self.window.to_rectangle()
    }
}

impl<C: BandColor, O: Order> DrawTarget for Band<'_, C, O> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        for Pixel(point, color) in pixels {
            if let Some(word) = self.index(point).and_then(|index| self.words.get_mut(index)) {
                *word = Self::word(color);
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = C>,
    {
        let visible = Window::from(*area).intersection(&self.window);
        if visible.is_empty() {
            return Ok(());
        }
        let colors = colors.into_iter();
        if visible.to_rectangle() == *area {
            self.fill_rows(visible, colors);
            return Ok(());
        }
        let mut rows = ContiguousRows::new(area, visible, colors);
        while let Some((span, colors)) = rows.next_row() {
            for (word, color) in self.words_of(span).into_iter().flatten().zip(colors) {
                *word = Self::word(color);
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        let visible = Window::from(*area).intersection(&self.window);
        // What embedded-graphics draws comes in rows.
        if area.size.height == 1 && !visible.is_empty() {
            let span = Span::new(visible.top, visible.left, visible.right);
            return self.fill_clipped_span(span, Self::word(color));
        }
        self.fill_clipped_window(visible, Self::word(color))
    }

    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        self.fill(color);
        Ok(())
    }
}

impl<C: BandColor, O: Order> Band<'_, C, O> {
    /// Fills an area that is visible as a whole with colours, row by row. Not inlined beside the code that skips colours, so
    /// that a paint's numbers stay in registers.
    #[inline(never)]
    fn fill_rows(&mut self, visible: Window, mut colors: impl Iterator<Item = C>) {
        for y in visible.top..visible.bottom {
            let Some(words) = self.words_of(Span::new(y, visible.left, visible.right)) else {
                return;
            };
            for word in words {
                let Some(color) = colors.next() else { return };
                *word = Self::word(color);
            }
        }
    }

    /// Fills the visible part of a span that is not all inside the window. Takes numbers, not the span, which would have to
    /// be in memory then.
    // Not marked as cold: with the mark, lines by runs take 2.5 % to 5.6 % more instructions on a Cortex-M4 and polygons 0.6 % to
    // 2.6 % more; on a Cortex-M0+ both take up to 1.1 % fewer.
    #[inline(never)]
    fn fill_cut_span(&mut self, y: i32, start: i32, end: i32, raw: C::Word) {
        let visible = Span::new(y, start, end).clipped_to(&self.window);
        let Ok(()) = self.fill_clipped_span(visible, raw);
    }
}

impl<C: BandColor, O: Order> Target for Band<'_, C, O> {
    fn window(&self) -> Window {
        self.window
    }

    fn raw(&self, color: C) -> C::Word {
        not_constant(Self::word(color))
    }

    #[inline]
    fn fill_span(&mut self, span: Span, raw: C::Word) -> Result<(), Infallible> {
        if !self.encloses(span) {
            self.fill_cut_span(span.y, span.start, span.end, raw);
            return Ok(());
        }
        self.fill_clipped_span(span, raw)
    }
}

impl<C: BandColor, O: Order> BatchTarget for Band<'_, C, O> {
    type Raw = C::Word;

    #[inline]
    fn fill_clipped_span(&mut self, span: Span, raw: C::Word) -> Result<(), Infallible> {
        debug_assert!(self.encloses(span) || span.is_empty());
        if let Some(words) = self.words_of(span) {
            C::Word::fill(words, raw);
        }
        Ok(())
    }

    fn fill_clipped_window(&mut self, window: Window, raw: C::Word) -> Result<(), Infallible> {
        debug_assert!(window.is_empty() || window.intersection(&self.window) == window);
        if window.is_empty() {
            return Ok(());
        }
        let start = self.index_unchecked(window.left, window.top);
        let Some(rest) = self.words.get_mut(start..) else {
            return Ok(());
        };
        let (width, rows) = (window.width() as usize, window.height() as usize);
        if width == self.stride {
            if let Some(words) = rest.get_mut(..width * rows) {
                C::Word::fill(words, raw);
            }
            return Ok(());
        }
        // Up to the last pixel, which may be the band's last.
        let length = self.stride * (rows - 1) + width;
        if let Some(words) = rest.get_mut(..length) {
            C::Word::fill_rows(words, self.stride, width, raw);
        }
        Ok(())
    }

    fn fill_trapezoids(&mut self, trapezoids: &Trapezoids, raw: C::Word) -> Result<(), Infallible> {
        debug_assert!(trapezoids.is_inside(&self.window));
        fill_trapezoids(self.words, self.stride, trapezoids, raw.repeated());
        Ok(())
    }

    fn fill_symmetric(
        &mut self,
        shape: &SymmetricBox,
        curve: &mut dyn SymmetricCurve,
        raw: C::Word,
        inner_raw: Option<C::Word>,
    ) -> Result<(), Infallible> {
        if shape.rows.len() != 1 {
            let rows = BandRows {
                words: self.words,
                window: self.window,
                stride: self.stride,
            };
            fill_symmetric(rows, shape, curve, raw, inner_raw);
            return Ok(());
        }
        // Of one row at a time, which is drawn where there is little memory, nothing is worth keeping on the stack.
        let mut span = SymmetricSpan::default();
        curve.next_rows(slice::from_mut(&mut span));
        fill_symmetric_row(self, shape, shape.rows.start, span, raw, inner_raw)
    }

    fn draw_steps(&mut self, steps: &LineSteps, raw: C::Word) -> Result<(), Infallible> {
        debug_assert!(steps.count > 0 && steps.into_iter().all(|point| self.window.contains(point)));
        if is_shallow(steps) {
            fill_runs(self, steps, raw);
            return Ok(());
        }
        let Point { x, y } = steps.start;
        let start = self.index_unchecked(x, y);
        if steps.x_major {
            walk_across(self.words, self.stride, start, steps, raw);
        } else {
            let last_row = self.index_unchecked(self.window.left, coordinate_after(y, steps.count - 1));
            walk_down(self.words, self.stride, start, last_row, steps, raw);
        }
        Ok(())
    }
}

/// Fills the rows of two trapezoids. One loop a word size serves every colour and every shape.
#[inline(never)]
fn fill_trapezoids<W: PixelWord>(words: &mut [W], stride: usize, trapezoids: &Trapezoids, repeated: u32) {
    let column = trapezoids.column as usize;
    let columns = column..column + trapezoids.columns as usize;
    // With a column to fill and room for it, the stride is not 0.
    if columns.is_empty() || columns.end > stride {
        return;
    }
    // The box lies in the window, whose pixels are counted in `usize`.
    let start = trapezoids.row as usize * stride;
    let Some(mut rest) = words.get_mut(start..) else { return };
    for part in &trapezoids.parts {
        let Some((rows, below)) = rest.split_at_mut_checked(part.rows as usize * stride) else {
            return;
        };
        rest = below;
        fill_trapezoid(rows, stride, columns.clone(), part, repeated);
    }
}

/// Fills the rows of a trapezoid, whose columns count from the first of those that are filled.
#[inline(always)]
fn fill_trapezoid<W: PixelWord>(
    rows: &mut [W],
    stride: usize,
    columns: Range<usize>,
    trapezoid: &Trapezoid,
    repeated: u32,
) {
    let bits = |number: I12F20| Wrapping(number.to_bits());
    // The column of the first pixel and the one after the last pixel's, modulo 2^12.
    let (mut left, mut right) = (
        bits(trapezoid.left.column),
        bits(trapezoid.right.column) + bits(I12F20::ONE),
    );
    let (left_step, right_step) = (bits(trapezoid.left.step), bits(trapezoid.right.step));
    let width = columns.len() as i32;
    let mut rest = rows;
    while let Some((row, below)) = rest.split_at_mut_checked(stride) {
        rest = below;
        let Some(row) = row.get_mut(columns.clone()) else {
            return;
        };
        let (first, end) = (left.0 >> I12F20::FRAC_NBITS, right.0 >> I12F20::FRAC_NBITS);
        let span = match row.get_mut(first as usize..end as usize) {
            Some(span) => Some(span),
            // Seldom, but for the rows of the vertices. A span that ends left of the columns has an end beyond every slice.
            None => row.get_mut(first.max(0) as usize..end.min(width) as usize),
        };
        if let Some(span) = span {
            W::fill_repeated(span, repeated);
        }
        left += left_step;
        right += right_step;
    }
}

/// Whether filling the runs of a line takes less than its steps: from runs of 8 pixels on, and where there are enough
/// pixels to make up for the divisions.
fn is_shallow(steps: &LineSteps) -> bool {
    steps.x_major && steps.minor_delta <= steps.major_delta >> 3 && steps.count >= 16
}

/// Fills the runs of a shallow line.
// Not inlined: what it needs is not on the stack of a caller that draws several shapes.
#[inline(never)]
fn fill_runs<C: BandColor, O: Order>(band: &mut Band<'_, C, O>, steps: &LineSteps, raw: C::Word) {
    let mut runs = LineRuns::from(*steps).runs();
    while let Some(span) = runs.next_row() {
        let Ok(()) = band.fill_clipped_span(span, raw);
    }
}

/// Writes the pixels of a line that is at least as wide as high, one word a step. One loop a word size serves every colour
/// and every such line.
fn walk_across<W: PixelWord>(words: &mut [W], stride: usize, start: usize, steps: &LineSteps, raw: W) {
    let sideways = sideways(steps);
    let mut until_minor_step = Wrapping(steps.until_minor_step());
    let mut index = Wrapping(start);
    let mut remaining = steps.count;
    // The walk lies inside the window: the check of the index is what stands in for `unsafe`.
    while let Some(word) = words.get_mut(index.0) {
        *word = raw;
        remaining -= 1;
        if remaining == 0 {
            return;
        }
        index += sideways;
        let (rest, steps_minor) = until_minor_step.0.overflowing_sub(steps.minor_delta);
        until_minor_step = Wrapping(rest);
        if steps_minor {
            until_minor_step += steps.major_delta;
            index += stride;
            // Keeps this a branch: conditional moves take more instructions than they save.
            black_box(());
        }
    }
}

/// Writes the pixels of a line that is higher than wide, one word a row, the last one in the row that begins at index `last_row`.
/// One loop a word size serves every colour and every such line.
fn walk_down<W: PixelWord>(words: &mut [W], stride: usize, start: usize, last_row: usize, steps: &LineSteps, raw: W) {
    let sideways = sideways(steps);
    let mut until_minor_step = Wrapping(steps.until_minor_step());
    let mut index = Wrapping(start);
    // Each step leads to the next row, so that the check of the index says as well when the last row is reached: a count of steps
    // takes two instructions more a pixel.
    let rows_above = words.get_mut(..last_row).unwrap_or_default();
    while let Some(word) = rows_above.get_mut(index.0) {
        *word = raw;
        index += stride;
        let (rest, steps_minor) = until_minor_step.0.overflowing_sub(steps.minor_delta);
        until_minor_step = Wrapping(rest);
        if steps_minor {
            until_minor_step += steps.major_delta;
            index += sideways;
            // Keeps this a branch: conditional moves take more instructions than they save.
            black_box(());
        }
    }
    if let Some(word) = words.get_mut(index.0) {
        *word = raw;
    }
}

/// A step to the side. Steps to the left are added modulo `usize`.
fn sideways(steps: &LineSteps) -> Wrapping<usize> {
    let right = Wrapping(1);
    if steps.leftwards { -right } else { right }
}
