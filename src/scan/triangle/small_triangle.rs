//! The triangle of three Bresenham lines and all between, no larger than a display: columns in fixed point, stepped by
//! one addition.
//!
//! Guarantees: the pixels of a filled [`triangle`](crate::scan::triangle::bresenham_triangle), which calls it.
//!
//! An edge has n rows below its upper vertex, m columns, and a step of m / n columns a row to the right or to the left.
//! From the pixels' rule (the nearest one on the minor axis, and of two that are equally near the one towards the upper
//! vertex) follows the column whose whole part is the pixel's. In row k of an edge from column x it is x + 1/2 and k steps,
//! where the edge is steep (m <= n). Where it is flat, its run of pixels begins (m / n - 1) / 2 columns further to the left,
//! and ends as many further to the right. A run that would reach beyond a vertex ends there. In the rows that are taken from
//! an edge, this is always a vertex with none further out on that side, so it is enough to cut the rows to the triangle's
//! box.
//!
//! These columns are multiples of 1 / 2n. Where the larger of m and n is odd, they are odd multiples: none is whole, and
//! an error below 1 / 2n changes no pixel. Where it is even, they are multiples of 1 / n. A whole one then is a tie. It
//! belongs to the pixel nearer to the upper vertex's column where the edge is steep, and to the one further away where it is
//! flat, because of two equally near rows the upper one is taken. On that side, an error above 0 and below 1 / n changes no
//! pixel.
//!
//! Step and half step are rounded to 1/2^20. Up to row n their error is at most (n + 1/2) / 2^21, which is below 1 / 2n for
//! n <= 1,023. Where there are ties, 1/2^11 is added on their side: with it, the error is above 0 and below 1 / n.

use core::num::NonZeroU32;

use embedded_graphics::geometry::Point;
use fixed::types::I12F20;

use crate::{
    geometry::{Window, distance},
    scan::triangle::vertex_order::from_top_to_bottom,
    surface::{StraightSide, Trapezoid, Trapezoids},
};

/// Rows below the top one, and columns beside the leftmost one, for which the columns are exact.
const MOST: u32 = 1_023;

/// One column in the number format of straight sides.
const ONE: i32 = 1 << I12F20::FRAC_NBITS;

/// How far a side is moved so that ties fall to one side: less than any distance from a side to a pixel that is no tie.
const NUDGE: i32 = ONE >> 11;

/// The visible rows of a triangle.
pub(crate) enum SmallTriangle {
    /// The triangle has no visible row.
    Nothing,
    /// All visible rows of the triangle.
    Rows(Trapezoids),
    /// The triangle is too large, or has one row only.
    Unfit,
}

/// The visible rows of a small triangle, as trapezoids.
///
/// Cost: one 32-bit division an edge.
// Inlined: the call, with its result in memory, takes as long as an edge.
#[inline(always)]
pub(crate) fn visible(vertices: &[Point; 3], window: &Window) -> SmallTriangle {
    let [top, middle, bottom] = from_top_to_bottom(*vertices);
    let leftmost = top.x.min(middle.x).min(bottom.x);
    let rightmost = top.x.max(middle.x).max(bottom.x);
    let first = Point::new(leftmost.max(window.left), top.y.max(window.top));
    // No window shows the last column or row that there is. Where it shows nothing at all, it ends before it begins.
    let end = Point::new(
        rightmost.saturating_add(1).min(window.right),
        bottom.y.saturating_add(1).min(window.bottom),
    );
    if first.y >= end.y || first.x >= end.x {
        return SmallTriangle::Nothing;
    }
    let width = distance(leftmost, rightmost);
    let height = distance(top.y, bottom.y);
    if width > MOST || height > MOST || height == 0 {
        return SmallTriangle::Unfit;
    }
    let parts = parts([top, middle, bottom], first, end.y);
    SmallTriangle::Rows(Trapezoids {
        row: distance(window.top, first.y),
        column: distance(window.left, first.x),
        columns: distance(first.x, end.x),
        parts,
    })
}

