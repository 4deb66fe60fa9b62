//! Rounded rectangles, row by row: each corner is a quarter of an ellipse.
//!
//! A corner has a box as large as its radius, from the corner of the rectangle inwards. Of the pixels in that box it cuts
//! off those outside the ellipse about the box's innermost corner. A pixel belongs to the shape if it is in the rectangle
//! and no corner cuts it off, so that a row is what lies between two insets:
//!
//! ```text
//! +-----+
//! |  ###|######   row 0: inset 2
//! | ####|######   row 1: inset 1
//! |#####|######   row 2: inset 0
//! +-----+
//!  ############   radius 5 x 3
//! ```
//!
//! Radii that take more than a side are scaled down first, all by one factor, which makes room on the side with the largest
//! overlap: embedded-graphics' rule. Another side may need a smaller factor. There boxes still share columns or rows, and a
//! box may reach beyond the rectangle: each corner cuts off its pixels all the same, and a row of which both sides together
//! leave nothing is empty.
//!
//! Guarantees: embedded-graphics' pixels where boxes share nothing and every corner has a pixel in each of its rows; the
//! exact inequality for every radius that a `Size` holds; the work for a row does not depend on its length. Corners are
//! walked by forward differences, as an ellipse is: once for both halves and both sides where all of them are alike and
//! share no columns (`RoundedRows`), otherwise each by itself, from the first row that is asked for (`HalfRows`). There,
//! a corner's rows beyond the middle of the rectangle, and all rows of one too large for 32 bits, are entered afresh, by
//! two divisions and two integer square roots each.

use core::{num::NonZero, ops::Range};

use embedded_graphics::{geometry::Size, primitives::CornerRadii};

use crate::{
    geometry::{WideRectangle, Window},
    scan::round::{Curve, CurveNumber, ForwardDifference, ellipse},
    surface::{SymmetricBox, SymmetricCurve, SymmetricSpan},
};

/// A rectangle with rounded corners whose position may lie outside the number range of a `Point`.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct WideRoundedRectangle {
    /// The rectangle whose corners are rounded.
    pub rectangle: WideRectangle,
    corners: CornerRadii,
}

impl WideRoundedRectangle {
    /// A rectangle with these corner radii. Where radii take more than a side, all of them are scaled down by one
    /// factor.
    pub fn new(rectangle: WideRectangle, corners: CornerRadii) -> Self {
        let corners = if rectangle.is_empty() {
            CornerRadii::default()
        } else {
            confined(corners, rectangle.size)
        };
        Self { rectangle, corners }
    }

    /// The radius of all corners, if they are alike and share no columns.
    ///
    /// Each row is then symmetric about the middle column, with insets of at most half of the width.
    pub fn symmetric_radius(&self) -> Option<Size> {
        let CornerRadii {
            top_left,
            top_right,
            bottom_right,
            bottom_left,
        } = self.corners;
        let are_alike = [top_right, bottom_right, bottom_left]
            .iter()
            .all(|corner| *corner == top_left);
        (are_alike && top_left.width <= self.rectangle.size.width / 2).then_some(top_left)
    }

    /// Whether each side has a part that no corner takes, so that its row or column has a pixel.
    pub fn has_straight_sides(&self) -> bool {
        let Size { width, height } = self.rectangle.size;
        let is_longer = |side: u32, one: u32, other: u32| u64::from(side) > u64::from(one) + u64::from(other);
        let corners = &self.corners;
        is_longer(width, corners.top_left.width, corners.top_right.width)
            && is_longer(width, corners.bottom_left.width, corners.bottom_right.width)
            && is_longer(height, corners.top_left.height, corners.bottom_left.height)
            && is_longer(height, corners.top_right.height, corners.bottom_right.height)
    }

    /// Whether a pixel is in a window inside the rectangle. Cost: that of its rows up to the first one with a pixel.
    pub fn has_pixel(&self, window: &Window) -> bool {
        let row_number = |y: i32| (i64::from(y) - self.rectangle.top) as u32;
        let column = |number: u32| self.rectangle.left + i64::from(number);
        let (mut upper, mut lower) = (self.upper_half(), self.lower_half());
        (window.top..window.bottom).any(|y| {
            let row = row_number(y);
            let height = self.rectangle.size.height;
            let columns = if row < height / 2 {
                upper.columns(row)
            } else {
                lower.columns(SymmetricBox::mirrored(row, height))
            };
            let first = column(columns.start).max(window.left.into());
            first < column(columns.end).min(window.right.into())
        })
    }

