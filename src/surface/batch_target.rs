//! What zrow's shapes hand over to a target: spans, windows, trapezoids, walks and symmetric rows, clipped already.

use embedded_graphics::draw_target::DrawTarget;

use crate::{
    geometry::Window,
    surface::{LineSteps, Span, SymmetricBox, SymmetricCurve, SymmetricSpan, Trapezoids},
};

/// The part of a [`Target`](crate::surface::Target) that only zrow's own shapes call, and that only its own targets have: it seals that trait.
///
/// Whatever is handed over lies inside the target's window or is empty, so no method clips again.
pub trait BatchTarget: DrawTarget {
    /// A colour as the target stores it.
    type Raw: Copy;

    /// Fills a span.
    ///
    /// # Errors
    /// The target's own error.
    fn fill_clipped_span(&mut self, span: Span, raw: Self::Raw) -> Result<(), Self::Error>;

    /// Fills a window.
    ///
    /// # Errors
    /// The target's own error.
    fn fill_clipped_window(&mut self, window: Window, raw: Self::Raw) -> Result<(), Self::Error>;

    /// Fills two trapezoids.
    ///
    /// # Errors
    /// The target's own error.
    fn fill_trapezoids(&mut self, trapezoids: &Trapezoids, raw: Self::Raw) -> Result<(), Self::Error> {
        for span in trapezoids.spans(&Window::from(self.bounding_box())) {
            self.fill_clipped_span(span, raw)?;
        }
        Ok(())
    }

    /// Draws the pixels along a line, of which there is at least one.
    ///
    /// # Errors
    /// The target's own error.
    fn draw_steps(&mut self, steps: &LineSteps, raw: Self::Raw) -> Result<(), Self::Error>;

    /// Fills the rows of a symmetric shape; its hole is filled in another raw colour or stays as it is.
    ///
    /// # Errors
    /// The target's own error.
    fn fill_symmetric(
        &mut self,
        shape: &SymmetricBox,
        curve: &mut dyn SymmetricCurve,
        raw: Self::Raw,
        inner_raw: Option<Self::Raw>,
    ) -> Result<(), Self::Error> {
        shape.for_each_batch(curve, |first_row, batch| {
            for (row, &span) in (first_row..).zip(batch) {
                fill_symmetric_row(self, shape, row, span, raw, inner_raw)?;
            }
            Ok(())
        })
    }
}

/// Fills a row of the upper half of a symmetric shape, and its mirrored row.
// Not inlined, so that its stack frame is not there while the curve is walked.
#[inline(never)]
pub(crate) fn fill_symmetric_row<T: BatchTarget + ?Sized>(
    target: &mut T,
    shape: &SymmetricBox,
    row: u32,
    span: SymmetricSpan,
    raw: T::Raw,
    inner_raw: Option<T::Raw>,
) -> Result<(), T::Error> {
    let [start, inner_start, inner_end, end] = shape.bounds(span);
    for y in shape.lines(row).into_iter().flatten() {
        target.fill_clipped_span(Span::new(y, start, inner_start), raw)?;
        if let Some(raw) = inner_raw {
            target.fill_clipped_span(Span::new(y, inner_start, inner_end), raw)?;
        }
        target.fill_clipped_span(Span::new(y, inner_end, end), raw)?;
    }
    Ok(())
}
