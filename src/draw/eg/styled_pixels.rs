//! An iterator over the pixels of a styled shape, for programs that collect, count or transform pixels without drawing
//! them.
//!
//! Each row of the bounding box is scan-converted into a target that keeps only the leftmost run of one colour. When
//! its pixels have been returned, the row is scan-converted again from the end of that run on. The iterator therefore
//! needs no memory for a row, whatever the shape is.

use core::convert::Infallible;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::PixelColor,
    primitives::{Rectangle, Styled, StyledDimensions},
};

use crate::{
    draw::{PrimitiveStyle, StyledShape},
    geometry::Window,
    surface::{BatchTarget, LineSteps, Span, Target},
};

/// The pixels of a shape in a [`PrimitiveStyle`]: the method that embedded-graphics' `Styled` has with its own style.
///
/// ```
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::Circle};
/// use zrow::prelude::*;
///
/// let circle = Circle::new(Point::zero(), 5).into_styled(PrimitiveStyle::with_fill(BinaryColor::On));
/// assert_eq!(circle.pixels().count(), 21);
/// ```
pub trait StyledPixels {
    /// The iterator over the pixels.
    type Iter: Iterator;

    /// The pixels row by row from left to right, each once.
    ///
    /// Cost: the shape is cloned once, and drawn into one row for each run of pixels of one colour, and once more for
    /// each row of its bounding box. Drawing the shape itself costs less.
    fn pixels(&self) -> Self::Iter;
}

impl<S, C> StyledPixels for Styled<S, PrimitiveStyle<C>>
where
    S: StyledShape + StyledDimensions<PrimitiveStyle<C>> + Clone,
    C: PixelColor,
{
    type Iter = StyledPixelsIterator<S, C>;

    fn pixels(&self) -> StyledPixelsIterator<S, C> {
        let is_visible = !self.style.is_transparent();
        let window = is_visible.then(|| self.primitive.styled_bounding_box(&self.style).into());
        StyledPixelsIterator {
            shape: self.primitive.clone(),
            style: self.style,
            window: window.unwrap_or(Window::EMPTY),
            run: None,
        }
    }
}

/// The iterator that [`StyledPixels::pixels`] returns: the pixels of a shape in a [`PrimitiveStyle`], row by row from
/// left to right.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StyledPixelsIterator<S, C: PixelColor> {
    shape: S,
    style: PrimitiveStyle<C>,
    /// The rows of the bounding box that are not finished; the first one is the row of `run`.
    window: Window,
    /// The pixels that are returned next; `None` where the row has not been scan-converted yet.
    run: Option<Run<C>>,
}

/// Pixels of one colour that lie side by side.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Run<C> {
    span: Span,
    color: C,
}

impl<S, C> StyledPixelsIterator<S, C>
where
    S: StyledShape + StyledDimensions<PrimitiveStyle<C>>,
    C: PixelColor,
{
    /// The leftmost run of the current row from column `from` on; `None` where no pixel is left in the row.
    fn next_run(&self, from: i32) -> Option<Run<C>> {
        let mut target = FirstRun {
            window: Window {
                left: from,
                bottom: self.window.top.saturating_add(1),
                ..self.window
            },
            run: None,
        };
        let Ok(()) = self.shape.draw_styled_on(&self.style, &mut target);
        target.run
    }
}

impl<S, C> Iterator for StyledPixelsIterator<S, C>
where
    S: StyledShape + StyledDimensions<PrimitiveStyle<C>>,
    C: PixelColor,
{
    type Item = Pixel<C>;

    fn next(&mut self) -> Option<Pixel<C>> {
        let mut from = self.window.left;
        while !self.window.is_empty() {
            if let Some(Run { span, color }) = &mut self.run {
                from = span.start;
                if !span.is_empty() {
                    // No overflow: `start` is less than `end`, which is a coordinate.
                    span.start += 1;
                    return Some(Pixel(Point::new(from, span.y), *color));
                }
            }
            self.run = self.next_run(from);
            if self.run.is_none() {
                self.window.top = self.window.top.saturating_add(1);
                from = self.window.left;
            }
        }
        None
    }
}

/// A target of one row that draws nothing, and keeps the leftmost run of pixels that it is given.
struct FirstRun<C> {
    window: Window,
    run: Option<Run<C>>,
}

impl<C: PixelColor> FirstRun<C> {
    /// Keeps the visible part of the columns from `start` to before `end`, if it begins further left than the run kept
    /// so far.
    fn meet(&mut self, start: i32, end: i32, color: C) {
        let span = Span::new(self.window.top, start.max(self.window.left), end.min(self.window.right));
        if !span.is_empty() && self.run.as_ref().is_none_or(|run| span.start < run.span.start) {
            self.run = Some(Run { span, color });
        }
    }
}

impl<C: PixelColor> Dimensions for FirstRun<C> {
    fn bounding_box(&self) -> Rectangle {
        self.window.to_rectangle()
    }
}

impl<C: PixelColor> DrawTarget for FirstRun<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, color) in pixels {
            if point.y == self.window.top {
                self.meet(point.x, point.x.saturating_add(1), color);
            }
        }
        Ok(())
    }
}

impl<C: PixelColor> Target for FirstRun<C> {
    fn window(&self) -> Window {
        self.window
    }

    fn raw(&self, color: C) -> C {
        color
    }
}

impl<C: PixelColor> BatchTarget for FirstRun<C> {
    type Raw = C;

    fn fill_clipped_span(&mut self, span: Span, raw: C) -> Result<(), Infallible> {
        self.meet(span.start, span.end, raw);
        Ok(())
    }

    fn fill_clipped_window(&mut self, window: Window, raw: C) -> Result<(), Infallible> {
        if !window.is_empty() {
            self.meet(window.left, window.right, raw);
        }
        Ok(())
    }

    fn draw_steps(&mut self, steps: &LineSteps, raw: C) -> Result<(), Infallible> {
        // The window has one row, so that a line along x has its pixels side by side in it, and one along y has a
        // single pixel.
        let Point { x, .. } = steps.start;
        let further = if steps.x_major {
            steps.count.saturating_sub(1)
        } else {
            0
        };
        if steps.leftwards {
            self.meet(x.saturating_sub_unsigned(further), x.saturating_add(1), raw);
        } else {
            self.meet(x, x.saturating_add_unsigned(further).saturating_add(1), raw);
        }
        Ok(())
    }
}
