//! Kuzmin's line clipping (1995, "An Efficient Algorithm for Clipping of 2D Lines by Edges of the Window", Computer
//! Graphics Forum 14(5)): which steps of a line a window shows, in the numbers of the whole line.
//!
//! Guarantees: the steps whose pixels are inside, no more and no less, for any `i32` end points; one division for each end
//! that is cut (32-bit where the products fit). The window is not cut out of the line: a walk enters with the offset and
//! the error term that it would have there anyway. Every line that is walked along its longer axis enters this way.

use core::num::{NonZeroU32, Wrapping};

use embedded_graphics::geometry::Point;

use crate::{
    clip::Outcode,
    geometry::{Window, quotient_down, quotient_up},
};

/// A line from top to bottom, in distances along its major and minor axis.
#[derive(Debug, Copy, Clone)]
pub(crate) struct OrderedLine {
    /// Column of the start. Wider than a pixel's coordinates, for a line that is moved beyond them.
    pub start_x: i64,
    pub start_y: i64,
    pub x_major: bool,
    pub leftwards: bool,
    pub major_delta: u32,
    pub minor_delta: u32,
}

impl OrderedLine {
    pub fn new(from: Point, to: Point) -> Self {
        let (start, end) = if from.y <= to.y { (from, to) } else { (to, from) };
        let (x_delta, y_delta) = (start.x.abs_diff(end.x), start.y.abs_diff(end.y));
        let x_major = x_delta >= y_delta;
        let (major_delta, minor_delta) = if x_major {
            (x_delta, y_delta)
        } else {
            (y_delta, x_delta)
        };
        Self {
            start_x: i64::from(start.x),
            start_y: i64::from(start.y),
            x_major,
            leftwards: end.x < start.x,
            major_delta,
            minor_delta,
        }
    }

    /// Whether a tie takes no step along the minor axis.
    ///
    /// Ties go to the larger coordinate: where the minor axis runs leftwards, the step would lead to the smaller x.
    pub fn tie_stays(&self) -> bool {
        !self.x_major && self.leftwards
    }

    /// The slope of the exact line: its offset is rounded to the nearest pixel, ties to the larger coordinate.
    pub fn nearest(&self) -> Slope {
        let start = if self.tie_stays() {
            self.major_delta.saturating_sub(1) >> 1
        } else {
            self.major_delta >> 1
        };
        Slope {
            rise: self.minor_delta,
            run: self.major_delta,
            start,
            steps: self.major_delta,
            end_offset: self.minor_delta,
        }
    }

    /// The pixel of a step and an offset along the minor axis. What is in the window fits 32 bits again.
    pub fn pixel(&self, step: u32, minor_offset: u32) -> Point {
        let (x_offset, y_offset) = if self.x_major {
            (step, minor_offset)
        } else {
            (minor_offset, step)
        };
        let x = if self.leftwards {
            (self.start_x as i32).wrapping_sub_unsigned(x_offset)
        } else {
            (self.start_x as i32).wrapping_add_unsigned(x_offset)
        };
        Point::new(x, (self.start_y as i32).wrapping_add_unsigned(y_offset))
    }

    /// The steps inside a window that is not empty.
    pub fn visible(&self, slope: &Slope, window: &Window) -> Option<VisibleSteps> {
        let x = Distances::between(self.start_x, self.leftwards, window.left, window.right)?;
        let y = Distances::between(self.start_y, false, window.top, window.bottom)?;
        let (major, minor) = if self.x_major { (x, y) } else { (y, x) };
        slope.visible(major, minor)
    }
}

/// Whether the outcodes alone say that nothing between two pixels is in the window.
pub(crate) fn is_outside(from: Point, to: Point, window: &Window) -> bool {
    window.is_empty() || !Outcode::of(from, window).shared(Outcode::of(to, window)).is_inside()
}

/// How far along the minor axis each step is: `floor((step * rise + start) / run)`, at most a pixel a step.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Slope {
    /// Length of the line on its minor axis, at most `run`.
    pub rise: u32,
    /// Length of the line on its major axis.
    pub run: u32,
    /// Error term at step 0, less than `run`, or 0 where that is 0.
    pub start: u32,
    /// Number of the last step.
    pub steps: u32,
    /// Offset of the last step along the minor axis.
    pub end_offset: u32,
}

