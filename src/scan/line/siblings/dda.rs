//! The line by a digital differential analyzer (DDA) in `f32`: the slope is added once a step (Newman and Sproull 1979,
//! "Principles of Interactive Computer Graphics").
//!
//! Guarantees: any `i32` end points, in either order the same pixels; a clipped line has exactly the pixels that the whole
//! line has inside the window. Lines of up to 1,365 steps have [`Lines::bresenham`](crate::scan::Lines::bresenham)'s pixels, ties
//! included. Longer ones may differ where the exact line passes a tie within 1/8,192 pixel and the drift, which is at most
//! 3/2^25 pixel a step.
//!
//! Only the fraction of a pixel is a float. The slope is rounded to 2^-23, so that every sum is exact: nothing adds up but
//! the rounding of the slope, and a clipped line enters with the very sum that the whole line has there.
//!
//! Cost: a float division a line, a sum and a comparison of floats a pixel, in software where the core has none; an integer
//! division for each end that is cut.
//!
//! Take it when a course or a text asks for the DDA; [`Lines::dda_fixed`](crate::scan::Lines::dda_fixed) is the same without floats.

use core::fmt::Debug;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::Window,
    scan::line::{
        kuzmin::{LineWalk, OrderedLine, Slope},
        lines::Lines,
    },
};

/// Bits of the fraction: sums of two fractions below 1 take 24 bits, all that an `f32` has.
const FRACTION_BITS: u32 = 23;
const ONE: u32 = 1 << FRACTION_BITS;
const UNIT: f32 = 1.0 / ONE as f32;
/// 1/8,192 pixel, by which a tie is moved to the side of the larger coordinate: more than a line of 1,365 steps drifts,
/// and less than it passes any tie by.
const BEYOND_TIE: u32 = ONE >> 13;

impl Lines {
    /// The visible pixels of the line between two pixels, both included, by a digital differential analyzer in `f32`.
    ///
    /// The slope is added once a step. Lines of up to 1,365 steps have [`Lines::bresenham`](crate::scan::Lines::bresenham)'s pixels,
    /// ties included; a longer one may miss a pixel that the exact line passes within 1/8,192 pixel and the drift, which is at
    /// most 3/2^25 pixel a step.
    ///
    /// Cost: a float division a line, a sum and a comparison of floats a pixel; an integer division for each end that is cut.
    /// Source: Newman and Sproull 1979.
    pub fn dda(start: Point, end: Point, window: &Window) -> impl Iterator<Item = Point> + Clone + Debug + use<> {
        line(start, end, window).unwrap_or_default()
    }
}

/// The visible part of the line; `None` where no pixel of it is in the window.
fn line(from: Point, to: Point, window: &Window) -> Option<DdaPoints> {
    // No outcodes: what drifts may be visible beside its end points.
    if window.is_empty() {
        return None;
    }
    let line = OrderedLine::new(from, to);
    let steepness = line.minor_delta as f32 / line.major_delta.max(1) as f32;
    // From 1 to 2 a float has 23 bits behind the point.
    let step = (steepness + 1.0) - 1.0;
    let half = ONE / 2;
    let start = if line.tie_stays() {
        half - BEYOND_TIE
    } else {
        half + BEYOND_TIE
    };
    let slope = Slope::in_units((step * ONE as f32) as u32, FRACTION_BITS, start, line.major_delta);
    let visible = line.visible(&slope, window)?;
    Some(DdaPoints {
        walk: LineWalk::new(&line, &visible),
        fraction: slope.error(&visible) as f32 * UNIT,
        step,
    })
}

/// The pixels of the DDA line, from top to bottom.
#[derive(Debug, Clone, Default)]
struct DdaPoints {
    walk: LineWalk,
    /// How far the line is beyond the lower edge of the pixel, below 1.
    fraction: f32,
    /// The slope, at most 1.
    step: f32,
}

impl Iterator for DdaPoints {
    type Item = Point;

    #[inline]
    fn next(&mut self) -> Option<Point> {
        let Self { walk, fraction, step } = self;
        walk.next(|| {
            *fraction += *step;
            let steps_minor = *fraction >= 1.0;
            if steps_minor {
                *fraction -= 1.0;
            }
            steps_minor
        })
    }
}
