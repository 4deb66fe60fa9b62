//! What can be drawn into: spans and windows, pixel words, and the [`Target`] trait.

mod batch_target;
pub(crate) mod contiguous;
mod generic;
mod line_steps;
mod paint;
mod pixel_word;
mod ring;
mod span;
mod symmetric;
mod trapezoids;

pub(crate) use batch_target::{BatchTarget, fill_symmetric_row};
#[doc(no_inline)]
pub use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian};
pub use generic::Generic;
pub(crate) use line_steps::LineSteps;
pub use paint::Paint;
pub(crate) use paint::Painted;
pub use pixel_word::{BandColor, Order};
pub(crate) use pixel_word::{PixelWord, not_constant};
pub(crate) use ring::{Ring, RingEdge};
pub use span::Span;
pub(crate) use symmetric::{SymmetricBox, SymmetricCurve, SymmetricSpan};
pub(crate) use trapezoids::{StraightSide, Trapezoid, Trapezoids};

use crate::geometry::Window;

/// A draw target that takes whole spans and windows, in a colour that was converted once.
///
/// [`Band`](crate::band::Band) is one; any other display is wrapped once in [`Generic`], so that user code is alike on
/// both. [`painted`](Target::painted), [`in_linear_light`](crate::band::Band::in_linear_light) and
/// [`multisample`](crate::band::Band::multisample) say how it is drawn. The trait is sealed: zrow's shapes hand over batches
/// of pixels that are clipped already, in forms that may change.
///
/// `T::Raw` is a colour as the target stores it.
///
/// Every target keeps one contract, for its own methods and for those of
/// [`DrawTarget`](embedded_graphics::draw_target::DrawTarget):
/// - the pixels of what it is given that are inside its [`window`](Target::window) are drawn, and no others; an empty or
///   reversed span, window or area has none;
/// - whatever the numbers are, nothing panics;
/// - the work grows with the visible pixels and rows, not with what is handed over. Of the colours of an area, those of
///   visible pixels are read, one by one; the others are left out by one call of [`Iterator::nth`] for each visible row (on
///   32-bit machines one more for each 2^32 colours), and nothing is read behind the last visible pixel. Only a list of
///   pixels is read whole, because any of them may be visible.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::{band::{Band, Generic, Target}, geometry::Window};
///
/// /// Draws grid lines over all of a target, every fourth column.
/// fn grid<T: Target>(target: &mut T, color: T::Color) -> Result<(), T::Error> {
///     let (window, raw) = (target.window(), target.raw(color));
///     (window.left..window.right).step_by(4).try_for_each(|left| {
///         target.fill_window(Window { left, right: left + 1, ..window }, raw)
///     })
/// }
///
/// let mut row = [0; 6];
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(6, 1)), &mut row)?;
/// let Ok(()) = grid(&mut band, Gray8::WHITE);
/// assert_eq!(row, [255, 0, 0, 0, 255, 0]);
///
/// let mut display = MockDisplay::<Gray8>::new();
/// grid(&mut Generic(&mut display), Gray8::WHITE)?;
/// assert_eq!(display.get_pixel(Point::new(60, 63)), Some(Gray8::WHITE));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not one of the targets that shapes are drawn on",
    note = "a display or any other `DrawTarget` of embedded-graphics is one as `&mut Generic(&mut display)`",
    note = "a band is one as it is, `shape.draw_on(band)`"
)]
pub trait Target: BatchTarget {
    /// The pixels that the target has; whatever lies outside is not drawn.
    fn window(&self) -> Window;

    /// Prepares a colour for writing; once a shape, before any pixel is written.
    fn raw(&self, color: Self::Color) -> Self::Raw;

    /// Fills the visible part of a span.
    ///
    /// # Errors
    /// The target's own error.
    fn fill_span(&mut self, span: Span, raw: Self::Raw) -> Result<(), Self::Error> {
        let visible = span.clipped_to(&self.window());
        self.fill_clipped_span(visible, raw)
    }

    /// Fills the visible part of a window.
    ///
    /// # Errors
    /// The target's own error.
    fn fill_window(&mut self, window: Window, raw: Self::Raw) -> Result<(), Self::Error> {
        let visible = window.intersection(&self.window());
        self.fill_clipped_window(visible, raw)
    }

    /// The target with a paint: every pixel that is drawn on it gets the paint's colour, and the colour that it is drawn in is
    /// ignored.
    ///
    /// For zrow's shapes and embedded-graphics' texts. To give a shape a painted fill and a stroke of one colour, draw it
    /// twice: with the fill on this target, with the stroke on the target below.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::{Gray8, Rgb888}, prelude::*, primitives::{Circle, Rectangle}};
    /// use zrow::{band::{Band, Target}, draw::{DrawOn, PrimitiveStyle}, shade::{LinearGradient, Ramp}};
    ///
    /// let mut words = [0u8; 16 * 16];
    /// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(16, 16)), &mut words)?;
    /// let ramp = Ramp::between(Rgb888::WHITE, Rgb888::BLACK);
    /// let gradient = LinearGradient::<_, 2>::new(Point::new(0, 0), Point::new(0, 15), ramp).unwrap();
    /// let Ok(()) = Circle::new(Point::zero(), 16)
    ///     .into_styled(PrimitiveStyle::with_fill(Gray8::WHITE))
    ///     .draw_on(&mut band.painted(&gradient));
    /// assert_eq!((words[8], words[5 * 16 + 8]), (255, 170));
    /// # Ok::<(), zrow::geometry::TooSmall>(())
    /// ```
    fn painted<P: Paint<Color = Self::Color>>(&mut self, paint: P) -> Painted<'_, Self, P>
    where
        Self: Sized,
    {
        Painted { target: self, paint }
    }
}
