//! Bresenham's circle (1977), one pixel thin, by rows, entered at the edge of the window by an integer square root.
//!
//! Guarantees: eightfold symmetric and 8-connected; in the octant from the top to the diagonal each column has the pixel
//! nearest to the exact circle (there are no ties: `r^2 - x^2` is never the square of a half), for every radius up to
//! [`MAX_RADIUS`]; rows and octants outside the window are not walked.

use core::ops::Range;

use embedded_graphics::geometry::{Point, Size};

use crate::{
    geometry::InputError,
    geometry::{WideRectangle, Window},
    scan::round::{ForwardDifference, conics::Conics, radius::check_radius},
    surface::{SymmetricBox, SymmetricCurve, SymmetricSpan},
};

/// The largest radius: the box of a larger circle has more columns than a `u32` counts.
pub(crate) const MAX_RADIUS: u32 = i32::MAX as u32;

impl Conics {
    /// The visible pixels of the thin circle about a pixel, by rows, row by row from the outside to the middle, each row with its mirrored
    /// one. Radius 0 is that pixel.
    ///
    /// [`ThinCircle`](crate::draw::ThinCircle) draws the rows themselves; this is what the siblings are compared with.
    ///
    /// Cost: up to three integer square roots, one more on crossing the diagonal, and constant for each visible row and pixel.
    /// Source: Bresenham 1977; the entry at the window's edge by a square root.
    ///
    /// # Errors
    /// [`InputError::RadiusTooLarge`] above 2,147,483,647 pixels.
    pub fn bresenham_circle(
        center: Point,
        radius: u32,
        window: &Window,
    ) -> Result<impl Iterator<Item = Point> + use<>, InputError> {
        check_radius(radius, MAX_RADIUS)?;
        let bounding_box = WideRectangle {
            left: i64::from(center.x) - i64::from(radius),
            top: i64::from(center.y) - i64::from(radius),
            size: Size::new_equal(2 * radius + 1),
        };
        let shape = SymmetricBox::new(bounding_box, window);
        Ok(shape.into_iter().flat_map(points))
    }
}

/// The visible pixels of the circle that fills a box.
fn points(shape: SymmetricBox) -> impl Iterator<Item = Point> {
    let mut circle = BresenhamCircle::new(&shape);
    shape.rows.clone().flat_map(move |row| {
        let mut span = SymmetricSpan::default();
        circle.next_rows(core::slice::from_mut(&mut span));
        let [start, inner_start, inner_end, end] = shape.bounds(span);
        let line = move |y| {
            let columns = (start..inner_start).chain(inner_end..end);
            columns.map(move |x| Point::new(x, y))
        };
        shape.lines(row).into_iter().flatten().flat_map(line)
    })
}

/// The visible rows of a thin circle, from the outside to the middle. The hole of a row is what the circle encloses.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct BresenhamCircle {
    /// The radius in pixels, at most [`MAX_RADIUS`].
    radius: u32,
    rows: Range<u32>,
    /// First row below the diagonal: from there on one pixel a side.
    sides_start: u32,
    /// The curve that is walked: above the diagonal the last column of a row's run, below it the row's only one.
    walk: ForwardDifference<u32>,
    /// Above the diagonal: where the run of the row above ends, and so where this row's hole ends.
    inner_inset: u32,
}

impl BresenhamCircle {
    /// The visible rows of the circle that fills a box. A circle's box is `2 * radius + 1` pixels wide and high.
    ///
    /// Cost: up to three integer square roots, and one more on crossing the diagonal.
    pub fn new(shape: &SymmetricBox) -> Self {
        let (radius, rows) = (shape.size.width / 2, shape.rows.clone());
        // The run of the last column above the diagonal is in the last row above it.
        let diagonal_row = last_row_above_diagonal(radius);
        let sides_start = diagonal_row.saturating_add(1);
        let row = rows.start;
        let (walk, inner_inset) = if row >= sides_start {
            (side(radius, row), 0)
        } else if row == 0 {
            (cap(radius, 0), SymmetricSpan::NO_INNER)
        } else {
            (cap(radius, row), cap(radius, row - 1).inset)
        };
        Self {
            radius,
            rows,
            sides_start,
            walk,
            inner_inset,
        }
    }

