//! Bresenham's line by runs: a whole run of pixels a step (run-length slicing, Bresenham 1985, "Run Length Slice
//! Algorithm for Incremental Lines"; Stephenson and Litow 2000, "Why Step When You Can Run?", IEEE Computer Graphics and
//! Applications 20(6)).
//!
//! Guarantees: the pixels of [`Lines::bresenham`](crate::scan::Lines::bresenham), for any `i32` end points in either order, clipped or not.
//! Between the first run and the last all runs have one of two lengths that differ by 1: the quotient of the deltas, or one
//! more where the remainders add up to another pixel.
//!
//! Cost: set-up as for the steps, and two divisions; then a comparison and two sums for a run, however long.
//!
//! Take it when runs are long and filling them is cheap: on displays that take a run as one window, in run-length files. A
//! [`Band`](crate::band::Band) does so by itself: `Line`s and `Polyline`s are stepped, which is the default, except those
//! with eight pixels a run and more, which are filled by runs (slope 1/16: 710 instructions on a Cortex-M4 instead of 1,780;
//! slopes of all directions, by runs alone: 5,200 instead of 1,250).

use core::fmt::Debug;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::{Window, coordinate_after, coordinate_before},
    scan::line::{bresenham::line_steps, lines::Lines},
    surface::{LineSteps, Span},
};

impl Lines {
    /// The visible pixels of the line between two pixels, both included, a run at a time and each run by growing coordinates.
    ///
    /// The pixels are [`Lines::bresenham`](crate::scan::Lines::bresenham)'s; in a run of a line that goes to the left they come in the
    /// other order.
    ///
    /// Cost: one division for each end that is cut, two to set the runs up; a comparison and two sums a run. Source: Bresenham
    /// 1985; Stephenson and Litow 2000.
    pub fn bresenham_runs(
        start: Point,
        end: Point,
        window: &Window,
    ) -> impl Iterator<Item = Point> + Clone + Debug + use<> {
        let line = line_steps(start, end, window).map(LineRuns::from);
        line.map(LineRuns::into_iter).unwrap_or_default()
    }
}

impl Lines {
    /// The visible runs of the line between two pixels, both included, from top to bottom. Each is a window of one row, or of
    /// one column where the line is higher than wide, and has at least one pixel.
    ///
    /// Cost: that of [`bresenham_runs`](Self::bresenham_runs).
    ///
    /// ```
    /// use embedded_graphics::{image::GetPixel, pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::{band::{Band, Target}, scan::Lines};
    ///
    /// let mut words = [0u16; 64 * 8];
    /// let mut band = Band::<Rgb565>::new(Rectangle::new(Point::zero(), Size::new(64, 8)), &mut words)?;
    /// let raw = band.raw(Rgb565::WHITE);
    /// for run in Lines::runs(Point::new(-9, 0), Point::new(99, 7), &band.window()) {
    ///     let Ok(()) = band.fill_window(run, raw);
    /// }
    /// assert_eq!(band.pixel(Point::new(63, 5)), Some(Rgb565::WHITE));
    /// # Ok::<(), zrow::geometry::TooSmall>(())
    /// ```
    pub fn runs(start: Point, end: Point, window: &Window) -> impl Iterator<Item = Window> + Clone + Debug + use<> {
        let line = line_steps(start, end, window).map(LineRuns::from);
        line.as_ref().map(LineRuns::runs).unwrap_or_default()
    }
}

/// A line that is walked run by run, or pixel by pixel.
#[derive(Debug, Copy, Clone)]
pub(crate) struct LineRuns(LineSteps);

impl From<LineSteps> for LineRuns {
    fn from(steps: LineSteps) -> Self {
        Self(steps)
    }
}

impl LineRuns {
    /// The runs from top to bottom.
    pub fn runs(&self) -> Runs {
        Runs::new(&self.0)
    }
}

impl IntoIterator for LineRuns {
    type Item = Point;
    type IntoIter = RunPoints;

    fn into_iter(self) -> RunPoints {
        RunPoints {
            runs: self.runs(),
            point: self.0.start,
            remaining: 0,
            in_rows: self.0.x_major,
        }
    }
}

/// The runs of a line, from top to bottom: windows of one row, or of one column of a line that is higher than wide.
#[derive(Debug, Clone, Default)]
pub(crate) struct Runs {
    /// Where the next run begins.
    start: Point,
    /// Pixels of the line that are still to come.
    remaining: u32,
    x_major: bool,
    leftwards: bool,
    /// The next run's length, if the line does not end before.
    length: u32,
    /// The shorter of the two lengths.
    shorter: u32,
    /// The remainder before the next run, and what each run adds to it: both below the minor delta.
    rest: u32,
    increment: u32,
    minor_delta: u32,
}

