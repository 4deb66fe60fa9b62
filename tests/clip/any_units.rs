//! Points with sub-pixel coordinates at any number of units, also outside the domain of their precision.

use fixed::types::{I12F4, I24F8};
use zrow::geometry::{Sub4, Sub8, SubPixel, SubPoint};

/// A precision whose coordinates can be made from any number of units, also outside the domain.
pub trait AnyUnits: SubPixel {
    /// The least number of units that a coordinate can hold.
    const LOWEST: i32;
    /// The greatest number of units that a coordinate can hold.
    const HIGHEST: i32;

    /// The coordinate of that many units.
    fn coordinate(units: i32) -> Self::Coordinate;
}

impl AnyUnits for Sub4 {
    const LOWEST: i32 = i16::MIN as i32;
    const HIGHEST: i32 = i16::MAX as i32;

    fn coordinate(units: i32) -> I12F4 {
        I12F4::from_bits(units.try_into().unwrap())
    }
}

impl AnyUnits for Sub8 {
    const LOWEST: i32 = i32::MIN;
    const HIGHEST: i32 = i32::MAX;

    fn coordinate(units: i32) -> I24F8 {
        I24F8::from_bits(units)
    }
}

/// The point at these numbers of units.
pub fn sub_point<S: AnyUnits>((x, y): (i32, i32)) -> SubPoint<S> {
    SubPoint {
        x: S::coordinate(x),
        y: S::coordinate(y),
    }
}
