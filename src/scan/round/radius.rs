//! Which radii a thin circle or ellipse may have.

use core::fmt::{self, Display};

/// A radius is larger than an algorithm draws.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RadiusTooLarge {
    /// The largest radius that the algorithm draws, in pixels.
    pub max: u32,
}

impl RadiusTooLarge {
    /// An error where the radius is larger than `max`.
    pub(crate) const fn check(radius: u32, max: u32) -> Result<(), Self> {
        if radius > max { Err(Self { max }) } else { Ok(()) }
    }
}

impl Display for RadiusTooLarge {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "radius above {} pixels: take another algorithm", self.max)
    }
}

impl core::error::Error for RadiusTooLarge {}
