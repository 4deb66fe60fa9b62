//! The error of drawing in memory that the caller lends.

use core::fmt::{self, Debug, Display};

use crate::geometry::{InputError, TooSmall};

/// Drawing did not begin, or stopped: memory is too small, a shape lies too far out, or the target of the pixels failed
/// with an error `E`.
///
/// A program that lends too little memory may draw without antialiasing instead; a target's own error is handed on:
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::{Circle, Rectangle}};
/// use zrow::{
///     band::Band,
///     draw::{DrawAntialiased, DrawOn, PrimitiveStyle},
///     geometry::{DrawError, TooSmall},
/// };
///
/// let mut words = [0; 16 * 16];
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(16, 16)), &mut words)?;
/// let (disc, style) = (Circle::new(Point::new(1, 1), 12), PrimitiveStyle::with_fill(Gray8::WHITE));
/// let result = disc.into_styled(style.antialiased()).draw_on(&mut band.antialiased::<8, 4>(&mut [0; 17]));
/// match result {
///     Err(DrawError::TooSmall(_)) => disc.into_styled(style).draw_on(&mut band)?,
///     other => other?,
/// }
/// assert_eq!(result, Err(DrawError::TooSmall(TooSmall::Edges(22))));
/// assert_eq!(words[7 * 16 + 7], 255);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum DrawError<E> {
    /// Memory that the caller lends is too small.
    TooSmall(TooSmall),
    /// A shape leaves the domain in which it can be antialiased: move or cut it first.
    OutOfDomain {
        /// The smallest pixel coordinate that would do.
        min: i32,
        /// The largest pixel coordinate that would do.
        max: i32,
    },
    /// The error of the target, or of the closure that takes the spans.
    Target(E),
}

impl<E> From<TooSmall> for DrawError<E> {
    fn from(error: TooSmall) -> Self {
        Self::TooSmall(error)
    }
}

impl<E: Display> Display for DrawError<E> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooSmall(error) => Display::fmt(error, formatter),
            Self::OutOfDomain { min, max } => {
                Display::fmt(&InputError::OutOfDomain { min: *min, max: *max }, formatter)
            }
            Self::Target(error) => Display::fmt(error, formatter),
        }
    }
}

impl<E: Debug + Display> core::error::Error for DrawError<E> {}
