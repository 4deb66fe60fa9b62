//! Outcodes (Cohen and Sutherland 1967): the sides of a window that a point is beyond, one bit each, so that AND rejects and OR
//! accepts a segment.

use embedded_graphics::geometry::Point;

use crate::geometry::{FixedPointWindow, SubPixel, SubPoint, Window};

/// One bit for each side of a window that a point is beyond; none inside.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Outcode(u8);

impl Outcode {
    /// Inside the window.
    pub const INSIDE: Self = Self(0);
    /// Beyond the left side.
    pub const LEFT: Self = Self(1);
    /// Beyond the right side.
    pub const RIGHT: Self = Self(2);
    /// Beyond the upper side.
    pub const ABOVE: Self = Self(4);
    /// Beyond the lower side.
    pub const BELOW: Self = Self(8);

    /// The outcode of a pixel against a window that is not empty; its column `right` and its row `bottom` are outside.
    pub fn of(point: Point, window: &Window) -> Self {
        Self(
            u8::from(point.x < window.left)
                | u8::from(point.x >= window.right) << 1
                | u8::from(point.y < window.top) << 2
                | u8::from(point.y >= window.bottom) << 3,
        )
    }

    /// The outcode of a sub-pixel point against a closed window that is not empty.
    pub fn of_sub_point<S: SubPixel>(point: SubPoint<S>, window: &FixedPointWindow<S>) -> Self {
        let (first, last) = (window.top_left(), window.bottom_right());
        Self(
            u8::from(point.x < first.x)
                | u8::from(point.x > last.x) << 1
                | u8::from(point.y < first.y) << 2
                | u8::from(point.y > last.y) << 3,
        )
    }

    /// Whether the point is inside.
    pub const fn is_inside(self) -> bool {
        self.0 == 0
    }

    /// The sides that both points are beyond: where there is one, nothing between them is visible.
    #[must_use]
    pub const fn shared(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// The sides that either point is beyond: where there is none, everything between them is visible.
    #[must_use]
    pub const fn either(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether both have a side in common.
    pub const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }
}
