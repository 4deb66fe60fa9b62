//! Rounded rectangles, row by row: each corner is a quarter of an ellipse.
//!
//! Promises: embedded-graphics' pixels; the work for a row does not depend on how long it is. Where all corners are alike,
//! the rows are walked by forward differences as those of an ellipse are, and drawn twice; otherwise each row of a corner
//! is entered by one division and one integer square root.

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

    /// Columns before the first pixel of a row of the rectangle, and after the last one.
    pub fn insets(&self, row: u32) -> (u32, u32) {
        // The rectangle has the row.
        let from_below = MirroredBox::mirrored(row, self.outline.size.height);
        // Radii that still overlap cut what either cuts.
        let inset = |top: Size, bottom: Size| corner_inset(top, row).max(corner_inset(bottom, from_below));
        let corners = &self.corners;
        (
            inset(corners.top_left, corners.bottom_left),
            inset(corners.top_right, corners.bottom_right),
        )
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
fn corner_inset(radius: Size, row: u32) -> u32 {
    let size = ellipse_of(radius);
    if radius.width == 0 || row >= radius.height {
        0
    } else if row < ellipse::first_row(size) {
        radius.width
    } else if ellipse::is_narrow(size) {
        ellipse::enter_narrow(size, row).inset
    } else {
        ellipse::enter_wide(size, row).inset
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
