//! The error of preparing shapes from points.

use core::fmt::{self, Display};

use crate::geometry::{OutOfDomain, TooSmall};

/// A shape cannot be prepared: a corner lies too far out, or memory is too small.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InputError {
    /// A corner lies outside the domain of its precision, as a `SubPoint` whose fields were set directly can.
    OutOfDomain(OutOfDomain),
    /// The shape has more edges or vertices than there is room for.
    TooSmall(TooSmall),
}

impl Display for InputError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfDomain(error) => error.fmt(formatter),
            Self::TooSmall(error) => error.fmt(formatter),
        }
    }
}

impl core::error::Error for InputError {}