/// The visible steps `first..=last` of a line; `minor_offset` is the offset of the first.
#[derive(Debug, Copy, Clone)]
pub(crate) struct VisibleSteps {
    pub first: u32,
    pub last: u32,
    pub minor_offset: u32,
}

impl VisibleSteps {
    /// How many steps are visible. Only a line over the whole number range has more steps than a `u32` counts; no window
    /// shows them all.
    pub fn count(&self) -> u32 {
        (self.last - self.first).saturating_add(1)
    }
}

impl Slope {
    /// A slope that rises by `rise` units of 1/2^`fraction_bits` pixel a step, at most a pixel.
    pub fn in_units(rise: u32, fraction_bits: u32, start: u32, steps: u32) -> Self {
        let end = u64::from(steps) * u64::from(rise) + u64::from(start);
        Self {
            rise,
            run: 1 << fraction_bits,
            start,
            steps,
            // At most as many pixels as there are steps.
            end_offset: (end >> fraction_bits) as u32,
        }
    }

    fn visible(&self, major: Distances, minor: Distances) -> Option<VisibleSteps> {
        let first = major.first.max(self.first_step_at(minor.first)?);
        let last = major.last.min(self.steps).min(self.last_step_at(minor.last));
        if first > last {
            return None;
        }
        // On entry through the minor side the offset is known; through the major side it takes the division.
        let minor_offset = if first > major.first {
            minor.first
        } else {
            self.offset(first)
        };
        Some(VisibleSteps {
            first,
            last,
            minor_offset,
        })
    }

    /// The first step whose offset is `offset`; `None` where the line ends before it.
    pub fn first_step_at(&self, offset: u32) -> Option<u32> {
        if offset == 0 {
            return Some(0);
        }
        if offset > self.end_offset {
            return None;
        }
        // A level slope ends at offset 0.
        let rise = NonZeroU32::new(self.rise)?;
        // step * rise + start >= offset * run, at most (2^32 - 1)^2: fits u64.
        let target = u64::from(offset) * u64::from(self.run) - u64::from(self.start);
        Some(quotient_up(target, rise))
    }

    /// The last step whose offset is at most `offset`.
    pub fn last_step_at(&self, offset: u32) -> u32 {
        // A level slope has no larger offset.
        let (false, Some(rise)) = (offset >= self.end_offset, NonZeroU32::new(self.rise)) else {
            return self.steps;
        };
        let target = (u64::from(offset) + 1) * u64::from(self.run) - u64::from(self.start) - 1;
        quotient_down(target, rise)
    }

    pub fn offset(&self, step: u32) -> u32 {
        // A line of one pixel has no other step.
        let (1.., Some(run)) = (step, NonZeroU32::new(self.run)) else {
            return 0;
        };
        let product = u64::from(step) * u64::from(self.rise) + u64::from(self.start);
        quotient_down(product, run)
    }

    /// The error term of the first visible step, less than `run`: the product's upper half cancels, so 32 bits are
    /// enough.
    pub fn error(&self, visible: &VisibleSteps) -> u32 {
        let [first, rise, start] = [visible.first, self.rise, self.start].map(Wrapping);
        let [minor_offset, run] = [visible.minor_offset, self.run].map(Wrapping);
        (first * rise + start - minor_offset * run).0
    }
}

/// How far along an axis the window begins and ends, seen from the start of the line.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Distances {
    pub first: u32,
    pub last: u32,
}

impl Distances {
    /// Coordinates `first..end`, seen `backwards` where the line runs towards the smaller ones; `None` where they lie
    /// behind the start, or beyond the end of any line.
    pub fn between(start: i64, backwards: bool, first: i32, end: i32) -> Option<Self> {
        let (first, last) = if backwards {
            (start + 1 - i64::from(end), start - i64::from(first))
        } else {
            (i64::from(first) - start, i64::from(end) - 1 - start)
        };
        let first = u32::try_from(first.max(0)).ok()?;
        // No line has more steps than that. The window may end further away: a moved line may begin beyond `i32`.
        let last = last.min(i64::from(u32::MAX));
        (last >= 0).then_some(Self {
            first,
            last: last as u32,
        })
    }
}