    /// The rounded rectangle with columns and rows exchanged.
    #[must_use]
    pub const fn transposed(&self) -> Self {
        const fn exchanged(size: Size) -> Size {
            Size::new(size.height, size.width)
        }
        let corners = &self.corners;
        Self {
            rectangle: self.rectangle.transposed(),
            corners: CornerRadii {
                top_left: exchanged(corners.top_left),
                top_right: exchanged(corners.bottom_left),
                bottom_right: exchanged(corners.bottom_right),
                bottom_left: exchanged(corners.top_right),
            },
        }
    }

    /// The rows of the upper half, from the first one to the middle.
    pub const fn upper_half(&self) -> HalfRows {
        let corners = &self.corners;
        HalfRows {
            corners: [corners.top_left, corners.top_right],
            walks: [EnteredCorner::NOWHERE; 2],
            opposite: [corners.bottom_left, corners.bottom_right],
            size: self.rectangle.size,
        }
    }

    /// The rows of the lower half, from the last one to the middle.
    pub const fn lower_half(&self) -> HalfRows {
        let corners = &self.corners;
        HalfRows {
            corners: [corners.bottom_left, corners.bottom_right],
            walks: [EnteredCorner::NOWHERE; 2],
            opposite: [corners.top_left, corners.top_right],
            size: self.rectangle.size,
        }
    }
}

/// The rows of one half of a rounded rectangle with any corners, counted from the outside.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct HalfRows {
    /// Radii of the left and the right corner.
    corners: [Size; 2],
    walks: [EnteredCorner; 2],
    /// Radii of the corners of the other half, which may reach beyond the middle.
    opposite: [Size; 2],
    size: Size,
}

impl HalfRows {
    /// The columns of a row of the rectangle that no corner cuts off, counted from its left side.
    ///
    /// Cost: additions for the row after the last one that was asked for.
    #[inline]
    pub fn columns(&mut self, row: u32) -> Range<u32> {
        let Size { width, height } = self.size;
        let opposite_row = SymmetricBox::mirrored(row, height);
        let ([left, right], [opposite_left, opposite_right]) = (self.corners, self.opposite);
        let [left_walk, right_walk] = &mut self.walks;
        let before = left_walk
            .inset(left, row)
            .max(corner_inset(opposite_left, opposite_row));
        let after = right_walk
            .inset(right, row)
            .max(corner_inset(opposite_right, opposite_row));
        // A corner's box may be wider than the rectangle.
        let end = width.saturating_sub(after);
        before.min(end)..end
    }
}

/// The curve of a corner, in the row that is expected next.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct EnteredCorner {
    row: u32,
    curve: ForwardDifference<u32>,
}

impl EnteredCorner {
    /// The state before any row was entered: its row number is one that no corner has, because rows are below its height.
    const NOWHERE: Self = Self {
        row: u32::MAX,
        curve: ForwardDifference {
            inset: 0,
            error_term: 0,
            column_increment: 0,
            column_increment_step: 0,
            row_increment: 0,
            row_increment_step: 0,
        },
    };

    /// The columns that the corner cuts off a row, as [`corner_inset`] gives them; stepped where the row follows the
    /// last one.
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
        // A curve ends at its middle row. A flat one is better entered afresh.
        self.row = row + 1;
        if self.row == radius.height || self.curve.is_flat() {
            self.row = u32::MAX;
        } else {
            self.curve.advance();
        }
        inset
    }
}

/// Columns that a corner cuts off a row, from the outside: all of its box, where the quarter ellipse has no pixel; none in
/// the rows after it.
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

/// Enters a corner in one of its rows. The error is the inset alone, where the corner cannot be walked from there.
#[inline(never)]
fn enter_corner(radius: Size, row: u32) -> Result<ForwardDifference<u32>, u32> {
    if is_narrow(radius) {
        if row < first_row_narrow(radius) {
            Err(radius.width)
        } else {
            Ok(enter_narrow(radius, row))
        }
    } else if row < first_row_wide(radius) {
        Err(radius.width)
    } else {
        Err(enter_wide(radius, row).inset)
    }
}

