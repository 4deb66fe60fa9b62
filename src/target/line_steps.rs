//! The pixels along a line, already clipped: a start, a count and an error term.

use embedded_graphics::geometry::Point;

/// A walk of one pixel a step along the major axis, top to bottom.
///
/// Rows never decrease along the walk. Every pixel of it lies inside the window it was clipped to. The error term makes
/// it exact: a clipped walk draws the pixels that the unclipped one would draw there.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LineSteps {
    /// First pixel.
    pub start: Point,
    /// Pixels in the walk, at least 1.
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
    /// Error from which on a step moves along the minor axis as well.
    pub const fn error_threshold(&self) -> u32 {
        self.major_delta.wrapping_sub(self.minor_delta)
    }
}

impl IntoIterator for LineSteps {
    type Item = Point;
    type IntoIter = LinePoints;

    fn into_iter(self) -> LinePoints {
        LinePoints {
            point: self.start,
            remaining: self.count,
            steps: self,
        }
    }
}

/// The pixels of [`LineSteps`], one by one.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinePoints {
    point: Point,
    remaining: u32,
    steps: LineSteps,
}

impl Iterator for LinePoints {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        self.remaining = self.remaining.checked_sub(1)?;
        let current = self.point;
        // The step after the last pixel is computed and not used: it may leave the number range.
        let x_step = if self.steps.leftwards { -1 } else { 1 };
        let threshold = self.steps.error_threshold();
        let minor_moves = self.steps.error >= threshold;
        self.steps.error = if minor_moves {
            self.steps.error.wrapping_sub(threshold)
        } else {
            self.steps.error.wrapping_add(self.steps.minor_delta)
        };
        if self.steps.x_major || minor_moves {
            self.point.x = current.x.wrapping_add(x_step);
        }
        if !self.steps.x_major || minor_moves {
            self.point.y = current.y.wrapping_add(1);
        }
        Some(current)
    }
}
