//! Vertices of polygons: whole pixels or sub-pixel points.

use core::fmt::Debug;

use embedded_graphics::geometry::Point;

use crate::geometry::{SubPixel, SubPoint};

/// A corner of a polygon: a pixel (any `i32`), or a [`SubPoint`] of either precision.
pub trait Vertex: Copy + Debug {
    /// Fractional bits: a pixel is `1 << FRACTION_BITS` units. At most 16.
    const FRACTION_BITS: u32;

    /// Column in units.
    fn x_units(&self) -> i32;

    /// Row in units.
    fn y_units(&self) -> i32;
}

impl Vertex for Point {
    const FRACTION_BITS: u32 = 0;

    fn x_units(&self) -> i32 {
        self.x
    }

    fn y_units(&self) -> i32 {
        self.y
    }
}

impl<S: SubPixel> Vertex for SubPoint<S> {
    const FRACTION_BITS: u32 = S::FRACTION_BITS;

    fn x_units(&self) -> i32 {
        SubPoint::x_units(self)
    }

    fn y_units(&self) -> i32 {
        SubPoint::y_units(self)
    }
}