    /// The spans of the next rows, all of which lie above the diagonal.
    fn next_caps(&mut self, spans: &mut [SymmetricSpan]) {
        let (radius, rows) = (self.radius, self.rows.start..self.rows.end.min(self.sides_start));
        let mut inner = self.inner_inset;
        let mut walk = self.walk();
        walk.walk(
            rows,
            |row| cap(radius, row),
            spans,
            |span, outer| {
                *span = SymmetricSpan { outer, inner };
                inner = outer;
            },
        );
        self.inner_inset = inner;
        self.pass(spans.len(), walk);
        if self.rows.start == self.sides_start && !self.rows.is_empty() {
            self.walk = side(radius, self.sides_start);
        }
    }

    /// The spans of the next rows, all of which lie below the diagonal.
    fn next_sides(&mut self, spans: &mut [SymmetricSpan]) {
        let radius = self.radius;
        let mut walk = self.walk();
        walk.walk(
            self.rows.clone(),
            |row| side(radius, row),
            spans,
            |span, outer| {
                *span = SymmetricSpan {
                    outer,
                    inner: outer + 1,
                };
            },
        );
        self.pass(spans.len(), walk);
    }

    /// The walk, with what is the same in all rows as constants, which need no registers.
    fn walk(&self) -> ForwardDifference<u32> {
        ForwardDifference {
            column_increment_step: INCREMENT,
            row_increment_step: INCREMENT,
            ..self.walk
        }
    }

    fn pass(&mut self, rows: usize, walk: ForwardDifference<u32>) {
        self.rows.start += rows as u32;
        self.walk = walk;
    }
}

impl SymmetricCurve for BresenhamCircle {
    fn next_rows(&mut self, spans: &mut [SymmetricSpan]) {
        let above = self.sides_start.saturating_sub(self.rows.start) as usize;
        let above = above.min(spans.len());
        let (caps, sides) = spans.split_at_mut_checked(above).unwrap_or_default();
        if !caps.is_empty() {
            self.next_caps(caps);
        }
        self.next_sides(sides);
    }
}

/// What each column costs more than the one before, and each row adds less to the decision variable: `(x + 1)^2 - x^2`
/// grows by 2.
const INCREMENT: u32 = 2;

/// The row of the last column that lies above the diagonal or on it: the largest x that is not more than its y.
fn last_row_above_diagonal(radius: u32) -> u32 {
    let Some(limit) = square(radius).checked_sub(1) else {
        return 0;
    };
    // y >= x where x^2 - x < r^2 - x^2. The root of half the limit is that x or the one before.
    let root = (limit / 2).isqrt();
    let next = root + 1;
    let x = if 2 * next * next - next <= limit { next } else { root } as u32;
    radius - nearest(square(radius) - square(x))
}

/// The walk of the rows above the diagonal: the last x whose nearest y is this row's, `x^2 <= r^2 - y^2 + y - 1`.
fn cap(radius: u32, row: u32) -> ForwardDifference<u32> {
    let y = radius - row;
    let decision_variable = (square(radius) - square(y) + u64::from(y)).saturating_sub(1);
    let x = decision_variable.isqrt() as u32;
    let column_increment = 2 * x + 1;
    ForwardDifference {
        inset: radius - x,
        error_term: column_increment - (decision_variable - square(x)) as u32,
        column_increment,
        column_increment_step: INCREMENT,
        // Modulo 2^32: in the middle row it is negative, and not used.
        row_increment: (2 * y).wrapping_sub(2),
        row_increment_step: INCREMENT,
    }
}

/// The walk of the rows below the diagonal: the x nearest to the circle, `x^2 - x <= r^2 - y^2 - 1`.
fn side(radius: u32, row: u32) -> ForwardDifference<u32> {
    let y = radius - row;
    let square_of_x = square(radius) - square(y);
    let x = nearest(square_of_x);
    let spent = square(x) - u64::from(x);
    let column_increment = 2 * x;
    ForwardDifference {
        inset: radius - x,
        // From 1 to `column_increment + 1`, because x is the nearest.
        error_term: (u64::from(column_increment) + 1 + spent - square_of_x) as u32,
        column_increment,
        column_increment_step: INCREMENT,
        // Modulo 2^32: in the middle row it is negative, and not used.
        row_increment: (2 * y).wrapping_sub(1),
        row_increment_step: INCREMENT,
    }
}

/// The integer nearest to the root of a number below 2^62.
fn nearest(number: u64) -> u32 {
    let root = number.isqrt();
    // Up to the half, (root + 1/2)^2 = root^2 + root + 1/4.
    let beyond_half = number > root * root + root;
    root as u32 + u32::from(beyond_half)
}

fn square(number: u32) -> u64 {
    u64::from(number) * u64::from(number)
}
