//! Bresenham's line (1965), entered at the edge of the window with an exact error term (Kuzmin 1995).
//!
//! Promises: the pixel nearest to the exact line in each step of the major axis, **ties towards the larger
//! coordinate** (`floor(exact + 1/2)`), so that the order of the end points does not matter; a clipped line has exactly
//! the pixels that the whole line has inside the window; any `i32` end points.

use embedded_graphics::geometry::Point;

use crate::{clip::Outcode, geometry::Window, target::LineSteps};

/// The visible steps of the line between two pixels, both included; `None` where no pixel of it is in the window.
///
/// Cost: one division for each end that is cut (32-bit where the products fit), none for a line that is wholly inside.
pub fn line(from: Point, to: Point, window: &Window) -> Option<LineSteps> {
    if window.is_empty() {
        return None;
    }
    let (from_code, to_code) = (Outcode::of(from, window), Outcode::of(to, window));
    if !from_code.shared(to_code).is_inside() {
        return None;
    }
    let line = Line::new(from, to);
    if from_code.either(to_code).is_inside() {
        return Some(line.steps_between(0, line.major_delta, 0));
    }
    line.clipped(window)
}

/// The visible steps of a line that lies `offset` away from these two pixels; the moved pixels may be beyond `i32`.
///
/// Cost: that of [`line()`].
pub fn moved_line(from: Point, to: Point, offset: Point, window: &Window) -> Option<LineSteps> {
    let moved = |point: Point| {
        Some(Point::new(
            point.x.checked_add(offset.x)?,
            point.y.checked_add(offset.y)?,
        ))
    };
    if let (Some(from), Some(to)) = (moved(from), moved(to)) {
        return line(from, to, window);
    }
    if window.is_empty() {
        return None;
    }
    let mut line = Line::new(from, to);
    line.start_x += i64::from(offset.x);
    line.start_y += i64::from(offset.y);
    line.clipped(window)
}

/// A line from top to bottom, in distances along its major and minor axis.
struct Line {
    /// Wider than a pixel's coordinates, for a line that is moved beyond them.
    start_x: i64,
    start_y: i64,
    x_major: bool,
    leftwards: bool,
    major_delta: u32,
    minor_delta: u32,
    /// Error term at the first pixel: half the major delta, rounded so that ties go to the larger coordinate.
    start_error: u32,
}

impl Line {
    fn new(from: Point, to: Point) -> Self {
        let (start, end) = if from.y <= to.y { (from, to) } else { (to, from) };
        let (x_delta, y_delta) = (start.x.abs_diff(end.x), start.y.abs_diff(end.y));
        let leftwards = end.x < start.x;
        let x_major = x_delta >= y_delta;
        let (major_delta, minor_delta) = if x_major {
            (x_delta, y_delta)
        } else {
            (y_delta, x_delta)
        };
        // Downwards a tie takes the step; where the minor axis runs leftwards, the larger x is the one not stepped to.
        let tie_stays = !x_major && leftwards;
        let start_error = if tie_stays {
            major_delta.saturating_sub(1) >> 1
        } else {
            major_delta >> 1
        };
        Self {
            start_x: i64::from(start.x),
            start_y: i64::from(start.y),
            x_major,
            leftwards,
            major_delta,
            minor_delta,
            start_error,
        }
    }

    /// Steps `first..=last`; `minor_offset` is what has been stepped along the minor axis at `first`.
    fn steps_between(&self, first: u32, last: u32, minor_offset: u32) -> LineSteps {
        let (x_offset, y_offset) = if self.x_major {
            (first, minor_offset)
        } else {
            (minor_offset, first)
        };
        // What is in the window fits 32 bits again.
        let x = if self.leftwards {
            (self.start_x as i32).wrapping_sub_unsigned(x_offset)
        } else {
            (self.start_x as i32).wrapping_add_unsigned(x_offset)
        };
        // The error is less than the major delta, so the product's upper half cancels: 32 bits are enough.
        let error = first
            .wrapping_mul(self.minor_delta)
            .wrapping_add(self.start_error)
            .wrapping_sub(minor_offset.wrapping_mul(self.major_delta));
        LineSteps {
            start: Point::new(x, (self.start_y as i32).wrapping_add_unsigned(y_offset)),
            // Only a line over the whole number range has more steps than a `u32` counts; no window shows them all.
            count: last.wrapping_sub(first).saturating_add(1),
            x_major: self.x_major,
            leftwards: self.leftwards,
            error,
            minor_delta: self.minor_delta,
            major_delta: self.major_delta,
        }
    }

