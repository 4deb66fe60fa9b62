//! What can go wrong while a polygon is filled through a table.

use core::fmt::{self, Debug, Display};

use crate::geometry::TooSmall;

/// Why a polygon was not filled, or not to its end.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FillError<E> {
    /// The table is too small; nothing was handed over.
    TooSmall(TooSmall),
    /// The first error of `emit`.
    Emit(E),
}

impl<E: Display> Display for FillError<E> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooSmall(error) => Display::fmt(error, formatter),
            Self::Emit(error) => Display::fmt(error, formatter),
        }
    }
}

impl<E: Debug + Display> core::error::Error for FillError<E> {}
