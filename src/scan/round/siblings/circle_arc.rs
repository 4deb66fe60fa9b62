//! The arc over the top of a thin circle, up to the diagonal, by its definition.

use crate::scan::round::siblings::arcs::Arc;

/// The pixels nearest to the exact circle, column by column. There are no ties: `r^2 - x^2` is never the square of a half.
#[derive(Debug, Copy, Clone)]
pub(crate) struct CircleArc {
    /// The radius in pixels, below 2^31.
    pub radius: u32,
}

impl Arc for CircleArc {
    fn last_column(&self) -> u32 {
        // The largest x with x <= y: x^2 - x < r^2 - x^2, so 2 x^2 - x < r^2. The root of half of what is below r^2 is that x
        // or the one before.
        let Some(limit) = square(self.radius).checked_sub(1) else {
            return 0;
        };
        let root = (limit / 2).isqrt();
        let next = root + 1;
        let column = if 2 * next * next - next <= limit { next } else { root };
        column as u32
    }

    fn height(&self, column: u32) -> u32 {
        // Twice the height, rounded down; below 2^64 under the root.
        let doubled = (4 * (square(self.radius) - square(column))).isqrt();
        doubled.div_ceil(2) as u32
    }

    fn last_column_of(&self, height: u32) -> Option<u32> {
        if height == 0 {
            return Some(self.radius);
        }
        // y - 1/2 below the circle: x^2 < r^2 - y^2 + y - 1/4.
        let limit = (square(self.radius) + u64::from(height) - 1).checked_sub(square(height))?;
        Some(limit.isqrt() as u32)
    }
}

/// The square of a distance, which 64 bits hold.
pub(crate) const fn square(number: u32) -> u64 {
    number as u64 * number as u64
}