/// Corners that are walked in `u32`, where [`is_narrow`] says so. Sizes are radii.
pub(crate) const NARROW: Curve<u32> = Curve {
    first_row: first_row_narrow,
    enter: enter_narrow,
};

/// Corners of every radius. Sizes are radii.
pub(crate) const WIDE: Curve<u128> = Curve {
    first_row: first_row_wide,
    enter: enter_wide,
};

/// Whether the rows of corners of that radius, and of smaller ones, can be walked in `u32`.
pub(crate) fn is_narrow(radius: Size) -> bool {
    const LONGEST: u32 = u32::MAX / 2;
    radius.width <= LONGEST && radius.height <= LONGEST && ellipse::is_narrow(whole_ellipse(radius))
}

/// The ellipse of which a corner is a quarter. Radii are below 2^31.
const fn whole_ellipse(radius: Size) -> Size {
    Size::new(2 * radius.width, 2 * radius.height)
}

/// The first row in which a corner has a pixel. Neither radius is 0.
fn first_row_narrow(radius: Size) -> u32 {
    ellipse::first_row(whole_ellipse(radius))
}

/// A corner in a row that it has a pixel in.
fn enter_narrow(radius: Size, row: u32) -> ForwardDifference<u32> {
    ellipse::enter_narrow(whole_ellipse(radius), row)
}

// A quarter ellipse of every radius: with `u` whole columns and `v` whole rows between a pixel and the middle, its doubled
// distances are 2u + 1 and 2v + 1, and h^2 (2u + 1)^2 + w^2 (2v + 1)^2 < 4 w^2 h^2 becomes
// h^2 (u^2 + u) + w^2 (v^2 + v) <= limit. No number exceeds w^2 h^2 or 2 h^2 w, so that all of them fit `u128`.

fn squares(radius: Size) -> [u128; 2] {
    [radius.width, radius.height].map(|length| u128::from(length) * u128::from(length))
}

fn limit([width_2, height_2]: [u128; 2]) -> u128 {
    width_2 * height_2 - (width_2 + height_2) / 4 - 1
}

/// The largest `n` for which `square * (n^2 + n)` is within the limit.
fn largest_within(limit: u128, square: u128) -> u32 {
    // A radius is at least 1.
    let square = NonZero::new(square).unwrap_or(NonZero::<u128>::MIN);
    // (2n + 1)^2 = 4 (n^2 + n) + 1.
    (((4 * (limit / square) + 1).isqrt() - 1) / 2) as u32
}

/// The first row in which a corner has a pixel. Neither radius is 0.
fn first_row_wide(radius: Size) -> u32 {
    let squares = squares(radius);
    radius.height - 1 - largest_within(limit(squares), squares[0])
}

/// A corner in a row that it has a pixel in.
fn enter_wide(radius: Size, row: u32) -> ForwardDifference<u128> {
    let [width_2, height_2] = squares(radius);
    let v = u128::from(radius.height - 1 - row);
    let decision_variable = limit([width_2, height_2]) - width_2 * (v * v + v);
    let column = largest_within(decision_variable, height_2);
    let u = u128::from(column);
    let column_increment = 2 * height_2 * (u + 1);
    ForwardDifference {
        inset: radius.width - 1 - column,
        error_term: column_increment - (decision_variable - height_2 * (u * u + u)),
        column_increment,
        column_increment_step: 2 * height_2,
        row_increment: 2 * width_2 * v,
        row_increment_step: 2 * width_2,
    }
}

/// embedded-graphics' rule: the side whose two radii exceed it by the largest number of pixels decides by how much all radii
/// are scaled down.
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
    let (mut largest, mut scale) = (0, None);
    for (radii, side) in sides {
        let overlap = radii.saturating_sub(side.into());
        if overlap > largest {
            largest = overlap;
            scale = NonZero::new(radii).map(|radii| (u64::from(side), radii));
        }
    }
    let Some((side, radii)) = scale else { return corners };
    // The side is shorter than the radii: no length becomes larger.
    let scaled = |length: u32| (u64::from(length) * side / radii) as u32;
    let confine = |radius: Size| Size::new(scaled(radius.width), scaled(radius.height));
    CornerRadii {
        top_left: confine(top_left),
        top_right: confine(top_right),
        bottom_right: confine(bottom_right),
        bottom_left: confine(bottom_left),
    }
}

