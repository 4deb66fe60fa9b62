//! The smallest box around the pixels of a polygon, found by looking at single rows and columns from outside.
//!
//! The box around the corners may be larger: a sharp corner can end between the pixel centres of its row.
//!
//! ```text
//!   \ . . . .      The corner reaches into the first row and the first column, but no pixel centre
//!   .\-_. . .      there is inside (#). The smallest box begins in the second row and the third column.
//!   . \ #-_ .
//!   .  \# # -
//! ```
//!
//! A row has a pixel where the winding number is that of the inside at the first pixel right of some edge, since it changes
//! nowhere else. From the box around the corners, each side moves inwards until its row or column has a pixel. A column is
//! tested in the same way, with the columns and rows of all corners exchanged. Only centres exactly on an edge differ: the
//! top-left rule takes them as if they lay a little further to the right, and by much less further down.
//!
//! Guarantees: every pixel is in the box, in exact arithmetic, by the top-left rule. The box is the smallest one where no
//! side has to move by more than [`MOST_LINES`], and all polygons of a stroke together test at most [`MOST_LINE_TESTS`]
//! rows and columns. Cost: for each row or column tested, all edges as often as one of them crosses it, and a division each
//! time; mostly one to three rows or columns a side.

use core::{num::NonZeroU64, ops::RangeInclusive};

use crate::{
    geometry::Bounds,
    scan::polygon::{scanline_polygon::FillRule, shrunk_box::MOST_LINES},
};

/// The most rows and columns that are tested for all polygons of a shape, which bounds the work for dashes without pixels.
pub(crate) const MOST_LINE_TESTS: u32 = 1 << 14;

/// The edges of a polygon, closed: generates the same ones at each call, as their ends (x, y) in units.
pub(crate) type Sides<'a> = dyn Fn(&mut dyn FnMut([i64; 2], [i64; 2])) + 'a;

/// A polygon whose pixels are looked for. Its corners are numbers of 32 bits.
#[derive(Copy, Clone)]
pub(crate) struct PolygonPixels<'a> {
    /// The edges of the polygon.
    pub sides: &'a Sides<'a>,
    /// The rule that says which winding numbers are inside.
    pub fill_rule: FillRule,
    /// A pixel is `1 << fraction_bits` units, at most 16 bits.
    pub fraction_bits: u32,
}

/// A row or a column of pixels, by its number.
#[derive(Copy, Clone)]
enum RowOrColumn {
    Column(i64),
    Row(i64),
}

