//! What can be drawn into: spans and lines that are already clipped, pixel words, and the [`Target`] trait.

mod generic;
mod line_steps;
mod mirrored;
mod pixel_word;
mod ring;
mod span;
mod trapezoids;

pub use generic::Generic;
pub use line_steps::LineSteps;
pub use mirrored::{Insets, MirroredBox, MirroredCurve};
pub(crate) use pixel_word::not_constant;
pub use pixel_word::{BandColor, BigEndian, Native, Order, PixelWord};
pub use ring::{Ring, RingEdge};
pub use span::Span;
pub use trapezoids::{StraightSide, Trapezoid, Trapezoids};

use embedded_graphics::draw_target::DrawTarget;

use crate::geometry::Window;

/// The fast door: a draw target that takes whole spans, blocks and lines.
///
/// [`Band`](crate::band::Band) implements it natively; any other display is wrapped once in [`Generic`], so that
/// user code is the same on both. What a shape hands over is already clipped to [`window`](Target::window): an
/// implementation need not clip again, and must not panic where a caller broke that promise.
pub trait Target: DrawTarget {
    /// What a colour becomes once per shape, before any pixel is written.
    type Ink: Copy;

    /// The pixels that exist.
    fn window(&self) -> Window;

    /// Prepares a colour for writing.
    fn ink(&self, color: Self::Color) -> Self::Ink;

    /// Fills one span.
    ///
    /// # Errors
    /// The target's own.
    fn fill_span(&mut self, span: Span, ink: Self::Ink) -> Result<(), Self::Error>;

    /// Fills a block of pixels.
    ///
    /// # Errors
    /// The target's own.
    fn fill_window(&mut self, window: Window, ink: Self::Ink) -> Result<(), Self::Error>;

    /// Fills the rows of two trapezoids.
    ///
    /// # Errors
    /// The target's own.
    fn fill_trapezoids(&mut self, trapezoids: &Trapezoids, ink: Self::Ink) -> Result<(), Self::Error> {
        for span in trapezoids.spans(&self.window()) {
            if !span.is_empty() {
                self.fill_span(span, ink)?;
            }
        }
        Ok(())
    }

    /// Draws the pixels along a line.
    ///
    /// # Errors
    /// The target's own.
    fn draw_steps(&mut self, steps: LineSteps, ink: Self::Ink) -> Result<(), Self::Error>;

    /// Fills the rows of a symmetric shape; its hole is filled in another ink or stays as it is.
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
        target.fill_span(Span::new(y, start, hole_start), ink)?;
        if let Some(ink) = hole_ink {
            target.fill_span(Span::new(y, hole_start, hole_end), ink)?;
        }
        target.fill_span(Span::new(y, hole_end, end), ink)?;
    }
    Ok(())
}