/// The two trapezoids of the rows from that of the first visible pixel up to `end_row`. Columns count from the first visible
/// pixel's.
#[inline(always)]
fn parts([top, middle, bottom]: [Point; 3], first: Point, end_row: i32) -> [Trapezoid; 2] {
    // Below 2^10 from here on: rows count from the top vertex.
    let (top_column, middle_column) = (top.x - first.x, middle.x - first.x);
    let (upper_columns, long_columns) = (middle.x - top.x, bottom.x - top.x);
    let (middle_row, height) = (middle.y - top.y, bottom.y - top.y);
    let short_is_left = long_columns * middle_row > upper_columns * height;
    let outwards: i32 = if short_is_left { -1 } else { 1 };
    let long = side(top_column, long_columns, height, -outwards);
    let upper = side(top_column, upper_columns, middle_row, outwards);
    let (lower_columns, lower_rows) = (long_columns - upper_columns, height - middle_row);
    let lower = side(middle_column, lower_columns, lower_rows, outwards);

    // Where the upper edge runs away from the long edge or straight down, it ends in the middle vertex, which is in the
    // lower edge's run too. Where it runs back, the lower edge does as well, and begins in the vertex.
    let upper_runs_back = upper_columns * outwards < 0;
    let lower_from = middle_row + i32::from(upper_runs_back);
    let row = first.y - top.y;
    let end = end_row - top.y;
    let lower_row = lower_from.max(row).min(end);
    let part = |rows: i32, long: StraightSide, short: StraightSide| {
        let (left, right) = if short_is_left { (short, long) } else { (long, short) };
        let rows = rows as u32;
        Trapezoid { rows, left, right }
    };
    [
        part(lower_row - row, long.after(row), upper.after(row)),
        part(
            end - lower_row,
            long.after(lower_row),
            lower.after(lower_row - middle_row),
        ),
    ]
}

/// The side of a trapezoid: where an edge's runs of pixels begin (`outwards` is -1) or end (it is 1), unless a vertex
/// cuts them off.
///
/// The edge runs from its upper vertex, in column `x`, over `columns` and `rows`. An edge of one row stands in that vertex: only a lower
/// one has rows in the triangle, on the left, and its vertices are sorted from left to right.
#[inline(always)]
fn side(x: i32, columns: i32, rows: i32, outwards: i32) -> StraightSide {
    let (width, rows) = (columns.unsigned_abs(), rows as u32);
    // The dividend is below 2^31.
    let step = NonZeroU32::new(rows).map_or(0, |rows| {
        (((width << I12F20::FRAC_NBITS) + (rows.get() >> 1)) / rows) as i32
    });
    let middle = (x << I12F20::FRAC_NBITS) + (ONE / 2);
    let (start, longest, ties_are_right) = if step <= ONE {
        (middle, rows, columns < 0)
    } else {
        let half_run = (step - ONE) >> 1;
        (middle + (half_run * outwards), width, columns >= 0)
    };
    let column = match (longest & 1 != 0, ties_are_right) {
        (true, _) => start,
        (false, true) => start + NUDGE,
        (false, false) => start - NUDGE,
    };
    StraightSide {
        column: I12F20::from_bits(column),
        step: I12F20::from_bits(if columns < 0 { -step } else { step }),
    }
}

#[cfg(test)]
mod tests {
    use super::{MOST, side};

    /// Where the run of pixels in row `k` begins or ends. Column j of a flat edge has the pixel in the row nearest to
    /// `j n / m`, row k of a steep one that in the column nearest to `k m / n`, halves to the upper vertex.
    fn run_end(columns: i32, rows: i32, outwards: i32, k: i32) -> i32 {
        let (m, n) = (columns.abs(), rows);
        // ceil(numerator / denominator - 1/2)
        let nearest = |numerator: i32, denominator: i32| -((denominator - 2 * numerator).div_euclid(2 * denominator));
        if m <= n {
            return columns.signum() * nearest(k * m, n);
        }
        // The last column whose row is at most k: j n / m <= k + 1/2.
        let last_until = |k: i32| ((2 * k + 1) * m).div_euclid(2 * n);
        if columns.signum() == outwards {
            columns.signum() * last_until(k)
        } else {
            columns.signum() * (last_until(k - 1) + 1)
        }
    }

    #[test]
    fn columns_are_exact_down_to_the_last_row() {
        let most = MOST as i32;
        for rows in 1..=most {
            for columns in -most..=most {
                for outwards in [-1, 1] {
                    let side = side(0, columns, rows, outwards);
                    for k in [0, rows / 2, rows - 1, rows] {
                        // What is beyond a vertex is cut off.
                        let cut = |column: i32| column.clamp(columns.min(0), columns.max(0));
                        let expected = run_end(columns, rows, outwards, k);
                        let found = side.after(k).pixel();
                        assert_eq!(cut(found), cut(expected), "row {k} of {columns} x {rows} to {outwards}");
                    }
                }
            }
        }
    }
}
