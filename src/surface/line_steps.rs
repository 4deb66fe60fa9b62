//! The pixels along a line, already clipped: a start, a count and an error term.

use embedded_graphics::geometry::Point;

use crate::geometry::Window;

/// A walk of one pixel a step along the major axis, top to bottom.
///
/// Rows never decrease along the walk. Every pixel of it lies inside the window it was clipped to. The error term makes
/// it exact: a clipped walk draws the pixels that the unclipped one would draw there.
///
/// Any numbers are a walk, those of no line too; targets draw it [up to its first pixel outside](Self::until_outside)
/// their window.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LineSteps {
    /// First pixel.
    pub start: Point,
    /// Pixels in the walk; at least 1 where it was clipped to a window.
    pub count: u32,
    /// Whether each step moves along x (and some along y); otherwise each moves along y.
    pub x_major: bool,
    /// Whether x decreases along the walk.
    pub leftwards: bool,
    /// Error term at `start`, less than `major_delta` (0 where that is 0).
    pub error: u32,
    /// Length of the line on its minor axis, at most `major_delta`.
    pub minor_delta: u32,
    /// Length of the line on its major axis.
    pub major_delta: u32,
}

impl LineSteps {
    /// The error term counted downwards: a step takes `minor_delta` off it, and where that borrows, the step moves along
    /// the minor axis as well and `major_delta` comes back on.
    pub const fn until_minor_step(&self) -> u32 {
        self.major_delta.wrapping_sub(1).wrapping_sub(self.error)
    }

    /// The walk up to its first pixel outside a window; no pixel where it starts outside.
    ///
    /// Cost: some comparisons for a walk that stays inside, two products of 64 bits where its end is near the window's
    /// border; otherwise a step for each pixel that is kept.
    #[must_use]
    pub fn until_outside(self, window: &Window) -> Self {
        if self.stays_inside(window) {
            self
        } else {
            self.cut(window)
        }
    }

    fn stays_inside(&self, window: &Window) -> bool {
        let Some(steps) = self.count.checked_sub(1) else {
            return true;
        };
        if !window.contains(self.start) {
            return false;
        }
        let Point { x, y } = self.start;
        // Columns and rows that follow the first pixel's in the window, which has pixels: its ends minus 1 exist.
        let columns = x.abs_diff(if self.leftwards { window.left } else { window.right - 1 });
        let rows = y.abs_diff(window.bottom - 1);
        let (major, minor) = if self.x_major { (columns, rows) } else { (rows, columns) };
        steps <= major && (steps <= minor || self.sidesteps_at_most(minor, steps))
    }

    /// Whether so many steps of a line, after the first pixel, have no more minor-axis steps than that. `false` for numbers
    /// that are no line's.
    fn sidesteps_at_most(&self, most: u32, steps: u32) -> bool {
        if self.minor_delta > self.major_delta || self.error >= self.major_delta {
            return false;
        }
        if self.minor_delta <= most && steps <= self.major_delta {
            return true;
        }
        // All are below 2^32, so both sides are below 2^64.
        let [error, minor, major] = [self.error, self.minor_delta, self.major_delta].map(u64::from);
        error + u64::from(steps) * minor < (u64::from(most) + 1) * major
    }

    #[cold]
    #[inline(never)]
    fn cut(self, window: &Window) -> Self {
        let inside = self.into_iter().take_while(|&point| window.contains(point));
        // No more than `self.count`.
        let count = inside.count() as u32;
        Self { count, ..self }
    }
}

impl IntoIterator for LineSteps {
    type Item = Point;
    type IntoIter = LinePoints;

    fn into_iter(self) -> LinePoints {
        LinePoints {
            point: self.start,
            remaining: self.count,
            x_major: self.x_major,
            x_step: if self.leftwards { -1 } else { 1 },
            until_minor_step: self.until_minor_step(),
            minor_delta: self.minor_delta,
            major_delta: self.major_delta,
        }
    }
}

/// The pixels of [`LineSteps`], one by one.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinePoints {
    point: Point,
    remaining: u32,
    x_major: bool,
    x_step: i32,
    until_minor_step: u32,
    minor_delta: u32,
    major_delta: u32,
}

impl Iterator for LinePoints {
    type Item = Point;

    #[inline]
    fn next(&mut self) -> Option<Point> {
        self.remaining = self.remaining.checked_sub(1)?;
        let current = self.point;
        let (rest, steps_minor) = self.until_minor_step.overflowing_sub(self.minor_delta);
        self.until_minor_step = if steps_minor {
            rest.wrapping_add(self.major_delta)
        } else {
            rest
        };
        // The step after the last pixel is computed and not used: it may leave the number range.
        if self.x_major || steps_minor {
            self.point.x = current.x.wrapping_add(self.x_step);
        }
        if !self.x_major || steps_minor {
            self.point.y = current.y.wrapping_add(1);
        }
        Some(current)
    }
}
