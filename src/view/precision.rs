//! How the 3D stages store sub-pixel units.

use core::fmt::Debug;

use crate::geometry::{Sub4, Sub8, SubPixel};

/// A [`SubPixel`] precision of screen vertices and edges: [`Sub4`] or [`Sub8`].
pub trait ScreenPrecision: SubPixel + sealed::Sealed {
    /// Holds a coordinate of the domain, or the difference of two, in units.
    type Units: Copy + Debug + Default + PartialEq + Eq + Into<i32> + Send + Sync;

    /// No units, for constants.
    const ZERO: Self::Units;
    /// A number outside the domain, by which a vertex is known that has no place on the screen.
    const OUTSIDE: Self::Units;

    /// Stores units that are known to fit; keeps the low bits of any other number.
    fn narrow(units: i32) -> Self::Units;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for crate::geometry::Sub4 {}
    impl Sealed for crate::geometry::Sub8 {}
}

impl ScreenPrecision for Sub4 {
    type Units = i16;
    const ZERO: i16 = 0;
    const OUTSIDE: i16 = i16::MIN;

    #[inline(always)]
    fn narrow(units: i32) -> i16 {
        units as i16
    }
}

impl ScreenPrecision for Sub8 {
    type Units = i32;
    const ZERO: i32 = 0;
    const OUTSIDE: i32 = i32::MIN;

    #[inline(always)]
    fn narrow(units: i32) -> i32 {
        units
    }
}
