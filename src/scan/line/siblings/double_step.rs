//! The line by double step (Wu and Rokne 1987, "Double-Step Incremental Generation of Lines and Circles", Computer Vision,
//! Graphics, and Image Processing 37(3)): two pixels a decision.
//!
//! In two steps along its major axis a line moves by 0, 1 or 2 pixels along its minor axis, in one of four patterns:
//!
//! ```text
//!  . . .     . . .     . . .     . . #
//!  . . .     . . #     . # #     . # .
//!  # # #     # # .     # . .     # . .
//!  level   late step early step  diagonal
//! ```
//!
//! A line below half a pixel a step never takes the diagonal pattern, a steeper one never the level one. So the sign of
//! one decision variable tells whether the line takes the pattern that is only its own (level or diagonal), and a second
//! comparison is needed only where the two steps move it by one pixel: late or early.
//!
//! Guarantees: the pixels of [`Lines::bresenham`](crate::scan::Lines::bresenham), ties included, for any `i32` end points in either order,
//! clipped or not. The decision variable is Bresenham's error term two steps ahead, less what the larger of the two moves
//! takes, so it is an integer.
//!
//! Cost: one division for each end that is cut; one or two comparisons and a sum of 64 bits every two pixels, because the
//! decision variable reaches 2^33 on the longest lines. [`fold`](Iterator::fold), and so `for_each`, emits both pixels of
//! a pattern in one round; [`next`](Iterator::next) has to keep the second one.
//!
//! Take it where a decision is dear beside a pixel, and lines are near to level, diagonal or upright: there nearly all
//! patterns take one comparison.

use core::fmt::Debug;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::Window,
    scan::line::{
        kuzmin::{LineWalk, OrderedLine, is_outside},
        lines::Lines,
    },
};

impl Lines {
    /// The visible pixels of the line between two pixels, both included, by two pixels a decision.
    ///
    /// The pixels are [`Lines::bresenham`](crate::scan::Lines::bresenham)'s, ties included.
    ///
    /// Cost: one division for each end that is cut (32-bit where the products fit); one or two comparisons and a sum of 64 bits
    /// every two pixels. Source: Wu and Rokne 1987.
    pub fn double_step(
        start: Point,
        end: Point,
        window: &Window,
    ) -> impl Iterator<Item = Point> + Clone + Debug + use<> {
        line(start, end, window).unwrap_or_default()
    }
}

/// The visible part of the line; `None` where no pixel of it is in the window.
///
/// Cost: one division for each end that is cut (32-bit where the products fit), none for a line that is wholly inside.
fn line(from: Point, to: Point, window: &Window) -> Option<DoubleStepPoints> {
    if is_outside(from, to, window) {
        return None;
    }
    let line = OrderedLine::new(from, to);
    let slope = line.nearest();
    let visible = line.visible(&slope, window)?;
    let (major, minor) = (i64::from(line.major_delta), i64::from(line.minor_delta));
    // Two steps of at least half a pixel each move the line by a pixel at least.
    let is_steep = 2 * minor >= major;
    let fewest = if is_steep { major } else { 0 };
    let error = i64::from(slope.error(&visible));
    Some(DoubleStepPoints {
        walk: LineWalk::new(&line, &visible),
        second: None,
        is_steep,
        decision: error + 2 * minor - fewest - major,
        early: minor - fewest,
        fewer: 2 * minor - fewest,
        more: 2 * minor - fewest - major,
    })
}

/// The pixels of the double-step line, from top to bottom.
#[derive(Debug, Clone, Default)]
struct DoubleStepPoints {
    walk: LineWalk,
    /// Whether the second step of the current pattern moves along the minor axis; `None` between patterns.
    second: Option<bool>,
    /// Whether the line moves by one or two pixels along the minor axis in a pattern, not by none or one.
    is_steep: bool,
    /// At least 0 where the next pattern moves by the larger of its two numbers of pixels along the minor axis. It lies between
    /// the negative major distance and twice the minor one.
    decision: i64,
    /// At least this decision: where a pattern moves by one pixel, its first step does.
    early: i64,
    /// What a pattern with the smaller number of pixels along the minor axis adds to the decision variable.
    fewer: i64,
    /// What a pattern with the larger number of pixels along the minor axis adds to the decision variable.
    more: i64,
}

impl DoubleStepPoints {
    /// Whether each of the next two steps along the major axis moves along the minor axis too.
    #[inline]
    fn next_pattern(&mut self) -> (bool, bool) {
        let moves_more = self.decision >= 0;
        let pattern = if moves_more == self.is_steep {
            // The pattern that only a slope of this kind has: diagonal or level.
            (self.is_steep, self.is_steep)
        } else {
            let is_early = self.decision >= self.early;
            (is_early, !is_early)
        };
        self.decision += if moves_more { self.more } else { self.fewer };
        pattern
    }
}

impl Iterator for DoubleStepPoints {
    type Item = Point;

    #[inline]
    fn next(&mut self) -> Option<Point> {
        let moves = match self.second.take() {
            Some(second) => second,
            None => {
                let (first, second) = self.next_pattern();
                self.second = Some(second);
                first
            }
        };
        self.walk.next(|| moves)
    }

    fn fold<B, F: FnMut(B, Point) -> B>(mut self, initial: B, mut each: F) -> B {
        let mut folded = initial;
        if let Some(second) = self.second.take() {
            let Some(point) = self.walk.next(|| second) else {
                return folded;
            };
            folded = each(folded, point);
        }
        loop {
            let (first, second) = self.next_pattern();
            let Some(point) = self.walk.next(|| first) else {
                return folded;
            };
            folded = each(folded, point);
            let Some(point) = self.walk.next(|| second) else {
                return folded;
            };
            folded = each(folded, point);
        }
    }
}