impl PolygonPixels<'_> {
    /// Grows bounds so that they hold the pixels of the polygon. Only rows and columns outside the bounds are tested, each of
    /// which takes one off `tests_left`.
    #[must_use]
    pub fn grow(&self, bounds: Bounds, tests_left: &mut u32) -> Bounds {
        let corners = self.box_of_corners();
        if corners.is_empty() || bounds.contains(&corners) {
            return bounds;
        }
        self.grow_to(bounds, &corners, tests_left).unwrap_or(bounds)
    }

    /// Grows bounds to the pixels of the polygon; `None` where it has none.
    fn grow_to(&self, bounds: Bounds, corners: &Bounds, tests_left: &mut u32) -> Option<Bounds> {
        let mut first =
            |line, numbers, known, backwards| self.first_with_pixel((line, numbers), (known, backwards), tests_left);
        let &Bounds {
            left,
            top,
            right,
            bottom,
        } = corners;
        Some(Bounds {
            left: first(
                RowOrColumn::Column as fn(i64) -> RowOrColumn,
                left..=right,
                bounds.left,
                false,
            )?,
            top: first(RowOrColumn::Row, top..=bottom, bounds.top, false)?,
            right: first(RowOrColumn::Column, left..=right, bounds.right, true)?,
            bottom: first(RowOrColumn::Row, top..=bottom, bounds.bottom, true)?,
        })
    }

    /// The box around the pixel centres between the corners; its right and lower sides are excluded.
    fn box_of_corners(&self) -> Bounds {
        let first_centre = |units: i64| -((-units) >> self.fraction_bits);
        let mut bounds = Bounds::EMPTY;
        (self.sides)(&mut |from, to| {
            if from != to {
                bounds = bounds.with(from[0], from[1]).with(to[0], to[1]);
            }
        });
        if bounds.is_empty() {
            return bounds;
        }
        Bounds {
            left: first_centre(bounds.left),
            top: first_centre(bounds.top),
            right: first_centre(bounds.right) - 1,
            bottom: first_centre(bounds.bottom) - 1,
        }
    }

    /// The number of the first row or column with a pixel, or of the last one if the way is `backwards`. It ends at the
    /// `known` side of the bounds, which is the answer there, after [`MOST_LINES`], or where no tests are left. `None`
    /// where all are without a pixel.
    fn first_with_pixel(
        &self,
        (line, numbers): (fn(i64) -> RowOrColumn, RangeInclusive<i64>),
        (known, backwards): (i64, bool),
        tests_left: &mut u32,
    ) -> Option<i64> {
        let (from, to, step) = if backwards {
            (*numbers.end(), *numbers.start(), -1)
        } else {
            (*numbers.start(), *numbers.end(), 1)
        };
        let mut number = from;
        loop {
            let is_known = if backwards { number <= known } else { number >= known };
            if is_known {
                return Some(known);
            }
            let is_given_up = *tests_left == 0 || number.abs_diff(from) == u64::from(MOST_LINES);
            *tests_left = tests_left.saturating_sub(1);
            if is_given_up || self.has_pixel(line(number)) {
                return Some(number);
            }
            if number == to {
                return None;
            }
            number += step;
        }
    }

    fn has_pixel(&self, line: RowOrColumn) -> bool {
        let mut found = false;
        (self.sides)(&mut |from, to| {
            found = found
                || self
                    .crossing(line, from, to)
                    .is_some_and(|(pixel, _)| self.contains(line, pixel));
        });
        found
    }

    /// Whether a pixel of a row or a column is inside.
    fn contains(&self, line: RowOrColumn, pixel: i64) -> bool {
        let mut winding = 0i32;
        (self.sides)(&mut |from, to| match self.crossing(line, from, to) {
            Some((first, direction)) if first <= pixel => winding += direction,
            _ => {}
        });
        self.fill_rule.includes(winding)
    }

    /// The first pixel of a row that lies right of an edge (of a column, below it), and the edge's direction; `None` where
    /// it does not cross.
    fn crossing(&self, line: RowOrColumn, from: [i64; 2], to: [i64; 2]) -> Option<(i64, i32)> {
        // Along the edge goes the coordinate that the pixels of the line share, across goes that by which they differ.
        let ((number, [from, to]), is_row) = match line {
            RowOrColumn::Row(y) => ((y, [from, to].map(|[x, y]| (y, x))), true),
            RowOrColumn::Column(x) => ((x, [from, to].map(|[x, y]| (x, y))), false),
        };
        let (start, end, direction) = if from.0 < to.0 { (from, to, 1) } else { (to, from, -1) };
        let length = NonZeroU64::new(end.0.abs_diff(start.0))?;
        let at = number << self.fraction_bits;
        if at < start.0 || at >= end.0 {
            return None;
        }
        // Below 2^32 each.
        let product = at.abs_diff(start.0) * end.1.abs_diff(start.1);
        let (quotient, remainder) = ((product / length) as i64, product % length);
        let is_backwards = end.1 < start.1;
        let units = match (is_backwards, remainder) {
            (false, _) => start.1 + quotient,
            (true, 0) => start.1 - quotient,
            (true, _) => start.1 - quotient - 1,
        };
        let pixel = units >> self.fraction_bits;
        let is_centre = remainder == 0 && pixel << self.fraction_bits == units;
        // A little further to the right, a centre on the edge of a column lies below it where the edge rises.
        let is_behind = is_centre && (is_row || is_backwards || end.1 == start.1);
        Some((pixel + i64::from(!is_behind), direction))
    }
}
