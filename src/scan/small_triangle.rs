//! The triangle of three Bresenham lines and all between, no larger than a display: columns in fixed point, stepped by
//! one addition.
//!
//! Promises: the pixels of [`triangle`](crate::scan::triangle), which calls it.
//!
//! In row k of an edge of n rows and m columns, an end of the edge's run of pixels is `floor((k m + b) / n)` columns away
//! from its upper vertex, but never beyond a vertex. The bias b follows from the pixels' rule, `floor(exact + 1/2)` on the
//! minor axis. Column and step are rounded up to 1/2^20, so in row k their sum is at most (k + 1) / 2^20 too large. The
//! exact column is a multiple of 1/n, so it would take 1/n to reach another whole number, and n (n + 1) < 2^20 for
//! n <= 1,023: no column is wrong.

use embedded_graphics::geometry::Point;
use fixed::types::I12F20;

use crate::{
    geometry::Window,
    scan::triangle::Rows,
    target::{Span, StraightSide, Trapezoid},
};

/// Rows, and columns to either side of the window's first one, for which the columns are exact.
const MOST: u32 = 1_023;

/// Whether a triangle is small enough. Its vertices come from top to bottom.
#[inline(always)]
pub(super) fn is_small([top, middle, bottom]: &[Point; 3], window: &Window) -> bool {
    let is_near = |vertex: &Point| window.left.abs_diff(vertex.x) <= MOST;
    top.y.abs_diff(bottom.y) <= MOST && is_near(top) && is_near(middle) && is_near(bottom)
}

/// Hands over the visible rows, `first` to `last`, top to bottom. The vertices come from top to bottom.
///
/// Cost: two 32-bit divisions an edge.
///
/// # Errors
/// The first of `emit`.
pub(super) fn fill<E>(
    vertices: &[Point; 3],
    window: &Window,
    (first, last): (i32, i32),
    mut emit: impl FnMut(Rows) -> Result<(), E>,
) -> Result<(), E> {
    let triangle = SmallTriangle::new(vertices, window);
    let top = vertices[0].y;
    let end = last.wrapping_sub(top).wrapping_add(1);
    let mut row = first.wrapping_sub(top);
    while row < end {
        if row == 0 || row == triangle.middle || row == triangle.bottom {
            let (left, right) = triangle.columns(row);
            let x = |column: i32| column.wrapping_add(window.left);
            let span = Span::new(
                row.wrapping_add(top),
                x(left.max(0)),
                x(right.wrapping_add(1)).min(window.right),
            );
            if !span.is_empty() {
                emit(Rows::One(span))?;
            }
            row = row.wrapping_add(1);
        } else {
            let (left, right, sides_end) = triangle.sides(row);
            let next = sides_end.min(end);
            emit(Rows::Many(Trapezoid {
                row: row.wrapping_add(top).wrapping_sub(window.top) as u32,
                rows: next.wrapping_sub(row) as u32,
                left,
                right,
            }))?;
            row = next;
        }
    }
    Ok(())
}

/// Rows count from the top vertex, columns from the window's first one.
struct SmallTriangle {
    long: Edge,
    upper: Edge,
    lower: Edge,
    /// Row of the middle vertex.
    middle: i32,
    /// Row of the bottom vertex.
    bottom: i32,
    /// Whether the middle vertex is left of the long edge.
    middle_is_left: bool,
}

impl SmallTriangle {
    #[inline(always)]
    fn new(vertices: &[Point; 3], window: &Window) -> Self {
        let origin = Point::new(window.left, vertices[0].y);
        // Below 2^11 from here on.
        let [top, middle, bottom] =
            vertices.map(|vertex| Point::new(vertex.x.wrapping_sub(origin.x), vertex.y.wrapping_sub(origin.y)));
        let middle_is_left =
            bottom.x.wrapping_sub(top.x).wrapping_mul(middle.y) > middle.x.wrapping_sub(top.x).wrapping_mul(bottom.y);
        Self {
            long: Edge::new(top, bottom, !middle_is_left),
            upper: Edge::new(top, middle, middle_is_left),
            lower: Edge::new(middle, bottom, middle_is_left),
            middle: middle.y,
            bottom: bottom.y,
            middle_is_left,
        }
    }

