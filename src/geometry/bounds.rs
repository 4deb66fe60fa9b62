//! The smallest rectangle around pixels, without overflow: embedded-graphics' own corner arithmetic wraps.

use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::geometry::Window;

/// A bounding box that grows by every pixel added to it. Its sides are `i64`, so that a shape that is moved or stroked
/// beyond the range of `i32` fits.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bounds {
    /// First column.
    pub(crate) left: i64,
    /// First row.
    pub(crate) top: i64,
    /// Last column.
    pub(crate) right: i64,
    /// Last row.
    pub(crate) bottom: i64,
}

impl Bounds {
    /// Bounds around nothing: whatever is added becomes the bounds.
    pub const EMPTY: Self = Self {
        left: i64::MAX,
        top: i64::MAX,
        right: i64::MIN,
        bottom: i64::MIN,
    };

    /// The bounds around these pixels.
    pub fn of(points: impl IntoIterator<Item = Point>) -> Self {
        points.into_iter().fold(Self::EMPTY, |bounds, point| {
            bounds.with(i64::from(point.x), i64::from(point.y))
        })
    }

    /// The smallest bounds around these bounds and a pixel.
    #[must_use]
    pub fn with(self, x: i64, y: i64) -> Self {
        Self {
            left: self.left.min(x),
            top: self.top.min(y),
            right: self.right.max(x),
            bottom: self.bottom.max(y),
        }
    }

    /// The union: the smallest bounds around both.
    #[must_use]
    pub fn around(self, other: &Self) -> Self {
        if other.is_empty() {
            return self;
        }
        self.with(other.left, other.top).with(other.right, other.bottom)
    }

    /// Whether the bounds contain no pixel.
    pub fn is_empty(&self) -> bool {
        self.left > self.right || self.top > self.bottom
    }

    /// Whether all pixels of the other bounds are in these.
    pub fn contains(&self, other: &Self) -> bool {
        self.left <= other.left && self.top <= other.top && self.right >= other.right && self.bottom >= other.bottom
    }

    /// The pixels of the bounds that have `i32` coordinates, as a rectangle. Its size ends at `u32::MAX`, one short of
    /// the whole number range.
    pub fn to_rectangle(self) -> Rectangle {
        let clamp = |value: i64| value.clamp(i64::from(i32::MIN), i64::from(i32::MAX));
        let (left, top) = (clamp(self.left), clamp(self.top));
        let (right, bottom) = (clamp(self.right), clamp(self.bottom));
        if self.left > self.right || right < self.left || bottom < self.top || left > self.right || top > self.bottom {
            return Rectangle::zero();
        }
        let size = |first: i64, last: i64| u32::try_from(last - first + 1).unwrap_or(u32::MAX);
        Rectangle::new(
            Point::new(left as i32, top as i32),
            Size::new(size(left, right), size(top, bottom)),
        )
    }
}

impl From<Window> for Bounds {
    fn from(window: Window) -> Self {
        if window.is_empty() {
            return Self::EMPTY;
        }
        Self {
            left: window.left.into(),
            top: window.top.into(),
            right: i64::from(window.right) - 1,
            bottom: i64::from(window.bottom) - 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::{prelude::*, test_runner::RngSeed};

    use super::*;

    #[test]
    fn the_whole_number_range_has_bounds() {
        let bounds = Bounds::of([Point::new(i32::MIN, i32::MAX), Point::new(i32::MAX, 3)]);
        assert_eq!(
            bounds.to_rectangle(),
            Rectangle::new(Point::new(i32::MIN, 3), Size::new(u32::MAX, i32::MAX as u32 - 2))
        );
        assert_eq!(Bounds::EMPTY.to_rectangle(), Rectangle::zero());
        assert_eq!(Bounds::EMPTY.with(1 << 40, 0).to_rectangle(), Rectangle::zero());
    }

    /// Coordinates of the whole number range, and its ends.
    fn coordinate() -> impl Strategy<Value = i32> {
        prop_oneof![
            any::<i32>(),
            -20..20i32,
            prop::sample::select(std::vec![i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX]),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 20_000, rng_seed: RngSeed::Fixed(0x0123_4567), ..ProptestConfig::default() })]

        #[test]
        fn bounds_hold_their_points(
            points in prop::collection::vec((coordinate(), coordinate()), 1..5),
            (x, y) in any::<(i64, i64)>(),
        ) {
            let points = points.into_iter().map(Point::from);
            let around = Bounds::of(points.clone()).with(x, y).to_rectangle();
            for point in points {
                let inside = |at: i32, start: i32, length: u32| {
                    (i64::from(start)..i64::from(start) + i64::from(length)).contains(&i64::from(at))
                };
                // The size ends one short of the whole number range.
                let is_last = point.x == i32::MAX || point.y == i32::MAX;
                prop_assert!(
                    is_last
                        || inside(point.x, around.top_left.x, around.size.width)
                            && inside(point.y, around.top_left.y, around.size.height)
                );
            }
        }
    }
}
