//! The midpoint line (Pitteway 1967, "Algorithm for Drawing Ellipses or Hyperbolae with a Digital Plotter", The Computer
//! Journal 10(3); Van Aken and Novak 1985, "Curve-Drawing Algorithms for Raster Displays", ACM Transactions on Graphics
//! 4(2)): on which side of the line lies the point midway between the two pixels that may come next?
//!
//! Guarantees: the pixels of [`Lines::bresenham`](crate::scan::Lines::bresenham), ties included, for any `i32` end points in either
//! order, clipped or not. The decision variable is twice the line's implicit function `F(x, y) = dy x - dx y` at the
//! midpoint, so it is an integer; its sign decides, and each of the two steps adds a constant to it.
//!
//! Cost: one division for each end that is cut; a comparison and a sum of 64 bits a pixel, because the function reaches
//! 2^33 on the longest lines.
//!
//! Take it as the pattern for curves, where an implicit function is all there is; for lines Bresenham's error term is
//! the same number in half the width.

use core::fmt::Debug;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::Window,
    scan::line::{
        kuzmin::{LineWalk, OrderedLine, VisibleSteps, is_outside},
        lines::Lines,
    },
};

impl Lines {
    /// The visible pixels of the line between two pixels, both included, by the implicit function at midpoints.
    ///
    /// The pixels are [`Lines::bresenham`](crate::scan::Lines::bresenham)'s, ties included.
    ///
    /// Cost: one division for each end that is cut; a comparison and a sum of 64 bits a pixel. Source: Pitteway 1967; Van Aken and
    /// Novak 1985.
    pub fn midpoint(start: Point, end: Point, window: &Window) -> impl Iterator<Item = Point> + Clone + Debug + use<> {
        line(start, end, window).unwrap_or_default()
    }
}

/// The visible part of the line; `None` where no pixel of it is in the window.
fn line(from: Point, to: Point, window: &Window) -> Option<MidpointPoints> {
    if is_outside(from, to, window) {
        return None;
    }
    let line = OrderedLine::new(from, to);
    let visible = line.visible(&line.nearest(), window)?;
    let (major, minor) = (i64::from(line.major_delta), i64::from(line.minor_delta));
    Some(MidpointPoints {
        decision: at_midpoint(&line, &visible),
        straight: 2 * minor,
        diagonal: 2 * (minor - major),
        walk: LineWalk::new(&line, &visible),
    })
}

/// Twice the implicit function at the midpoint after the first visible pixel: one step ahead along the major axis, half
/// a pixel along the minor one.
fn at_midpoint(line: &OrderedLine, visible: &VisibleSteps) -> i64 {
    // The difference lies between -2^33 and 2^33, while the products need not fit 64 bits: it is taken modulo 2^64.
    let (major, minor) = (i64::from(line.major_delta), i64::from(line.minor_delta));
    let ahead = minor.wrapping_mul(2 * (i64::from(visible.first) + 1));
    let aside = major.wrapping_mul(2 * i64::from(visible.minor_offset) + 1);
    // A tie gives 0, which steps along the minor axis too: where it stays, 1 less makes that negative.
    ahead.wrapping_sub(aside) - i64::from(line.tie_stays())
}

/// The pixels of the midpoint line, from top to bottom.
#[derive(Debug, Clone, Default)]
struct MidpointPoints {
    walk: LineWalk,
    /// Twice the implicit function at the next midpoint, less 1 where ties stay: from 0 on a step goes along the minor axis, too.
    decision: i64,
    /// What a step along the major axis alone adds to the decision variable.
    straight: i64,
    /// What a step along both axes adds to the decision variable.
    diagonal: i64,
}

impl Iterator for MidpointPoints {
    type Item = Point;

    #[inline]
    fn next(&mut self) -> Option<Point> {
        let Self {
            walk,
            decision,
            straight,
            diagonal,
        } = self;
        walk.next(|| {
            let steps_minor = *decision >= 0;
            *decision += if steps_minor { *diagonal } else { *straight };
            steps_minor
        })
    }
}
