//! What can be drawn into: spans and lines that are already clipped, pixel words, and the [`Target`] trait.

mod clipped;
pub(crate) mod contiguous;
mod generic;
mod line_steps;
mod pixel_word;
mod ring;
mod span;
mod symmetric;
mod trapezoids;

pub(crate) use clipped::Clipped;
pub use generic::Generic;
pub use line_steps::LineSteps;
pub(crate) use pixel_word::not_constant;
pub use pixel_word::{BandColor, BigEndian, Native, Order, PixelWord};
pub(crate) use ring::{Ring, RingEdge};
pub use span::Span;
pub use symmetric::{SymmetricBox, SymmetricCurve, SymmetricSpan};
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
    type Raw: Copy;

    /// The pixels that exist.
    fn window(&self) -> Window;

    /// Prepares a colour for writing.
    fn raw(&self, color: Self::Color) -> Self::Raw;

    /// Fills the visible part of a span.
    ///
    /// # Errors
    /// The target's own.
    fn fill_span(&mut self, span: Span, raw: Self::Raw) -> Result<(), Self::Error>;

    #[doc(hidden)]
    fn fill_clipped_span(&mut self, Clipped(span): Clipped<Span>, raw: Self::Raw) -> Result<(), Self::Error> {
        self.fill_span(span, raw)
    }

    /// Fills the visible part of a block of pixels.
    ///
    /// # Errors
    /// The target's own.
    fn fill_window(&mut self, window: Window, raw: Self::Raw) -> Result<(), Self::Error>;

    #[doc(hidden)]
    fn fill_clipped_window(&mut self, Clipped(window): Clipped<Window>, raw: Self::Raw) -> Result<(), Self::Error> {
        self.fill_window(window, raw)
    }

    /// Fills the visible part of two trapezoids.
    ///
    /// # Errors
    /// The target's own.
    fn fill_trapezoids(&mut self, trapezoids: &Trapezoids, raw: Self::Raw) -> Result<(), Self::Error> {
        for span in trapezoids.spans(&self.window()) {
            if !span.is_empty() {
                self.fill_clipped_span(Clipped(span), raw)?;
            }
        }
        Ok(())
    }

    #[doc(hidden)]
    fn fill_clipped_trapezoids(
        &mut self,
        Clipped(trapezoids): Clipped<&Trapezoids>,
        raw: Self::Raw,
    ) -> Result<(), Self::Error> {
        self.fill_trapezoids(trapezoids, raw)
    }

    /// Draws the pixels along a line, up to the first one outside the window.
    ///
    /// # Errors
    /// The target's own.
    fn draw_steps(&mut self, steps: LineSteps, raw: Self::Raw) -> Result<(), Self::Error>;

    #[doc(hidden)]
    fn draw_clipped_steps(&mut self, Clipped(steps): Clipped<&LineSteps>, raw: Self::Raw) -> Result<(), Self::Error> {
        self.draw_steps(*steps, raw)
    }

    /// Fills the rows of a symmetric shape; its hole is filled in another raw colour or stays as it is. Only this crate
    /// says what of a shape lies in a target's window.
    ///
    /// # Errors
    /// The target's own.
    fn fill_symmetric(
        &mut self,
        shape: &SymmetricBox,
        curve: &mut dyn SymmetricCurve,
        raw: Self::Raw,
        hole_raw: Option<Self::Raw>,
    ) -> Result<(), Self::Error> {
        shape.for_each_batch(curve, |first_row, batch| {
            for (row, &span) in (first_row..).zip(batch) {
                fill_symmetric_row(self, shape, row, span, raw, hole_raw)?;
            }
            Ok(())
        })
    }
}

/// Fills a row of the upper half of a symmetric shape, and its mirrored row.
// Not inlined: what it needs on the stack is not there while the curve is walked.
#[inline(never)]
pub(crate) fn fill_symmetric_row<T: Target + ?Sized>(
    target: &mut T,
    shape: &SymmetricBox,
    row: u32,
    span: SymmetricSpan,
    raw: T::Raw,
    hole_raw: Option<T::Raw>,
) -> Result<(), T::Error> {
    let [start, hole_start, hole_end, end] = shape.bounds(span);
    for y in shape.lines(row).into_iter().flatten() {
        target.fill_clipped_span(Clipped(Span::new(y, start, hole_start)), raw)?;
        if let Some(raw) = hole_raw {
            target.fill_clipped_span(Clipped(Span::new(y, hole_start, hole_end)), raw)?;
        }
        target.fill_clipped_span(Clipped(Span::new(y, hole_end, end)), raw)?;
    }
    Ok(())
}