/// A corner, from the outside to the middle of the rectangle.
#[derive(Debug, Clone)]
struct CornerWalk<N> {
    enter: fn(Size, u32) -> ForwardDifference<N>,
    radius: Size,
    row: u32,
    first_row: u32,
    walk: ForwardDifference<N>,
}

impl<N: CurveNumber> CornerWalk<N> {
    fn new(radius: Size, row: u32, curve: Curve<N>) -> Self {
        // A corner without columns has no rows either; its walk, which is never asked, is that of one pixel.
        let radius = if radius.width == 0 { Size::zero() } else { radius };
        let entered = Size::new(radius.width.max(1), radius.height.max(1));
        let first_row = (curve.first_row)(entered);
        let start = row.max(first_row).min(entered.height - 1);
        Self {
            enter: curve.enter,
            radius,
            row,
            first_row,
            walk: (curve.enter)(entered, start),
        }
    }

    /// Returns the inset of the current row, and goes on to the next row.
    fn next(&mut self) -> u32 {
        let row = self.row;
        self.row = row + 1;
        if row >= self.radius.height {
            return 0;
        }
        if row < self.first_row {
            return self.radius.width;
        }
        let inset = self.walk.inset;
        if self.row < self.radius.height {
            if self.walk.is_flat() {
                self.walk = (self.enter)(self.radius, self.row);
            } else {
                self.walk.advance();
            }
        }
        inset
    }
}

/// The rows of a rounded rectangle whose corners are alike and share no columns, less those of one in the middle of it.
///
/// The corners of the lower half add nothing in the upper one: where their boxes reach beyond the middle row, they cut off
/// less than the corners above.
#[derive(Debug, Clone)]
pub(crate) struct RoundedRows<N> {
    row: u32,
    outer: CornerWalk<N>,
    inner: CornerWalk<N>,
    /// Columns of the box before the inner one, and rows above it.
    inner_left: u32,
    inner_top: u32,
}

impl<N: CurveNumber> RoundedRows<N> {
    /// The visible rows. The inner rectangle lies in the middle of the outer one, or is empty; both have a radius that is
    /// [symmetric](WideRoundedRectangle::symmetric_radius).
    pub fn new([outer, inner]: [&WideRectangle; 2], radii: [Size; 2], curve: Curve<N>, shape: &SymmetricBox) -> Self {
        let row = shape.rows.start;
        let [outer_radius, inner_radius] = radii;
        debug_assert!(outer_radius.width <= outer.size.width / 2 && inner_radius.width <= inner.size.width / 2);
        // Inside the outer box, so both distances fit.
        let (inner_left, inner_top) = if inner.is_empty() {
            (0, u32::MAX)
        } else {
            ((inner.left - outer.left) as u32, (inner.top - outer.top) as u32)
        };
        Self {
            row,
            outer: CornerWalk::new(outer_radius, row, curve),
            inner: CornerWalk::new(inner_radius, row.saturating_sub(inner_top), curve),
            inner_left,
            inner_top,
        }
    }
}

impl<N: CurveNumber> SymmetricCurve for RoundedRows<N> {
    fn next_rows(&mut self, spans: &mut [SymmetricSpan]) {
        for span in spans {
            let outer = self.outer.next();
            // Radii of both that are scaled down by different factors can make the inner corner cut off less.
            let inner = if self.row < self.inner_top {
                SymmetricSpan::NO_INNER
            } else {
                (self.inner_left + self.inner.next()).max(outer)
            };
            *span = SymmetricSpan { outer, inner };
            self.row += 1;
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
        let rounded = WideRoundedRectangle::new(rectangle.into(), corners);
        for half in [rounded.upper_half(), rounded.lower_half()] {
            let mut walk = half.clone();
            for row in 0..40 {
                assert_eq!(walk.columns(row), half.clone().columns(row), "{row}");
                let earlier = row / 2;
                assert_eq!(walk.clone().columns(earlier), half.clone().columns(earlier), "{row}");
            }
        }
    }
}
