//! What can be drawn into: spans and lines that are already clipped, pixel words, and the [`Target`] trait.

mod clipped;
pub(crate) mod contiguous;
mod generic;
mod line_steps;
mod mirrored;
mod pixel_word;
mod ring;
mod span;
mod trapezoids;

pub(crate) use clipped::Clipped;
pub use generic::Generic;
pub use line_steps::LineSteps;
pub use mirrored::{Insets, MirroredBox, MirroredCurve};
pub(crate) use pixel_word::not_constant;
pub use pixel_word::{BandColor, BigEndian, Native, Order, PixelWord};
pub(crate) use ring::{Ring, RingEdge};
pub use span::Span;
pub use trapezoids::{StraightSide, Trapezoid, Trapezoids};

use embedded_graphics::draw_target::DrawTarget;

use crate::geometry::Window;

/// A draw target that takes whole spans, blocks and lines.
///
/// [`Band`](crate::band::Band) implements it natively; any other display is wrapped once in [`Generic`], so that
/// user code is the same on both.
///
/// Every target keeps one contract, for its own methods and for those of [`DrawTarget`]:
/// - the pixels of what it is given that are inside its [`window`](Target::window) are drawn, and no others; an empty or
///   reversed span, window or area has none;
/// - whatever the numbers are, nothing panics;
/// - the work grows with the visible pixels and rows, not with what is handed over. Of the colours of an area, those of
///   visible pixels are read, one by one; the others are left out by one call of [`Iterator::nth`] for each visible row (on
///   32-bit machines one more for each 2^32 colours), and nothing is read behind the last visible pixel. Only a list of
///   pixels is read whole, because any of them may be visible.
///
/// What zrow's shapes hand over is clipped already. It goes through hidden methods, which nobody else can call: those of
/// zrow's own targets do not clip once more, and any other target need not know of them.
pub trait Target: DrawTarget {
    /// What a colour becomes once per shape, before any pixel is written.
    type Ink: Copy;

    /// The pixels that exist.
    fn window(&self) -> Window;

    /// Prepares a colour for writing.
    fn ink(&self, color: Self::Color) -> Self::Ink;

    /// Fills the visible part of a span.
    ///
    /// # Errors
    /// The target's own.
    fn fill_span(&mut self, span: Span, ink: Self::Ink) -> Result<(), Self::Error>;

    #[doc(hidden)]
    fn fill_clipped_span(&mut self, Clipped(span): Clipped<Span>, ink: Self::Ink) -> Result<(), Self::Error> {
        self.fill_span(span, ink)
    }

    /// Fills the visible part of a block of pixels.
    ///
    /// # Errors
    /// The target's own.
    fn fill_window(&mut self, window: Window, ink: Self::Ink) -> Result<(), Self::Error>;

    #[doc(hidden)]
    fn fill_clipped_window(&mut self, Clipped(window): Clipped<Window>, ink: Self::Ink) -> Result<(), Self::Error> {
        self.fill_window(window, ink)
    }

    /// Fills the visible part of two trapezoids.
    ///
    /// # Errors
    /// The target's own.
    fn fill_trapezoids(&mut self, trapezoids: &Trapezoids, ink: Self::Ink) -> Result<(), Self::Error> {
        for span in trapezoids.spans(&self.window()) {
            if !span.is_empty() {
                self.fill_clipped_span(Clipped(span), ink)?;
            }
        }
        Ok(())
    }

    #[doc(hidden)]
    fn fill_clipped_trapezoids(
        &mut self,
        Clipped(trapezoids): Clipped<&Trapezoids>,
        ink: Self::Ink,
    ) -> Result<(), Self::Error> {
        self.fill_trapezoids(trapezoids, ink)
    }

    /// Draws the pixels along a line, up to the first one outside the window.
    ///
    /// # Errors
    /// The target's own.
    fn draw_steps(&mut self, steps: LineSteps, ink: Self::Ink) -> Result<(), Self::Error>;

    #[doc(hidden)]
    fn draw_clipped_steps(&mut self, Clipped(steps): Clipped<&LineSteps>, ink: Self::Ink) -> Result<(), Self::Error> {
        self.draw_steps(*steps, ink)
    }

    /// Fills the rows of a symmetric shape; its hole is filled in another ink or stays as it is. Only this crate says what
    /// of a shape lies in a target's window.
    ///
    /// # Errors
    /// The target's own.
    fn fill_mirrored(
        &mut self,
        shape: &MirroredBox,
        curve: &mut dyn MirroredCurve,
        ink: Self::Ink,
        hole_ink: Option<Self::Ink>,
    ) -> Result<(), Self::Error> {
        shape.for_each_batch(curve, |first_row, batch| {
            for (row, &insets) in (first_row..).zip(batch) {
                fill_mirrored_row(self, shape, row, insets, ink, hole_ink)?;
            }
            Ok(())
        })
    }
}

/// Fills a row of the upper half of a symmetric shape, and its mirrored row.
// Not inlined: what it needs on the stack is not there while the curve is walked.
#[inline(never)]
pub(crate) fn fill_mirrored_row<T: Target + ?Sized>(
    target: &mut T,
    shape: &MirroredBox,
    row: u32,
    insets: Insets,
    ink: T::Ink,
    hole_ink: Option<T::Ink>,
) -> Result<(), T::Error> {
    let [start, hole_start, hole_end, end] = shape.bounds(insets);
    for y in shape.lines(row).into_iter().flatten() {
        target.fill_clipped_span(Clipped(Span::new(y, start, hole_start)), ink)?;
        if let Some(ink) = hole_ink {
            target.fill_clipped_span(Clipped(Span::new(y, hole_start, hole_end)), ink)?;
        }
        target.fill_clipped_span(Clipped(Span::new(y, hole_end, end)), ink)?;
    }
    Ok(())
}
