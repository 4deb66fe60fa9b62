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

use core::num::NonZeroU32;

use embedded_graphics::geometry::Point;
use fixed::types::I12F20;

use crate::{
    geometry::Window,
    target::{StraightSide, Trapezoid},
};

/// Rows, and columns to either side of the window's first one, for which the columns are exact.
const MOST: u32 = 1_023;

/// Whether a triangle is small enough. Its vertices come from top to bottom.
#[inline(always)]
pub(super) fn is_small([top, middle, bottom]: &[Point; 3], window: &Window) -> bool {
    let is_near = |vertex: &Point| window.left.abs_diff(vertex.x) <= MOST;
    top.y.abs_diff(bottom.y) <= MOST && is_near(top) && is_near(middle) && is_near(bottom)
}

/// The visible rows, `first` to `last`, in two parts from top to bottom; a part may have no rows. The vertices come from
/// top to bottom.
///
/// Cost: two 32-bit divisions an edge.
#[inline]
pub(super) fn trapezoids(vertices: &[Point; 3], window: &Window, (first, last): (i32, i32)) -> [Trapezoid; 2] {
    // Below 2^11 from here on: rows count from the top vertex, columns from the window's first one.
    let origin = Point::new(window.left, vertices[0].y);
    let [top, middle, bottom] =
        vertices.map(|vertex| Point::new(vertex.x.wrapping_sub(origin.x), vertex.y.wrapping_sub(origin.y)));
    let middle_is_left =
        bottom.x.wrapping_sub(top.x).wrapping_mul(middle.y) > middle.x.wrapping_sub(top.x).wrapping_mul(bottom.y);
    // The window is not empty. One whose width takes all 32 bits has no last column near enough to count.
    let last_column = window.right.wrapping_sub(1).saturating_sub(window.left);

    let end = last.wrapping_sub(origin.y).wrapping_add(1);
    let row = first.wrapping_sub(origin.y);
    let lower_from = first_row_of_lower(&top, &middle, middle_is_left);
    let long = Edge::new(top, bottom, !middle_is_left);
    let part = |short: Edge, row: i32, end: i32| {
        let (left, right) = if middle_is_left {
            (&short, &long)
        } else {
            (&long, &short)
        };
        Trapezoid {
            row: row.wrapping_add(origin.y).wrapping_sub(window.top) as u32,
            rows: end.wrapping_sub(row).max(0) as u32,
            left: left.side(row),
            right: right.side(row),
            first: left.limit.max(0),
            last: right.limit.min(last_column),
        }
    };
    [
        part(Edge::new(top, middle, middle_is_left), row, lower_from.min(end)),
        part(Edge::new(middle, bottom, middle_is_left), lower_from.max(row), end),
    ]
}

/// The row of the middle vertex where the lower edge reaches at least as far out there as the upper one, else the next.
///
/// Where the upper edge runs away from the long edge, it ends in the vertex, which is in the lower edge's run too. Where
/// it does not, the lower edge cannot run away from the long edge either, and begins in the vertex.
#[inline(always)]
fn first_row_of_lower(top: &Point, middle: &Point, middle_is_left: bool) -> i32 {
    let upper_runs_away = if middle_is_left {
        middle.x < top.x
    } else {
        middle.x > top.x
    };
    // An upper edge of one row is in the lower one's, but for the top vertex, where the long edge begins.
    let lower_reaches_as_far = upper_runs_away || middle.y == 0;
    middle.y.wrapping_add(i32::from(!lower_reaches_as_far))
}

/// One end of the runs of pixels of an edge.
struct Edge {
    /// In row 0 of the triangle, in 1/2^20. Wraps, where the edge begins below it.
    column: i32,
    step: i32,
    /// How far it reaches: with the vertices the runs end, too.
    limit: i32,
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
        let limit = if is_left_end { first } else { last };
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
        let Some(divisor) = NonZeroU32::new(rows as u32) else {
            // In one row: the end itself.
            return Self {
                column: limit << I12F20::FRAC_NBITS,
                step: 0,
                limit,
            };
        };
        // All below 2^31, and rounded up, which is how a division rounds a negative number.
        let ceil_divide = |dividend: u32| dividend.wrapping_add(rows as u32).wrapping_sub(1) / divisor;
        let step = ceil_divide((columns as u32) << I12F20::FRAC_NBITS) as i32;
        let raised = bias.unsigned_abs() << I12F20::FRAC_NBITS;
        let offset = if bias > 0 {
            ceil_divide(raised) as i32
        } else {
            ((raised / divisor) as i32).wrapping_neg()
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
            limit,
        }
    }

    /// From a row on.
    #[inline(always)]
    fn side(&self, row: i32) -> StraightSide {
        StraightSide {
            column: I12F20::from_bits(self.column.wrapping_add(self.step.wrapping_mul(row))),
            step: I12F20::from_bits(self.step),
        }
    }
}
