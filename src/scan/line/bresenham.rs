//! Bresenham's line (1965), entered at the edge of the window with an exact error term (Kuzmin 1995).
//!
//! Guarantees: the pixel nearest to the exact line in each step of the major axis, **ties towards the larger
//! coordinate** (`floor(exact + 1/2)`), so that the order of the end points does not matter; a clipped line has exactly
//! the pixels that the whole line has inside the window; any `i32` end points.
//!
//! The default: the fewest instructions a pixel of all siblings that are as exact
//! ([`Lines::bresenham_runs`](crate::scan::Lines::bresenham_runs), [`Lines::midpoint`](crate::scan::Lines::midpoint)), but for lines with
//! long runs.

use core::fmt::Debug;

use embedded_graphics::geometry::Point;

use crate::{
    clip::Outcode,
    geometry::Window,
    scan::line::{
        kuzmin::{OrderedLine, Slope, VisibleSteps},
        lines::Lines,
    },
    surface::LineSteps,
};

impl Lines {
    /// The visible pixels of the line between two pixels, both included, by an error term: the default.
    ///
    /// In each step of the major axis the pixel nearest to the exact line, ties towards the larger coordinate.
    ///
    /// Cost: one division for each end that is cut (32-bit where the products fit), none for a line that is wholly inside; a
    /// subtraction and a comparison a pixel. Source: Bresenham 1965; the entry at the window's edge: Kuzmin 1995.
    ///
    /// ```
    /// use embedded_graphics::geometry::Point;
    /// use zrow::{geometry::Window, scan::Lines};
    ///
    /// let window = Window { left: 0, top: 0, right: 3, bottom: 9 };
    /// let pixels = Lines::bresenham(Point::new(0, 0), Point::new(8, 2), &window);
    /// assert!(pixels.eq([(0, 0), (1, 0), (2, 1)].map(|(x, y)| Point::new(x, y))));
    /// ```
    pub fn bresenham(start: Point, end: Point, window: &Window) -> impl Iterator<Item = Point> + Clone + Debug + use<> {
        line_steps(start, end, window)
            .map(LineSteps::into_iter)
            .unwrap_or_default()
    }
}

/// Whether a line is wholly above a window or below it, as most lines are that are not in a band.
// Inlined: otherwise a call takes more than the rows do.
#[inline(always)]
pub(crate) const fn is_beyond_rows(from: Point, to: Point, window: &Window) -> bool {
    (from.y < window.top && to.y < window.top) || (from.y >= window.bottom && to.y >= window.bottom)
}

/// The visible steps of the line between two pixels, both included; `None` where no pixel of it is in the window.
///
/// Cost: one division for each end that is cut (32-bit where the products fit), none for a line that is wholly inside.
#[inline]
pub(crate) fn line_steps(from: Point, to: Point, window: &Window) -> Option<LineSteps> {
    if is_beyond_rows(from, to, window) {
        None
    } else {
        steps_in_rows(from, to, window)
    }
}

/// The visible steps of a line that is not wholly above or below the window.
///
/// Cost: that of [`line_steps()`].
#[inline]
pub(crate) fn steps_in_rows(from: Point, to: Point, window: &Window) -> Option<LineSteps> {
    if window.is_empty() {
        return None;
    }
    let (from_code, to_code) = (Outcode::of(from, window), Outcode::of(to, window));
    if !from_code.shared(to_code).is_inside() {
        return None;
    }
    if !from_code.either(to_code).is_inside() {
        return clipped(&OrderedLine::new(from, to), window);
    }
    // Not the line that is clipped, which is in memory.
    let line = OrderedLine::new(from, to);
    let whole = VisibleSteps {
        first: 0,
        last: line.major_delta,
        minor_offset: 0,
    };
    Some(steps(&line, &line.nearest(), &whole))
}

/// The visible steps of a line that lies `offset` away from these two pixels; the moved pixels may be beyond `i32`.
///
/// Cost: that of [`line_steps()`].
pub(crate) fn moved_line_steps(from: Point, to: Point, offset: Point, window: &Window) -> Option<LineSteps> {
    let moved = |point: Point| {
        Some(Point::new(
            point.x.checked_add(offset.x)?,
            point.y.checked_add(offset.y)?,
        ))
    };
    if let (Some(from), Some(to)) = (moved(from), moved(to)) {
        return line_steps(from, to, window);
    }
    if window.is_empty() {
        return None;
    }
    let mut line = OrderedLine::new(from, to);
    line.start_x += i64::from(offset.x);
    line.start_y += i64::from(offset.y);
    clipped(&line, window)
}

/// The steps inside the window: the outcodes did not decide.
// Not inlined: what it needs is not on the stack of a caller that draws several shapes.
#[inline(never)]
fn clipped(line: &OrderedLine, window: &Window) -> Option<LineSteps> {
    let slope = line.nearest();
    let visible = line.visible(&slope, window)?;
    Some(steps(line, &slope, &visible))
}

/// The visible part of a line as the band takes it: its first pixel, and the error term from there on.
fn steps(line: &OrderedLine, slope: &Slope, visible: &VisibleSteps) -> LineSteps {
    LineSteps {
        start: line.pixel(visible.first, visible.minor_offset),
        count: visible.count(),
        x_major: line.x_major,
        leftwards: line.leftwards,
        error: slope.error(visible),
        minor_delta: line.minor_delta,
        major_delta: line.major_delta,
    }
}
