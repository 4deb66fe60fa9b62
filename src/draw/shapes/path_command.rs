//! Commands for the pen that draws a path.

use crate::geometry::{SubPixel, SubPoint};

/// A command for the pen of a [`Path`](crate::draw::Path), whose position is (0, 0) before the first command.
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
