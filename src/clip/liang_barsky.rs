//! Liang and Barsky's segment clipping (1984, "A New Concept and Method for Line Clipping", ACM Transactions on Graphics
//! 3(1)): how far along the segment it enters and leaves the window, without a point in between.
//!
//! Promises: accepts exactly the segments that share a point with the closed window, touching a corner included; each
//! end is the exact point rounded once to the nearest unit (ties to the larger coordinate), so at most half a unit off,
//! and never outside the window. Exchanging the end points exchanges the result and changes nothing else; clipping the
//! result again changes nothing. [`cohen_sutherland`](crate::clip::cohen_sutherland) gives the same integers.
//!
//! The default: parameters are compared as fractions, by multiplying across, so a rejected segment costs no division and
//! an accepted one divides once for each end that is cut. That counts on a core without a divider.

use crate::{
    clip::crossing::{Crossing, products_fit_32_bits},
    geometry::{SubPixel, SubPoint, SubWindow},
};

/// The part of a segment inside a closed window; `None` where no point of it is.
///
/// Cost: a division for each end that is cut, and six products at most to compare fractions; 32-bit throughout for
/// [`Sub4`](crate::geometry::Sub4). Takes any numbers the coordinates can hold, also outside the domain of `S`.
pub fn clip<S: SubPixel>(
    from: SubPoint<S>,
    to: SubPoint<S>,
    window: &SubWindow<S>,
) -> Option<(SubPoint<S>, SubPoint<S>)> {
    if window.is_empty() {
        return None;
    }
    let (first, last) = (window.top_left(), window.bottom_right());
    let x = Passage::along(
        Axis::X,
        (from.x_units(), to.x_units()),
        (first.x_units(), last.x_units()),
    )?;
    let y = Passage::along(
        Axis::Y,
        (from.y_units(), to.y_units()),
        (first.y_units(), last.y_units()),
    )?;

    let entry = match (x.entry, y.entry) {
        (Some(x), Some(y)) => Some(if x.is_before::<S>(&y) { y } else { x }),
        (x, y) => x.or(y),
    };
    let exit = match (x.exit, y.exit) {
        (Some(x), Some(y)) => Some(if x.is_before::<S>(&y) { x } else { y }),
        (x, y) => x.or(y),
    };
    if let (Some(entry), Some(exit)) = (&entry, &exit) {
        if exit.is_before::<S>(entry) {
            return None;
        }
    }
    let end = |cut: Option<Fraction>, end| match cut {
        Some(cut) => cut.point(from, to),
        None => Some(end),
    };
    Some((end(entry, from)?, end(exit, to)?))
}

#[derive(Copy, Clone)]
enum Axis {
    X,
    Y,
}

/// Where a segment crosses the line through a side: `distance / length` of the way, at most 1.
#[derive(Copy, Clone)]
struct Fraction {
    axis: Axis,
    side: i32,
    distance: u32,
    length: u32,
}

impl Fraction {
    fn is_before<S: SubPixel>(&self, other: &Self) -> bool {
        if products_fit_32_bits::<S>() {
            self.distance.wrapping_mul(other.length) < other.distance.wrapping_mul(self.length)
        } else {
            // Products of 32-bit numbers: they fit.
            let product = |one: u32, other: u32| u64::from(one).wrapping_mul(u64::from(other));
            product(self.distance, other.length) < product(other.distance, self.length)
        }
    }

    /// The nearest point to the crossing. Never `None` for one in the window: all of that lies in the domain.
    fn point<S: SubPixel>(self, from: SubPoint<S>, to: SubPoint<S>) -> Option<SubPoint<S>> {
        let (x, y) = match self.axis {
            Axis::X => (self.side, Crossing::at_x(from, to, self.side).rounded()),
            Axis::Y => (Crossing::at_y(from, to, self.side).rounded(), self.side),
        };
        SubPoint::from_units(x, y).ok()
    }
}

/// Where a segment enters and leaves the window along one axis; `None` where its end is inside.
struct Passage {
    entry: Option<Fraction>,
    exit: Option<Fraction>,
}

impl Passage {
    /// `None` where the segment stays on one side of the window.
    fn along(axis: Axis, (from, to): (i32, i32), (first, last): (i32, i32)) -> Option<Self> {
        let (entry_side, exit_side, starts_before, starts_beyond) = if from <= to {
            (first, last, from < first, from > last)
        } else {
            (last, first, from > last, from < first)
        };
        if starts_beyond {
            return None;
        }
        let length = from.abs_diff(to);
        let crossing = |side| Fraction {
            axis,
            side,
            distance: from.abs_diff(side),
            length,
        };
        let entry = starts_before.then(|| crossing(entry_side));
        if entry.is_some_and(|entry| entry.distance > length) {
            return None;
        }
        let exit = Some(crossing(exit_side)).filter(|exit| exit.distance < length);
        Some(Self { entry, exit })
    }
}
