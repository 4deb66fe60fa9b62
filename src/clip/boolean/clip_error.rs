//! The error of boolean operations on polygons: a vertex outside of the domain, or a vertex table that is full.

use core::fmt::{self, Display};

use crate::geometry::{OutOfDomain, TooSmall};

/// Two polygons cannot be clipped.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ClipError {
    /// A corner lies outside the domain of its precision, which a point made by hand can.
    OutOfDomain(OutOfDomain),
    /// There are too many vertices. The number that is needed is exact where no three edges meet in a point, and enough
    /// everywhere. Above 65,535 no table will do: clip parts of the polygons. With more corners than that, no more is
    /// counted.
    TooSmall(TooSmall),
}

impl Display for ClipError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfDomain(error) => error.fmt(formatter),
            Self::TooSmall(error) => error.fmt(formatter),
        }
    }
}

impl core::error::Error for ClipError {}
