//! The two sides of a disc at any position, as edges beside those of polygons.
//!
//! Guarantees: the pixels whose centres are nearer to the disc's centre than its radius, and on a tie by the top-left rule,
//! those of the left half: exact integers in 1/65,536 pixel. Cost: an integer square root to enter, then a 64-bit product
//! or two a row, and one for each column that the side moves.

use core::ops::Range;

use crate::{
    geometry::Bounds,
    scan::{
        polygon::{Crossing, ScanEdge},
        stroke::wide_stroke::{Corner, FRACTION_BITS, UNIT},
    },
};

/// One side of a disc.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiscSide {
    center: Corner,
    radius: i32,
    is_right: bool,
}

impl DiscSide {
    /// The left and the right side of a disc, centre and radius in 1/65,536 pixel. The radius is below 2^27, and the disc within
    /// the bounds of a stroke ([`wide_stroke`](crate::scan::stroke::wide_stroke)), so that no product leaves 64 bits.
    pub(crate) fn both(center: Corner, radius: i32) -> [Self; 2] {
        [false, true].map(|is_right| Self {
            center,
            radius,
            is_right,
        })
    }

    /// The smallest box around the pixels of a disc.
    ///
    /// The row nearest to the centre has the first and the last column. A row near the ends may have no pixel; half a pixel
    /// further inside it has one, so that few are asked.
    pub(crate) fn bounds(center: Corner, radius: i32) -> Bounds {
        let [left, right] = Self::both(center, radius);
        let columns = |row: i32| left.crossing_at(row).x..right.crossing_at(row).x;
        let has_pixel = |row: &i32| !columns(*row).is_empty();
        let mut rows = left.first_row()..left.end_row();
        let nearest = nearest_pixel(center.1);
        if !rows.contains(&nearest) || !has_pixel(&nearest) {
            return Bounds::EMPTY;
        }
        let Range { start, end } = columns(nearest);
        // Both ways end at the row nearest to the centre, if not before.
        let first = rows.find(has_pixel).unwrap_or(nearest);
        let last = rows.rev().find(has_pixel).unwrap_or(first);
        Bounds::EMPTY
            .with(start.into(), first.into())
            .with(i64::from(end) - 1, last.into())
    }

    /// The square of half the disc's width in a row that it crosses.
    fn decision_variable(&self, row: i32) -> i64 {
        let distance = from_center(row, self.center.1);
        let radius = i64::from(self.radius);
        radius * radius - distance * distance
    }

    /// Whether the centre of a pixel is on this side or right of it.
    fn is_reached(&self, x: i32, decision_variable: i64) -> bool {
        let distance = from_center(x, self.center.0);
        if self.is_right {
            distance >= 0 && distance * distance >= decision_variable
        } else {
            distance >= 0 || distance * distance <= decision_variable
        }
    }
}

/// One coordinate of the vector from a disc's centre to a pixel's centre; below 2^31 where both are near.
fn from_center(pixel: i32, center: i32) -> i64 {
    i64::from((pixel << FRACTION_BITS) - center)
}

/// The first pixel whose centre is at a coordinate or after it.
const fn ceil(units: i32) -> i32 {
    ((units as i64 + UNIT - 1) >> FRACTION_BITS) as i32
}

/// The pixel whose centre is nearest to a coordinate.
const fn nearest_pixel(units: i32) -> i32 {
    ((units as i64 + UNIT / 2) >> FRACTION_BITS) as i32
}

impl ScanEdge for DiscSide {
    fn first_row(&self) -> i32 {
        ceil(self.center.1 - self.radius)
    }

    fn end_row(&self) -> i32 {
        ceil(self.center.1 + self.radius)
    }

    fn crossing_at(&self, row: i32) -> Crossing {
        let decision_variable = self.decision_variable(row) as u64;
        let root = decision_variable.isqrt();
        let reach = root as i32;
        Crossing::at(ceil(if self.is_right {
            let is_rounded_down = root * root != decision_variable;
            self.center.0 + reach + i32::from(is_rounded_down)
        } else {
            self.center.0 - reach
        }))
    }

    fn next_crossing(&self, before: Crossing, row: i32) -> Crossing {
        let decision_variable = self.decision_variable(row);
        let mut x = before.x;
        while self.is_reached(x - 1, decision_variable) {
            x -= 1;
        }
        while !self.is_reached(x, decision_variable) {
            x += 1;
        }
        Crossing::at(x)
    }

    fn windings(&self) -> (i8, i8) {
        (0, if self.is_right { -1 } else { 1 })
    }
}
