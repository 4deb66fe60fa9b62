//! The pixels along a line, already clipped: a start, a count and an error term.

use core::num::Wrapping;

use embedded_graphics::geometry::Point;

/// The pixels of a clipped line: one for each step along the major axis, top to bottom.
///
/// Rows never decrease along the walk. Every pixel of it lies inside the window it was clipped to. The error term makes
/// it exact: a clipped walk draws the pixels that the unclipped one would draw there.
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
    /// The error term counted downwards: each step subtracts `minor_delta`. Where that borrows, the step moves along
    /// the minor axis as well, and `major_delta` is added.
    pub const fn until_minor_step(&self) -> u32 {
        // A line of one pixel has no delta: it wraps, and takes no step.
        self.major_delta.wrapping_sub(1).wrapping_sub(self.error)
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

/// The pixels of [`LineSteps`], one by one; none by default.
#[derive(Debug, Clone, Default)]
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
            (Wrapping(rest) + Wrapping(self.major_delta)).0
        } else {
            rest
        };
        // The step after the last pixel is computed and not used: it may leave the number range.
        if self.x_major || steps_minor {
            self.point.x = (Wrapping(current.x) + Wrapping(self.x_step)).0;
        }
        if !self.x_major || steps_minor {
            self.point.y = (Wrapping(current.y) + Wrapping(1)).0;
        }
        Some(current)
    }
}
