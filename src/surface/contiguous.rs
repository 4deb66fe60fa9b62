//! The visible part of a list of colours that fills an area row by row.
//!
//! Guarantees: the colour of each visible pixel is read once. Colours before the first one of a row are left out by one
//! call of [`Iterator::nth`], or one for each `usize::MAX` of them. What comes after the last visible pixel, or after the
//! list has said that it ended, is not asked for. So the cost is that of the visible pixels, wherever the area begins and
//! ends, for every list that `nth` skips in constant time.

use embedded_graphics::primitives::Rectangle;

use crate::{geometry::Window, surface::Span};

/// The visible rows of an area, and the colours in them.
pub(crate) struct ContiguousRows<I> {
    colors: I,
    /// The visible rows that are still to come.
    rest: Window,
    /// Colours before the first one of the next row.
    skip: u64,
    /// Colours between the last one of a row and the first one of the row below it.
    gap: u64,
}

impl<I: Iterator> ContiguousRows<I> {
    /// The rows of an area, top to bottom; `visible` is the part of it that is inside a window.
    pub fn new(area: &Rectangle, visible: Window, colors: I) -> Self {
        // Rows of colours are as long as the area says, also where it reaches beyond the number range. All numbers are
        // below 2^32, and (2^32 - 1)^2 + 2^32 - 1 is below 2^64.
        let stride = u64::from(area.size.width);
        let above = u64::from(visible.top.abs_diff(area.top_left.y));
        let before = u64::from(visible.left.abs_diff(area.top_left.x));
        Self {
            colors,
            rest: visible,
            skip: above * stride + before,
            gap: stride - u64::from(visible.width()),
        }
    }

    /// Goes to the next row. The colours that come next are those of its pixels, which must all be taken before the
    /// following row.
    pub fn next_row(&mut self) -> Option<(Span, RowColors<'_, I>)> {
        if self.rest.is_empty() || !skip(&mut self.colors, self.skip) {
            return None;
        }
        self.skip = self.gap;
        let span = Span::new(self.rest.top, self.rest.left, self.rest.right);
        self.rest.top += 1;
        Some((span, RowColors(self)))
    }

    /// The next colour of the current row. After the last colour of the list there are no rows.
    #[inline]
    pub fn next_color(&mut self) -> Option<I::Item> {
        let color = self.colors.next();
        if color.is_none() {
            self.rest = Window::EMPTY;
        }
        color
    }
}

/// The colours of a row and of all rows after it, as an iterator.
pub(crate) struct RowColors<'r, I>(&'r mut ContiguousRows<I>);

impl<I: Iterator> Iterator for RowColors<'_, I> {
    type Item = I::Item;

    #[inline]
    fn next(&mut self) -> Option<I::Item> {
        self.0.next_color()
    }
}

/// Skips `count` colours; returns whether there were as many.
pub(crate) fn skip(colors: &mut impl Iterator, count: u64) -> bool {
    let mut left = count;
    while let Some(last) = left.checked_sub(1) {
        // On 64-bit machines the loop runs once.
        let last = usize::try_from(last).unwrap_or(usize::MAX);
        if colors.nth(last).is_none() {
            return false;
        }
        left -= last as u64 + 1;
    }
    true
}