/// The pixels of visible steps one by one; the caller decides which steps move along the minor axis.
#[derive(Debug, Clone, Default)]
pub(crate) struct LineWalk {
    point: Point,
    remaining: u32,
    x_major: bool,
    x_step: i32,
}

impl LineWalk {
    pub fn new(line: &OrderedLine, visible: &VisibleSteps) -> Self {
        Self {
            point: line.pixel(visible.first, visible.minor_offset),
            remaining: visible.count(),
            x_major: line.x_major,
            x_step: if line.leftwards { -1 } else { 1 },
        }
    }

    /// Returns the next pixel. `steps_minor` says whether the step after it moves along the minor axis too.
    #[inline]
    pub fn next(&mut self, steps_minor: impl FnOnce() -> bool) -> Option<Point> {
        self.remaining = self.remaining.checked_sub(1)?;
        let current = self.point;
        let steps_minor = steps_minor();
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

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;

    fn slope(rise: u32, run: u32, start: u32) -> Slope {
        Slope {
            rise,
            run,
            start,
            steps: run,
            end_offset: rise,
        }
    }

    /// All small slopes, level ones and those of one pixel included, against the offsets of all their steps.
    #[test]
    fn small_slopes_are_entered_where_they_lead() {
        for run in 0..20 {
            for (rise, start) in (0..=run).flat_map(|rise| (0..run.max(1)).map(move |start| (rise, start))) {
                let slope = slope(rise, run, start);
                let offsets: Vec<u32> = (0..=run).map(|step| (step * rise + start) / run.max(1)).collect();
                for (step, offset) in offsets.iter().enumerate() {
                    assert_eq!(slope.offset(step as u32), *offset, "{slope:?} {step}");
                }
                for offset in 0..run + 3 {
                    let first = offsets.iter().position(|found| *found >= offset);
                    assert_eq!(
                        slope.first_step_at(offset),
                        first.map(|step| step as u32),
                        "{slope:?} {offset}"
                    );
                    let last = offsets.iter().rposition(|found| *found <= offset);
                    assert_eq!(
                        Some(slope.last_step_at(offset)),
                        last.map(|step| step as u32),
                        "{slope:?} {offset}"
                    );
                }
            }
        }
    }

    /// Slopes over the whole number range, against the inequalities that define their steps.
    #[test]
    fn large_slopes_are_entered_where_they_lead() {
        let numbers = [
            0,
            1,
            2,
            3,
            65_535,
            65_536,
            1 << 31,
            (1 << 31) + 1,
            u32::MAX - 1,
            u32::MAX,
        ];
        for run in numbers {
            for rise in numbers.into_iter().filter(|rise| *rise <= run) {
                for start in [0, run / 2, run.saturating_sub(1) / 2, run.saturating_sub(1)] {
                    let slope = slope(rise, run, start);
                    let exact = |step: u32| {
                        (i128::from(step) * i128::from(rise) + i128::from(start)).div_euclid(i128::from(run.max(1)))
                    };
                    for number in numbers.into_iter().chain([run / 3, rise / 3]) {
                        if number <= run {
                            assert_eq!(i128::from(slope.offset(number)), exact(number), "{slope:?} {number}");
                        }
                        let wanted = i128::from(number);
                        match slope.first_step_at(number) {
                            Some(first) => {
                                assert!(exact(first) >= wanted, "{slope:?} {number}");
                                assert!(first == 0 || exact(first - 1) < wanted, "{slope:?} {number}");
                            }
                            None => assert!(number > rise && exact(run) < wanted, "{slope:?} {number}"),
                        }
                        let last = slope.last_step_at(number);
                        assert!(last <= run && exact(last) <= wanted, "{slope:?} {number}");
                        assert!(last == run || exact(last + 1) > wanted, "{slope:?} {number}");
                    }
                }
            }
        }
    }
}
