//! Commands for the pen that draws a path.

use crate::geometry::{SubPixel, SubPoint};

/// A command for the pen of a [`Path`](crate::draw::Path), whose position is (0, 0) before the first command.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use zrow::{
///     draw::{FillRule, Path, PathCommand::*, PrimitiveStyle},
///     geometry::{Sub8, SubPoint},
/// };
///
/// // A tab with a rounded top, which is closed by its lower side.
/// let at = |x, y| SubPoint::<Sub8>::from_pixel(Point::new(x, y));
/// let tab = [
///     MoveTo(at(0, 5)?),
///     LineTo(at(0, 3)?),
///     QuadraticTo(at(0, 0)?, at(3, 0)?),
///     LineTo(at(5, 0)?),
///     QuadraticTo(at(8, 0)?, at(8, 3)?),
///     LineTo(at(8, 5)?),
///     Close,
/// ];
/// let mut display = MockDisplay::new();
/// # // The contour ends in the pixel in which it begins.
/// # display.set_allow_overdraw(true);
/// Path::new(&tab, FillRule::NonZero)?
///     .into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1))
///     .draw(&mut display)?;
/// display.assert_pattern(&[
///     "  #####  ",
///     " #     # ",
///     "#       #",
///     "#       #",
///     "#       #",
///     "#########",
/// ]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PathCommand<S: SubPixel> {
    /// Begins a contour at a point, without drawing.
    MoveTo(SubPoint<S>),
    /// Draws a straight line to a point.
    LineTo(SubPoint<S>),
    /// Draws a quadratic Bézier curve: its middle control point and its end point.
    QuadraticTo(SubPoint<S>, SubPoint<S>),
    /// Draws a cubic Bézier curve: its two middle control points and its end point.
    CubicTo(SubPoint<S>, SubPoint<S>, SubPoint<S>),
    /// Draws a straight line to the beginning of the contour, where another contour begins.
    Close,
}

impl<S: SubPixel> PathCommand<S> {
    /// The points of the command in order: control points first, the end point last.
    pub(crate) fn points(&self) -> [Option<SubPoint<S>>; 3] {
        match *self {
            Self::MoveTo(end) | Self::LineTo(end) => [Some(end), None, None],
            Self::QuadraticTo(control, end) => [Some(control), Some(end), None],
            Self::CubicTo(one, other, end) => [Some(one), Some(other), Some(end)],
            Self::Close => [None; 3],
        }
    }
}