    /// The steps inside the window, in the numbers of the line: the outcodes did not decide.
    fn clipped(&self, window: &Window) -> Option<LineSteps> {
        let x_range = if self.leftwards {
            Distances::between(-self.start_x, 1 - i64::from(window.right), -i64::from(window.left))
        } else {
            Distances::between(self.start_x, i64::from(window.left), i64::from(window.right) - 1)
        }?;
        let y_range = Distances::between(self.start_y, i64::from(window.top), i64::from(window.bottom) - 1)?;
        let (major, minor) = if self.x_major {
            (x_range, y_range)
        } else {
            (y_range, x_range)
        };

        let first = major.first.max(self.first_step_at(minor.first)?);
        let last = major.last.min(self.major_delta).min(self.last_step_at(minor.last));
        if first > last {
            return None;
        }
        // On entry through the minor side the offset is known; through the major side it takes the division.
        let minor_offset = if first > major.first {
            minor.first
        } else {
            self.minor_offset(first)
        };
        Some(self.steps_between(first, last, minor_offset))
    }

    /// The first step with that offset on the minor axis; `None` where the line ends before it.
    fn first_step_at(&self, minor_offset: u32) -> Option<u32> {
        if minor_offset == 0 {
            return Some(0);
        }
        if minor_offset > self.minor_delta {
            return None;
        }
        // k * minor + error >= offset * major, at most major * major: fits u64.
        let target = u64::from(minor_offset) * u64::from(self.major_delta) - u64::from(self.start_error);
        Some(divide_ceil(target, self.minor_delta))
    }

    /// The last step with at most that offset on the minor axis.
    fn last_step_at(&self, minor_offset: u32) -> u32 {
        if minor_offset >= self.minor_delta {
            return self.major_delta;
        }
        let target = (u64::from(minor_offset) + 1) * u64::from(self.major_delta) - u64::from(self.start_error) - 1;
        divide(target, self.minor_delta)
    }

    fn minor_offset(&self, step: u32) -> u32 {
        if step == 0 {
            return 0;
        }
        let product = u64::from(step) * u64::from(self.minor_delta) + u64::from(self.start_error);
        divide(product, self.major_delta)
    }
}

/// How far along an axis the window begins and ends, seen from the start of the line.
struct Distances {
    first: u32,
    last: u32,
}

impl Distances {
    /// `None` where the window lies behind the start, or beyond the end of any line.
    fn between(start: i64, first: i64, last: i64) -> Option<Self> {
        let first = u32::try_from((first - start).max(0)).ok()?;
        let last = last - start;
        // No line has more steps than that.
        let last = last.min(i64::from(u32::MAX));
        (last >= 0).then_some(Self {
            first,
            last: last as u32,
        })
    }
}

/// Quotients here are steps of a line, so they fit `u32`; 32-bit division where the dividend does too.
fn divide(dividend: u64, divisor: u32) -> u32 {
    match u32::try_from(dividend) {
        Ok(dividend) => dividend.checked_div(divisor).unwrap_or(0),
        Err(_) => dividend.checked_div(u64::from(divisor)).unwrap_or(0) as u32,
    }
}

fn divide_ceil(dividend: u64, divisor: u32) -> u32 {
    divide(dividend.wrapping_add(u64::from(divisor)).wrapping_sub(1), divisor)
}