impl Runs {
    fn new(steps: &LineSteps) -> Self {
        let (major_delta, minor_delta) = (steps.major_delta, steps.minor_delta);
        let until_minor_step = steps.until_minor_step();
        let divided = |number: u32| Some((number.checked_div(minor_delta)?, number.checked_rem(minor_delta)?));
        // A line that never steps aside is one run, whatever its length.
        let (before, rest) = divided(until_minor_step).unwrap_or((u32::MAX, 0));
        let (shorter, increment) = divided(major_delta).unwrap_or((u32::MAX, 0));
        Self {
            start: steps.start,
            remaining: steps.count,
            x_major: steps.x_major,
            leftwards: steps.leftwards,
            length: before.saturating_add(1),
            shorter,
            rest,
            increment,
            minor_delta,
        }
    }

    /// The length of the run after this one: as many steps as the major delta has minor deltas, with what was left.
    fn advance(&mut self) {
        let until_longer = self.minor_delta - self.increment;
        if self.rest >= until_longer {
            self.rest -= until_longer;
            // Begins again at 0 after a line that is a single run, which has no next one.
            self.length = self.shorter.wrapping_add(1);
        } else {
            self.rest += self.increment;
            self.length = self.shorter;
        }
    }

    /// The next run of a line that is at least as wide as high: a loop over these need not ask whether it is a column.
    #[inline]
    pub fn next_row(&mut self) -> Option<Span> {
        let length = self.next_length()?;
        Some(self.take_row(length))
    }

    /// The next run's length, and chooses that of the run after it; `None` after the last one.
    #[inline]
    fn next_length(&mut self) -> Option<u32> {
        if self.remaining == 0 {
            return None;
        }
        let length = self.length.min(self.remaining);
        self.remaining -= length;
        self.advance();
        Some(length)
    }

    /// The next run of a line that is at least as wide as high, and moves on to the row below.
    // What is in the window has coordinates, and so has what comes after it, but what comes before its first column may have
    // none: after the last run it is not used.
    #[inline]
    fn take_row(&mut self, length: u32) -> Span {
        let Point { x, y } = self.start;
        let (span, next_x) = if self.leftwards {
            let first = coordinate_before(x, length - 1);
            (Span::new(y, first, x + 1), first.wrapping_sub(1))
        } else {
            let end = coordinate_after(x, length);
            (Span::new(y, x, end), end)
        };
        self.start = Point::new(next_x, y + 1);
        span
    }

    /// The next run of a line that is higher than wide, and moves on to the column beside it.
    #[inline]
    fn take_column(&mut self, length: u32) -> Window {
        let Point { x, y } = self.start;
        let bottom = coordinate_after(y, length);
        self.start = Point::new(x.wrapping_add(if self.leftwards { -1 } else { 1 }), bottom);
        Window {
            left: x,
            top: y,
            right: x + 1,
            bottom,
        }
    }
}

impl Iterator for Runs {
    type Item = Window;

    #[inline]
    fn next(&mut self) -> Option<Window> {
        let length = self.next_length()?;
        if !self.x_major {
            return Some(self.take_column(length));
        }
        let Span { y, start, end } = self.take_row(length);
        Some(Window {
            left: start,
            top: y,
            right: end,
            bottom: y + 1,
        })
    }
}

/// The pixels of a line, run by run, each by growing coordinates.
#[derive(Debug, Clone, Default)]
pub(crate) struct RunPoints {
    runs: Runs,
    /// The next pixel of the run, if it has any left.
    point: Point,
    remaining: u32,
    in_rows: bool,
}

impl Iterator for RunPoints {
    type Item = Point;

    #[inline]
    fn next(&mut self) -> Option<Point> {
        if self.remaining == 0 {
            let length = self.runs.next_length()?;
            self.point = if self.in_rows {
                let Span { y, start, .. } = self.runs.take_row(length);
                Point::new(start, y)
            } else {
                let Window { left, top, .. } = self.runs.take_column(length);
                Point::new(left, top)
            };
            self.remaining = length;
        }
        self.remaining -= 1;
        let current = self.point;
        if self.in_rows {
            self.point.x = current.x + 1;
        } else {
            self.point.y = current.y + 1;
        }
        Some(current)
    }
}