    /// First and last column of a row.
    #[inline(always)]
    fn columns(&self, row: i32) -> (i32, i32) {
        let (upper, lower) = (self.upper.column(row), self.lower.column(row));
        let short = if row < self.middle {
            upper
        } else if row > self.middle {
            lower
        } else if self.middle_is_left {
            upper.min(lower)
        } else {
            upper.max(lower)
        };
        self.left_to_right(short, self.long.column(row))
    }

    /// Both sides from a row without a vertex on, and the next row with one.
    #[inline(always)]
    fn sides(&self, row: i32) -> (StraightSide, StraightSide, i32) {
        let (short, end) = if row < self.middle {
            (&self.upper, self.middle)
        } else {
            (&self.lower, self.bottom)
        };
        let (left, right) = self.left_to_right(short.side(row), self.long.side(row));
        (left, right, end)
    }

    fn left_to_right<T>(&self, short: T, long: T) -> (T, T) {
        if self.middle_is_left {
            (short, long)
        } else {
            (long, short)
        }
    }
}

/// One end of the runs of pixels of an edge.
struct Edge {
    /// In row 0 of the triangle, in 1/2^20. Wraps, where the edge begins below it.
    column: i32,
    step: i32,
    /// Columns of the edge.
    first: i32,
    last: i32,
}

impl Edge {
    #[inline]
    fn new(top: Point, bottom: Point, is_left_end: bool) -> Self {
        let is_leftwards = bottom.x < top.x;
        let (first, last) = if is_leftwards {
            (bottom.x, top.x)
        } else {
            (top.x, bottom.x)
        };
        let columns = last.wrapping_sub(first);
        let rows = bottom.y.wrapping_sub(top.y);
        // The end of a run that is nearer to the upper vertex.
        let is_near = is_leftwards != is_left_end;
        let bias = if columns < rows {
            rows.wrapping_sub(i32::from(is_leftwards)) >> 1
        } else if is_near {
            // ceil((k - 1/2) m / n) is floor of that with n - 1 more, and one column further than row k - 1.
            rows.wrapping_sub(1).wrapping_sub(columns >> 1)
        } else {
            columns.wrapping_sub(1) >> 1
        };
        // Below 2^31. Rounded up, which is how a division rounds a negative number.
        let raised = bias << I12F20::FRAC_NBITS;
        let raised = if raised > 0 {
            raised.wrapping_add(rows).wrapping_sub(1)
        } else {
            raised
        };
        let (Some(offset), Some(step)) = (
            raised.checked_div(rows),
            (columns << I12F20::FRAC_NBITS)
                .wrapping_add(rows)
                .wrapping_sub(1)
                .checked_div(rows),
        ) else {
            // In one row: the end itself.
            let end = if is_left_end { first } else { last };
            return Self {
                column: end << I12F20::FRAC_NBITS,
                step: 0,
                first: end,
                last: end,
            };
        };
        let top_column = top.x << I12F20::FRAC_NBITS;
        let (column, step) = if is_leftwards {
            // Columns are counted from the left: away from the vertex they are rounded up.
            let ceiling = (1 << I12F20::FRAC_NBITS) - 1;
            (
                top_column.wrapping_add(ceiling).wrapping_sub(offset),
                step.wrapping_neg(),
            )
        } else {
            (top_column.wrapping_add(offset), step)
        };
        Self {
            column: column.wrapping_sub(step.wrapping_mul(top.y)),
            step,
            first,
            last,
        }
    }

    /// The end of the run in a row of the edge.
    #[inline(always)]
    fn column(&self, row: i32) -> i32 {
        (self.at(row) >> I12F20::FRAC_NBITS).max(self.first).min(self.last)
    }

    /// From a row between the vertices on.
    #[inline(always)]
    fn side(&self, row: i32) -> StraightSide {
        StraightSide {
            column: I12F20::from_bits(self.at(row)),
            step: I12F20::from_bits(self.step),
        }
    }

    #[inline(always)]
    fn at(&self, row: i32) -> i32 {
        self.column.wrapping_add(self.step.wrapping_mul(row))
    }
}
