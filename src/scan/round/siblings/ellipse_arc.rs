//! The arc over the top of a thin ellipse, by its definition.

use core::num::NonZero;

use embedded_graphics::geometry::Size;

use crate::{
    geometry::InputError,
    scan::round::{
        radius::check_radius,
        siblings::{arcs::Arc, circle_arc::square},
    },
};

/// The largest semi-axis in pixels, 524,287: the decision variable of the midpoint ellipse then fits 64 bits.
pub(crate) const MAX_RADIUS: u32 = (1 << 19) - 1;

/// The pixels nearest to the exact ellipse, column by column, while it is flatter than a diagonal.
///
/// There are no ties: a column's exact height is a fraction only where it has an odd denominator, the hypotenuse of a
/// Pythagorean triple without a common divisor, so it is never half a pixel.
#[derive(Debug, Copy, Clone)]
pub(crate) struct EllipseArc {
    /// The semi-axis along the columns, up to [`MAX_RADIUS`].
    pub a: u32,
    /// The semi-axis along the heights, up to [`MAX_RADIUS`].
    pub b: u32,
}

impl Arc for EllipseArc {
    fn last_column(&self) -> u32 {
        let (a_2, b_2) = (square(self.a), square(self.b));
        let Some(sum) = NonZero::new(u128::from(a_2 + b_2)) else {
            return 0;
        };
        // The exact height is b^2 x / a^2 or more where x^2 (a^2 + b^2) <= a^4.
        let last = (u128::from(a_2) * u128::from(a_2) / sum).isqrt() as u32;
        // The nearest pixel of one more column can be high enough where the exact point is not.
        let next = last + 1;
        let is_flat = next <= self.a && b_2 * u64::from(next) <= a_2 * u64::from(self.height(next));
        if is_flat { next } else { last }
    }

    fn height(&self, column: u32) -> u32 {
        let (a_2, b_2) = (square(self.a), square(self.b));
        let Some(divisor) = NonZero::new(a_2) else {
            return self.b;
        };
        let left = a_2 - square(column);
        // Twice the height, rounded down.
        let doubled = if self.is_narrow() {
            (4 * b_2 * left / divisor).isqrt()
        } else {
            // At most 4 b^2.
            ((4 * u128::from(b_2) * u128::from(left) / NonZero::<u128>::from(divisor)) as u64).isqrt()
        };
        doubled.div_ceil(2) as u32
    }

    fn last_column_of(&self, height: u32) -> Option<u32> {
        if height == 0 {
            return Some(self.a);
        }
        if height > self.b {
            return None;
        }
        let (a_2, b_2) = (u128::from(square(self.a)), u128::from(square(self.b)));
        let doubled = 2 * u128::from(height) - 1;
        // y - 1/2 below the ellipse: 4 b^2 x^2 < a^2 (4 b^2 - (2 y - 1)^2). An ellipse without width has column 0 alone.
        let limit = (a_2 * (4 * b_2 - doubled * doubled)).saturating_sub(1);
        NonZero::new(4 * b_2).map(|divisor| (limit / divisor).isqrt() as u32)
    }
}

impl EllipseArc {
    /// The arcs over the top and over the side of the ellipse with these semi-axes.
    pub fn both(radii: Size) -> Result<[Self; 2], InputError> {
        let Size { width, height } = radii;
        check_radius(width.max(height), MAX_RADIUS)?;
        let arc = |a, b| Self { a, b };
        Ok([arc(width, height), arc(height, width)])
    }

    /// Whether `4 a^2 b^2` fits 64 bits.
    const fn is_narrow(&self) -> bool {
        self.a as u64 * (self.b as u64) < 1 << 31
    }
}
