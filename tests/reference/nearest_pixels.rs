//! Bresenham's lines by their definition, in `i128`.

use std::collections::BTreeSet;

use embedded_graphics::{prelude::*, primitives::Rectangle};

/// `floor(numerator / denominator + 1/2)`, the nearest integer with ties upwards.
pub fn nearest(numerator: i128, denominator: i128) -> i128 {
    (2 * numerator + denominator).div_euclid(2 * denominator)
}

/// First and last pixel in row `y` of the line that is walked from `from`, ties towards it.
pub fn walked_run(from: Point, to: Point, y: i32) -> Option<(i128, i128)> {
    let nearest = |numerator: i128, denominator: i128| {
        // ceil(|numerator| / denominator - 1/2)
        let size = -(denominator - 2 * numerator.abs()).div_euclid(2 * denominator);
        numerator.signum() * size
    };
    let (x0, y0) = (i128::from(from.x), i128::from(from.y));
    let (dx, dy) = (i128::from(to.x) - x0, i128::from(to.y) - y0);
    let row = i128::from(y);
    if row < y0.min(y0 + dy) || row > y0.max(y0 + dy) {
        return None;
    }
    if dx.abs() < dy.abs() {
        let x = x0 + nearest((row - y0) * dx * dy.signum(), dy.abs());
        return Some((x, x));
    }
    if dy == 0 {
        return Some((x0.min(x0 + dx), x0.max(x0 + dx)));
    }
    // Columns whose nearest row is this one, found by bisection: the row is monotonous along the line.
    let row_at = |step: i128| y0 + nearest(step * dy, dx.abs());
    let column = |step: i128| x0 + step * dx.signum();
    let first_where = |reached: &dyn Fn(i128) -> bool| {
        let (mut low, mut high) = (0, dx.abs() + 1);
        while low < high {
            let middle = (low + high) / 2;
            if reached(row_at(middle)) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        low
    };
    let (first, end) = if dy > 0 {
        (first_where(&|at| at >= row), first_where(&|at| at > row))
    } else {
        (first_where(&|at| at <= row), first_where(&|at| at < row))
    };
    assert!(first < end);
    let ends = (column(first), column(end - 1));
    Some((ends.0.min(ends.1), ends.0.max(ends.1)))
}

/// Every pixel of the line inside the window, ties to the larger coordinate. The ends may be anywhere.
pub fn pixels((x0, y0): (i128, i128), (x1, y1): (i128, i128), window: Rectangle) -> BTreeSet<(i128, i128)> {
    let (dx, dy) = (x1 - x0, y1 - y0);
    let range = |range: core::ops::Range<i32>| i128::from(range.start)..i128::from(range.end);
    let (columns, rows) = (range(window.columns()), range(window.rows()));
    let between = |range: &core::ops::Range<i128>, from: i128, to: i128| {
        range.start.max(from.min(to))..range.end.min(from.max(to) + 1)
    };
    let mut pixels = BTreeSet::new();
    if dx == 0 && dy == 0 {
        pixels.insert((x0, y0));
    } else if dx.abs() >= dy.abs() {
        let exact = |x: i128| (x, y0 + nearest((x - x0) * dy * dx.signum(), dx.abs()));
        pixels.extend(between(&columns, x0, x1).map(exact));
    } else {
        let exact = |y: i128| (x0 + nearest((y - y0) * dx * dy.signum(), dy.abs()), y);
        pixels.extend(between(&rows, y0, y1).map(exact));
    }
    pixels.retain(|(x, y)| columns.contains(x) && rows.contains(y));
    pixels
}
