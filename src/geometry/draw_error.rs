//! The error of drawing in memory that the caller lends.

use core::fmt::{self, Debug, Display};

use crate::geometry::{InputError, TooSmall};

/// Drawing did not begin, or stopped: memory is too small, a shape lies too far out, or the target of the pixels failed
/// with an error `E`.
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
