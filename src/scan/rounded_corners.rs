//! Rounded rectangles, row by row: each corner is a quarter of an ellipse.
//!
//! Promises: embedded-graphics' pixels; the work for a row does not depend on how long it is. Corners are walked by forward
//! differences, as an ellipse is: once for both halves where all of them are alike, otherwise each by itself, from the first
//! row that is asked for. What a corner has beyond the middle row, and all of one too large for 32 bits, is entered in each
//! row, by a division and an integer square root.

use embedded_graphics::{geometry::Size, primitives::CornerRadii};

use crate::{
    geometry::Outline,
    scan::{CurveNumber, ForwardDifference, ellipse},
    target::{Insets, MirroredBox, MirroredCurve},
};

/// A rectangle with rounded corners that fit into it.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RoundedOutline {
    /// The rectangle.
    pub outline: Outline,
    corners: CornerRadii,
}

impl RoundedOutline {
    /// The radii are made smaller by the same share, where two of them take more than a side.
    pub fn new(outline: Outline, corners: CornerRadii) -> Self {
        Self {
            outline,
            corners: confined(corners, outline.size),
        }
    }

    /// The radius of all corners, where they are alike.
    pub fn equal_radius(&self) -> Option<Size> {
        let CornerRadii {
            top_left,
            top_right,
            bottom_right,
            bottom_left,
        } = self.corners;
        let is_equal = [top_right, bottom_right, bottom_left]
            .iter()
            .all(|corner| *corner == top_left);
        is_equal.then_some(top_left)
    }

    /// The rows of its upper half, from the first one to the middle.
    pub const fn upper_half(&self) -> HalfRows {
        let corners = &self.corners;
        HalfRows {
            corners: [corners.top_left, corners.top_right],
            walks: [EnteredCorner::NOWHERE; 2],
            opposite: [corners.bottom_left, corners.bottom_right],
            height: self.outline.size.height,
        }
    }

    /// The rows of its lower half, from the last one to the middle.
    pub const fn lower_half(&self) -> HalfRows {
        let corners = &self.corners;
        HalfRows {
            corners: [corners.bottom_left, corners.bottom_right],
            walks: [EnteredCorner::NOWHERE; 2],
            opposite: [corners.top_left, corners.top_right],
            height: self.outline.size.height,
        }
    }
}

/// The rows of one half of a rounded rectangle whose corners may differ, counted from the outside.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HalfRows {
    /// The left and the right one, and where they are.
    corners: [Size; 2],
    walks: [EnteredCorner; 2],
    /// Those of the other half, which may reach beyond the middle.
    opposite: [Size; 2],
    height: u32,
}

impl HalfRows {
    /// Columns before the first pixel of a row of the rectangle, and after the last one.
    ///
    /// Cost: additions where it is the row after the last one that was asked for.
    #[inline]
    pub fn insets(&mut self, row: u32) -> (u32, u32) {
        // The rectangle has the row.
        let opposite_row = MirroredBox::mirrored(row, self.height);
        let ([left, right], [opposite_left, opposite_right]) = (self.corners, self.opposite);
        let [left_walk, right_walk] = &mut self.walks;
        // Radii that still overlap cut what either cuts.
        (
            left_walk
                .inset(left, row)
                .max(corner_inset(opposite_left, opposite_row)),
            right_walk
                .inset(right, row)
                .max(corner_inset(opposite_right, opposite_row)),
        )
    }
}

/// A corner in the row that is expected next.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct EnteredCorner {
    row: u32,
    curve: ForwardDifference<u32>,
}

impl EnteredCorner {
    /// In no row that a corner has: rows are below its height.
    const NOWHERE: Self = Self {
        row: u32::MAX,
        curve: ForwardDifference {
            inset: 0,
            missing: 0,
            cost: 0,
            cost_increment: 0,
            gain: 0,
            gain_decrement: 0,
        },
    };

    /// As [`corner_inset`].
    #[inline]
    fn inset(&mut self, radius: Size, row: u32) -> u32 {
        if radius.width == 0 || row >= radius.height {
            return 0;
        }
        if row != self.row {
            match enter_corner(radius, row) {
                Ok(curve) => self.curve = curve,
                Err(inset) => return inset,
            }
        }
        let inset = self.curve.inset;
        // No curve goes beyond its middle row. A flat one is better entered afresh.
        self.row = row.wrapping_add(1);
        if self.row == radius.height || self.curve.is_flat() {
            self.row = u32::MAX;
        } else {
            self.curve.advance();
        }
        inset
    }
}

/// The ellipse of which a corner is a quarter.
fn ellipse_of(radius: Size) -> Size {
    Size::new(radius.width.saturating_mul(2), radius.height.saturating_mul(2))
}

/// Whether the rows of corners of that radius, and of smaller ones, can be walked in `u32`.
pub fn is_narrow(radius: Size) -> bool {
    ellipse::is_narrow(ellipse_of(radius))
}

/// Columns that a corner leaves out in a row, from the outside: all, where the quarter ellipse has no pixel; none in the
/// rows after it.
#[inline]
fn corner_inset(radius: Size, row: u32) -> u32 {
    if radius.width == 0 || row >= radius.height {
        0
    } else {
        match enter_corner(radius, row) {
            Ok(curve) => curve.inset,
            Err(inset) => inset,
        }
    }
}

/// A corner in a row that it has; where it cannot be walked from there, what it leaves out.
#[inline(never)]
fn enter_corner(radius: Size, row: u32) -> Result<ForwardDifference<u32>, u32> {
    let size = ellipse_of(radius);
    if row < ellipse::first_row(size) {
        Err(radius.width)
    } else if ellipse::is_narrow(size) {
        Ok(ellipse::enter_narrow(size, row))
    } else {
        Err(ellipse::enter_wide(size, row).inset)
    }
}

