//! The line by its equation `y = m x + b` in `f32`, the schoolbook way: the naive baseline of the siblings.
//!
//! Guarantees: any `i32` end points, in either order the same pixels; a clipped line has exactly the pixels that the whole
//! line has inside the window. While no coordinate is beyond 1,023, these are [`Lines::bresenham`](crate::scan::Lines::bresenham)'s
//! pixels except on exact ties, which fall to either side. There the result is wrong by less than 1/4,096 pixel (slope and
//! intercept are rounded, as are product and sum), and nearer to a tie than 1/4,092 pixel is only the tie itself. Further
//! out the error grows with the coordinates, and from 2^24 on single pixels have no number of their own.
//!
//! Cost: a division a line, a product, two sums and a rounding a pixel, in software where the core has no floats. The
//! steps that the window shows are found by bisection, up to 64 more pixels' worth.
//!
//! Take it when you want to see what the others save; not to draw.

use core::fmt::Debug;

use embedded_graphics::geometry::Point;
use micromath::F32Ext;

use crate::{
    geometry::{Window, coordinate_after, distance},
    scan::line::{kuzmin::OrderedLine, lines::Lines},
};

impl Lines {
    /// The visible pixels of the line between two pixels, both included, by the equation `y = m x + b` in `f32`.
    ///
    /// While no coordinate is beyond 1,023, the pixels are [`Lines::bresenham`](crate::scan::Lines::bresenham)'s except on exact ties;
    /// further out the error grows with the coordinates.
    ///
    /// Cost: a float division a line, a product, two sums and a rounding a pixel. Source: the schoolbook.
    pub fn slope_intercept(
        start: Point,
        end: Point,
        window: &Window,
    ) -> impl Iterator<Item = Point> + Clone + Debug + use<> {
        line(start, end, window).unwrap_or_default()
    }
}

/// The visible part of the line; `None` where no pixel of it is in the window.
fn line(from: Point, to: Point, window: &Window) -> Option<SlopeInterceptPoints> {
    // No outcodes: what drifts may be visible beside its end points.
    if window.is_empty() {
        return None;
    }
    let line = OrderedLine::new(from, to);
    let (columns, rows) = ((window.left, window.right), (window.top, window.bottom));
    let (major, minor, ends) = if line.x_major {
        (columns, rows, (from.x, to.x))
    } else {
        (rows, columns, (from.y, to.y))
    };
    let equation = Equation::of(&line);
    let first = ends.0.min(ends.1).max(major.0);
    // The last column or row of the window is below `i32::MAX`, so that the one after it is a number too.
    let end = ends.0.max(ends.1).min(major.1 - 1) + 1;
    let (next, end) = equation.where_within((first, end), minor);
    (next < end).then_some(SlopeInterceptPoints {
        equation,
        x_major: line.x_major,
        next,
        end,
    })
}

/// The minor coordinate as a function of the major one.
#[derive(Debug, Clone, Default)]
struct Equation {
    slope: f32,
    intercept: f32,
}

impl Equation {
    fn of(line: &OrderedLine) -> Self {
        let (start_x, start_y) = (line.start_x as f32, line.start_y as f32);
        let (major, minor) = if line.x_major {
            (start_x, start_y)
        } else {
            (start_y, start_x)
        };
        // A single pixel has no slope.
        let steepness = line.minor_delta as f32 / line.major_delta.max(1) as f32;
        let slope = if line.leftwards { -steepness } else { steepness };
        Self {
            slope,
            intercept: minor - slope * major,
        }
    }

    fn at(&self, major: i32) -> i32 {
        F32Ext::floor(self.slope * major as f32 + self.intercept + 0.5) as i32
    }

    /// The part of `first..end` where the minor coordinate is in `low..high`: rounding keeps the order of numbers, so the
    /// equation, rounded or not, never turns back.
    fn where_within(&self, (first, end): (i32, i32), (low, high): (i32, i32)) -> (i32, i32) {
        if self.slope >= 0.0 {
            let first = bisect(first, end, |major| self.at(major) >= low);
            (first, bisect(first, end, |major| self.at(major) >= high))
        } else {
            let first = bisect(first, end, |major| self.at(major) < high);
            (first, bisect(first, end, |major| self.at(major) < low))
        }
    }
}

/// Binary search: the first number of `first..end` for which `is_there` holds, where it holds for all after that; `end`
/// where it holds for none.
fn bisect(mut first: i32, mut end: i32, is_there: impl Fn(i32) -> bool) -> i32 {
    // Most lines need no search.
    if first >= end || is_there(first) {
        return first;
    }
    if !is_there(end - 1) {
        return end;
    }
    while first < end {
        let middle = coordinate_after(first, distance(first, end) / 2);
        if is_there(middle) {
            end = middle;
        } else {
            first = middle + 1;
        }
    }
    first
}

/// The pixels, by growing major coordinate.
#[derive(Debug, Clone, Default)]
struct SlopeInterceptPoints {
    equation: Equation,
    x_major: bool,
    next: i32,
    end: i32,
}

impl Iterator for SlopeInterceptPoints {
    type Item = Point;

    #[inline]
    fn next(&mut self) -> Option<Point> {
        if self.next >= self.end {
            return None;
        }
        let major = self.next;
        self.next = major + 1;
        let minor = self.equation.at(major);
        Some(if self.x_major {
            Point::new(major, minor)
        } else {
            Point::new(minor, major)
        })
    }
}
