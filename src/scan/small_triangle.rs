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
    scan::triangle::from_top_to_bottom,
    target::{StraightSide, Trapezoid},
};

/// Rows, and columns to either side of the window's first one, for which the columns are exact.
const MOST: u32 = 1_023;

/// One column.
const ONE: i32 = 1 << I12F20::FRAC_NBITS;

/// The visible rows of a triangle.
pub(super) enum Parts {
    /// There are none.
    None,
    /// In two parts from top to bottom; a part may have no rows.
    Two([Trapezoid; 2]),
    /// The triangle is too large, or has one row only.
    Unfit,
}

/// The visible rows. The window is not empty.
///
/// Cost: two 32-bit divisions an edge.
// A function of its own, so that a caller keeps its registers and holds one copy for all targets.
#[inline(never)]
pub(super) fn parts(vertices: &[Point; 3], window: &Window) -> Parts {
    let [top, middle, bottom] = from_top_to_bottom(*vertices);
    let leftmost = top.x.min(middle.x).min(bottom.x);
    let rightmost = top.x.max(middle.x).max(bottom.x);
    let first = top.y.max(window.top);
    let last = bottom.y.min(window.bottom.wrapping_sub(1));
    if first > last || leftmost >= window.right || rightmost < window.left {
        return Parts::None;
    }
    // Not left of the window.
    let right_end = rightmost.wrapping_sub(window.left) as u32;
    let below_top = bottom.y.abs_diff(top.y);
    if below_top.wrapping_sub(1) >= MOST || right_end > MOST || window.left.abs_diff(leftmost) > MOST {
        return Parts::Unfit;
    }
    // Below 2^11 from here on: rows count from the top vertex, columns from the window's first one.
    let column = |vertex: Point| vertex.x.wrapping_sub(window.left);
    let (top_x, middle_x, bottom_x) = (column(top), column(middle), column(bottom));
    let height = below_top as i32;
    let middle_row = middle.y.wrapping_sub(top.y);
    let middle_is_left =
        bottom_x.wrapping_sub(top_x).wrapping_mul(middle_row) > middle_x.wrapping_sub(top_x).wrapping_mul(height);
    // Where the upper edge runs away from the long edge, it ends in the middle vertex, which is in the lower edge's run
    // too. Where it does not, the lower edge cannot run away either, and begins in the vertex. An upper edge of one row is
    // in the lower one's, but for the top vertex, where the long edge begins.
    let upper_runs_away = if middle_is_left {
        middle_x < top_x
    } else {
        middle_x > top_x
    };
    let lower_from = if upper_runs_away || middle_row == 0 {
        middle_row
    } else {
        middle_row.wrapping_add(1)
    };
    let row = first.wrapping_sub(top.y);
    let end = last.wrapping_sub(top.y).wrapping_add(1);
    let upper_end = lower_from.min(end);
    let lower_row = lower_from.max(row);
    // The window is not empty. One whose width takes all 32 bits has no last column near enough to count.
    let last_column = window.right.wrapping_sub(1).saturating_sub(window.left);
    let window_row = top.y.wrapping_sub(window.top);

    let long = side(top_x, bottom_x, height, !middle_is_left);
    let (upper_long, lower_long) = (from_row(long, row), from_row(long, lower_row));
    let upper = from_row(side(top_x, middle_x, middle_row, middle_is_left), row);
    let lower = side(middle_x, bottom_x, height.wrapping_sub(middle_row), middle_is_left);
    let lower = from_row(lower, lower_row.wrapping_sub(middle_row));
    let part = |row: i32, end: i32, left: (i32, i32), right: (i32, i32), first: i32, last: i32| Trapezoid {
        row: row.wrapping_add(window_row) as u32,
        rows: end.wrapping_sub(row).max(0) as u32,
        left: straight_side(left),
        right: straight_side(right),
        first: first.max(0),
        last: last.min(last_column),
    };
    // The runs end with the vertices, too.
    let (long_first, long_last) = (top_x.min(bottom_x), top_x.max(bottom_x));
    Parts::Two(if middle_is_left {
        [
            part(row, upper_end, upper, upper_long, top_x.min(middle_x), long_last),
            part(lower_row, end, lower, lower_long, middle_x.min(bottom_x), long_last),
        ]
    } else {
        [
            part(row, upper_end, upper_long, upper, long_first, top_x.max(middle_x)),
            part(lower_row, end, lower_long, lower, long_first, middle_x.max(bottom_x)),
        ]
    })
}

/// One end of the runs of pixels of an edge: column in its first row and step, both in 1/2^20.
///
/// From the upper vertex, `rows` down to the other one. In one row only a near end is right, cut off at the vertex.
// One copy for the three edges, which has all it needs in registers.
#[inline(never)]
fn side(top: i32, bottom: i32, rows: i32, is_left_end: bool) -> (i32, i32) {
    let is_leftwards = bottom < top;
    let columns = top.abs_diff(bottom);
    let divisor = NonZeroU32::new(rows as u32).unwrap_or(NonZeroU32::MIN);
    let rows = divisor.get();
    // All dividends are below 2^31, and rounded up.
    let round = rows.wrapping_sub(1);
    let step = ((columns << I12F20::FRAC_NBITS).wrapping_add(round) / divisor) as i32;
    // The end of a run that is nearer to the upper vertex, of an edge that is not steep.
    let offset = if columns >= rows && is_leftwards != is_left_end {
        // ceil((k - 1/2) m / n) is floor of that with n - 1 more, and one column further than row k - 1. The bias
        // n - 1 - floor(m / 2) is what is short of n, rounded down.
        let short = (columns >> 1).wrapping_add(1) << I12F20::FRAC_NBITS;
        ONE.wrapping_sub((short / divisor) as i32)
    } else {
        let bias = if columns < rows {
            rows.wrapping_sub(u32::from(is_leftwards))
        } else {
            columns.wrapping_sub(1)
        };
        (((bias >> 1) << I12F20::FRAC_NBITS).wrapping_add(round) / divisor) as i32
    };
    let top = top << I12F20::FRAC_NBITS;
    if is_leftwards {
        // Columns are counted from the left: away from the vertex they are rounded up.
        (top.wrapping_add(ONE - 1).wrapping_sub(offset), step.wrapping_neg())
    } else {
        (top.wrapping_add(offset), step)
    }
}

/// From a row of the edge on.
#[inline(always)]
fn from_row((column, step): (i32, i32), row: i32) -> (i32, i32) {
    (column.wrapping_add(step.wrapping_mul(row)), step)
}

#[inline(always)]
fn straight_side((column, step): (i32, i32)) -> StraightSide {
    StraightSide {
        column: I12F20::from_bits(column),
        step: I12F20::from_bits(step),
    }
}