fn confined(corners: CornerRadii, size: Size) -> CornerRadii {
    let sum = |one: u32, other: u32| u64::from(one) + u64::from(other);
    let CornerRadii {
        top_left,
        top_right,
        bottom_right,
        bottom_left,
    } = corners;
    let sides = [
        (sum(top_left.width, top_right.width), size.width),
        (sum(top_right.height, bottom_right.height), size.height),
        (sum(bottom_left.width, bottom_right.width), size.width),
        (sum(top_left.height, bottom_left.height), size.height),
    ];
    let (mut overlap, mut share) = (0, None);
    for (radii, side) in sides {
        let more = radii.saturating_sub(side.into());
        if more > overlap {
            (overlap, share) = (more, Some((u64::from(side), radii)));
        }
    }
    let Some((side, radii)) = share else { return corners };
    // The share is below 1: no radius becomes larger.
    let scaled = |length: u32| (u64::from(length) * side).checked_div(radii).unwrap_or(0) as u32;
    let confine = |radius: Size| Size::new(scaled(radius.width), scaled(radius.height));
    CornerRadii {
        top_left: confine(top_left),
        top_right: confine(top_right),
        bottom_right: confine(bottom_right),
        bottom_left: confine(bottom_left),
    }
}

/// A corner, from the outside to the middle.
#[derive(Debug, Clone)]
struct CornerWalk<N> {
    enter: fn(Size, u32) -> ForwardDifference<N>,
    radius: Size,
    row: u32,
    first_row: u32,
    walk: ForwardDifference<N>,
}

impl<N: CurveNumber> CornerWalk<N> {
    fn new(radius: Size, row: u32, enter: fn(Size, u32) -> ForwardDifference<N>) -> Self {
        // One without width has no rows that differ, and some walk.
        let radius = if radius.width == 0 { Size::zero() } else { radius };
        let size = ellipse_of(Size::new(radius.width.max(1), radius.height.max(1)));
        let first_row = ellipse::first_row(size);
        let start = row.max(first_row).min(radius.height.saturating_sub(1));
        Self {
            enter,
            radius,
            row,
            first_row,
            walk: enter(size, start),
        }
    }

    /// The inset of this row, and on to the next one.
    fn next(&mut self) -> u32 {
        let row = self.row;
        self.row = row.wrapping_add(1);
        if row >= self.radius.height {
            return 0;
        }
        if row < self.first_row {
            return self.radius.width;
        }
        let inset = self.walk.inset;
        if self.row < self.radius.height {
            if self.walk.is_flat() {
                self.walk = (self.enter)(ellipse_of(self.radius), self.row);
            } else {
                self.walk.advance();
            }
        }
        inset
    }
}

/// The rows of a rounded rectangle whose corners are alike, less those of one in the middle of it.
#[derive(Debug, Clone)]
pub struct RoundedRows<N> {
    row: u32,
    outer: CornerWalk<N>,
    inner: CornerWalk<N>,
    /// Columns of the box before the inner one, and rows above it.
    inner_left: u32,
    inner_top: u32,
}

impl<N: CurveNumber> RoundedRows<N> {
    /// The visible rows; the inner outline lies in the middle of the outer one, or is empty. `None` where the corners of
    /// one are not alike.
    pub fn new(
        outer: &RoundedOutline,
        inner: &RoundedOutline,
        enter: fn(Size, u32) -> ForwardDifference<N>,
        shape: &MirroredBox,
    ) -> Option<Self> {
        let row = shape.rows.start;
        let (outer_radius, inner_radius) = (outer.equal_radius()?, inner.equal_radius()?);
        // Inside the outer box, so both distances fit.
        let (inner_left, inner_top) = if inner.outline.is_empty() {
            (0, u32::MAX)
        } else {
            (
                (inner.outline.left - outer.outline.left) as u32,
                (inner.outline.top - outer.outline.top) as u32,
            )
        };
        Some(Self {
            row,
            outer: CornerWalk::new(outer_radius, row, enter),
            inner: CornerWalk::new(inner_radius, row.saturating_sub(inner_top), enter),
            inner_left,
            inner_top,
        })
    }
}

impl<N: CurveNumber> MirroredCurve for RoundedRows<N> {
    fn next_rows(&mut self, insets: &mut [Insets]) {
        for insets in insets {
            let outer = self.outer.next();
            // Radii that were confined differently can make the inner corner cut less than the outer one does.
            let hole = if self.row < self.inner_top {
                Insets::NO_HOLE
            } else {
                self.inner_left.wrapping_add(self.inner.next()).max(outer)
            };
            *insets = Insets { outer, hole };
            self.row = self.row.wrapping_add(1);
        }
    }
}

#[cfg(feature = "defmt")]
impl<N> defmt::Format for RoundedRows<N> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "RoundedRows from {}", self.row);
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{geometry::Point, primitives::Rectangle};

    use super::*;

    #[test]
    fn rows_are_the_same_in_any_order() {
        let rectangle = Rectangle::new(Point::zero(), Size::new(60, 80));
        let corners = CornerRadii {
            top_left: Size::new(30, 50),
            top_right: Size::new(29, 3),
            bottom_right: Size::new(7, 40),
            bottom_left: Size::new(2, 29),
        };
        let outline = RoundedOutline::new(rectangle.into(), corners);
        for half in [outline.upper_half(), outline.lower_half()] {
            let mut walk = half.clone();
            for row in 0..40 {
                assert_eq!(walk.insets(row), half.clone().insets(row), "{row}");
                let earlier = row / 2;
                assert_eq!(walk.clone().insets(earlier), half.clone().insets(earlier), "{row}");
            }
        }
    }
}
