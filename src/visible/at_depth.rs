//! Draws embedded-graphics' shapes, texts and images into a row at a constant depth.

use core::convert::Infallible;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    primitives::Rectangle,
};

use crate::{
    band::Band,
    geometry::{Window, distance},
    surface::{BandColor, BatchTarget, LineSteps, Order, Span, Target, contiguous::ContiguousRows},
    view::DepthWidth,
    visible::{
        DepthRow,
        depth_test::{DepthState, DepthTest, Nearer, Test},
    },
};

/// The pixels of a row as a draw target, behind what is nearer and in front of what is farther.
#[derive(Debug)]
pub(crate) struct AtDepth<'r, 'a, C: BandColor, O: Order, D: DepthWidth, T> {
    pub(super) row: &'r mut DepthRow<'a, C, O, D>,
    pub(super) depth: D,
    test: T,
}

impl<C: BandColor, O: Order, D: DepthWidth> DepthRow<'_, C, O, D> {
    /// A target of the row's pixels at a constant depth: what the scene has nearer stays.
    ///
    /// Where the depths are equal, what was drawn first stays. Shapes and texts are drawn by
    /// [`draw_on`](crate::draw::DrawOn::draw_on), which hands over spans of this row alone; what is drawn by embedded-graphics'
    /// own `draw` costs all its pixels in every row.
    pub fn at_depth(&mut self, depth: D) -> impl Target<Color = C, Error = Infallible> {
        AtDepth {
            row: self,
            depth,
            test: Nearer,
        }
    }

    /// A target of the row's pixels at a constant depth, which are tested by a state: the depth is mapped to its range and
    /// units of its offset are added, once.
    ///
    /// With [`DepthState::NEARER`] it is what [`at_depth`](Self::at_depth) is, which takes less time.
    pub fn at_depth_with(&mut self, depth: D, state: &DepthState<D>) -> impl Target<Color = C, Error = Infallible> {
        let test = DepthTest::new(state, 0);
        AtDepth {
            row: self,
            depth: test.depth(depth),
            test,
        }
    }
}

impl<C: BandColor, O: Order, D: DepthWidth, T: Test<D>> AtDepth<'_, '_, C, O, D, T> {
    /// Draws a pixel; nothing where the row has no such pixel.
    #[inline]
    fn draw_pixel(&mut self, point: Point, word: C::Word) {
        let DepthRow {
            y, left, words, depths, ..
        } = &mut *self.row;
        if point.y != *y || point.x < *left {
            return;
        }
        let column = distance(*left, point.x) as usize;
        if let (Some(pixel), Some(stored)) = (words.get_mut(column), depths.get_mut(column)) {
            if self.test.passes(self.depth, *stored) {
                if self.test.writes() {
                    *stored = self.depth;
                }
                *pixel = word;
            }
        }
    }

    /// The words and depths of a span that is inside the window.
    #[inline]
    fn pixels(&mut self, span: Span) -> impl Iterator<Item = (&mut C::Word, &mut D)> {
        let column = |x: i32| distance(self.row.left, x) as usize;
        let columns = column(span.start)..column(span.end);
        let words = self.row.words.get_mut(columns.clone()).unwrap_or_default();
        let depths = self.row.depths.get_mut(columns).unwrap_or_default();
        words.iter_mut().zip(depths)
    }
}

impl<C: BandColor, O: Order, D: DepthWidth, T: Test<D>> Dimensions for AtDepth<'_, '_, C, O, D, T> {
    fn bounding_box(&self) -> Rectangle {
        self.window().to_rectangle()
    }
}

impl<C: BandColor, O: Order, D: DepthWidth, T: Test<D>> DrawTarget for AtDepth<'_, '_, C, O, D, T> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        for Pixel(point, color) in pixels {
            self.draw_pixel(point, Band::<C, O>::word(color));
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
            let (depth, test) = (self.depth, self.test);
            for ((word, stored), color) in self.pixels(span).zip(colors) {
                if test.passes(depth, *stored) {
                    if test.writes() {
                        *stored = depth;
                    }
                    *word = Band::<C, O>::word(color);
                }
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        self.fill_window(Window::from(*area), Band::<C, O>::word(color))
    }
}

impl<C: BandColor, O: Order, D: DepthWidth, T: Test<D>> Target for AtDepth<'_, '_, C, O, D, T> {
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

    fn raw(&self, color: C) -> C::Word {
        Band::<C, O>::word(color)
    }
}

impl<C: BandColor, O: Order, D: DepthWidth, T: Test<D>> BatchTarget for AtDepth<'_, '_, C, O, D, T> {
    type Raw = C::Word;

    fn fill_clipped_span(&mut self, span: Span, raw: C::Word) -> Result<(), Infallible> {
        if span.is_empty() {
            return Ok(());
        }
        let (depth, test) = (self.depth, self.test);
        for (word, stored) in self.pixels(span) {
            if test.passes(depth, *stored) {
                if test.writes() {
                    *stored = depth;
                }
                *word = raw;
            }
        }
        Ok(())
    }

    fn fill_clipped_window(&mut self, window: Window, raw: C::Word) -> Result<(), Infallible> {
        // The target has one row.
        if window.is_empty() {
            return Ok(());
        }
        self.fill_clipped_span(Span::new(window.top, window.left, window.right), raw)
    }

    fn draw_steps(&mut self, steps: &LineSteps, raw: C::Word) -> Result<(), Infallible> {
        for point in *steps {
            self.draw_pixel(point, raw);
        }
        Ok(())
    }
}
