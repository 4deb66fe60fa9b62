//! Draws embedded-graphics' shapes, texts and images into a row at a constant depth.

use core::convert::Infallible;

use embedded_graphics::{Pixel, draw_target::DrawTarget, geometry::Dimensions, primitives::Rectangle};

use crate::{
    band::Band,
    geometry::{Window, distance},
    surface::{BandColor, Order, Span, contiguous::ContiguousRows},
    view::DepthWidth,
    visible::DepthRow,
};

/// The pixels of a row as a draw target, behind what is nearer and in front of what is farther.
#[derive(Debug)]
pub(crate) struct AtDepth<'r, 'a, C: BandColor, O: Order, D: DepthWidth> {
    pub(super) row: &'r mut DepthRow<'a, C, O, D>,
    pub(super) depth: D,
}

impl<C: BandColor, O: Order, D: DepthWidth> DepthRow<'_, C, O, D> {
    /// A draw target of the row's pixels at a constant depth: what the scene has nearer stays.
    ///
    /// Where the depths are equal, what was drawn first stays.
    pub fn at_depth(&mut self, depth: D) -> impl DrawTarget<Color = C, Error = Infallible> {
        AtDepth { row: self, depth }
    }
}

impl<C: BandColor, O: Order, D: DepthWidth> AtDepth<'_, '_, C, O, D> {
    fn window(&self) -> Window {
        let DepthRow { y, left, words, .. } = &*self.row;
        Window {
            left: *left,
            top: *y,
            // As many columns as a window has, so that this is its right side again.
            right: left + words.len() as i32,
            bottom: y.saturating_add(1),
        }
    }

    /// The words and depths of a span that is inside the window.
    #[inline]
    fn pixels(&mut self, span: Span) -> impl Iterator<Item = (&mut C::Word, &mut D)> {
        let column = |x: i32| x.abs_diff(self.row.left) as usize;
        let columns = column(span.start)..column(span.end);
        let words = self.row.words.get_mut(columns.clone()).unwrap_or_default();
        let depths = self.row.depths.get_mut(columns).unwrap_or_default();
        words.iter_mut().zip(depths)
    }
}

impl<C: BandColor, O: Order, D: DepthWidth> Dimensions for AtDepth<'_, '_, C, O, D> {
    fn bounding_box(&self) -> Rectangle {
        self.window().to_rectangle()
    }
}

impl<C: BandColor, O: Order, D: DepthWidth> DrawTarget for AtDepth<'_, '_, C, O, D> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        let DepthRow {
            y, left, words, depths, ..
        } = &mut *self.row;
        for Pixel(point, color) in pixels {
            if point.y != *y || point.x < *left {
                continue;
            }
            let column = distance(*left, point.x) as usize;
            if let (Some(word), Some(stored)) = (words.get_mut(column), depths.get_mut(column)) {
                if self.depth > *stored {
                    *stored = self.depth;
                    *word = Band::<C, O>::word(color);
                }
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = C>,
    {
        let visible = Window::from(*area).intersection(&self.window());
        let mut rows = ContiguousRows::new(area, visible, colors.into_iter());
        if let Some((span, colors)) = rows.next_row() {
            let depth = self.depth;
            for ((word, stored), color) in self.pixels(span).zip(colors) {
                if depth > *stored {
                    *stored = depth;
                    *word = Band::<C, O>::word(color);
                }
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        let visible = Window::from(*area).intersection(&self.window());
        if visible.is_empty() {
            return Ok(());
        }
        let (depth, raw) = (self.depth, Band::<C, O>::word(color));
        for (word, stored) in self.pixels(Span::new(visible.top, visible.left, visible.right)) {
            if depth > *stored {
                *stored = depth;
                *word = raw;
            }
        }
        Ok(())
    }
}
