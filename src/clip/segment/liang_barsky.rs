//! Liang and Barsky's segment clipping (1984, "A New Concept and Method for Line Clipping", ACM Transactions on Graphics
//! 3(1)): how far along the segment it enters and leaves the window, without a point in between.
//!
//! Guarantees: accepts exactly the segments that share a point with the closed window, touching a corner included; each
//! end is the exact point rounded once to the nearest unit (ties to the larger coordinate), so at most half a unit off,
//! and never outside the window. Exchanging the end points exchanges the result and changes nothing else; clipping the
//! result again changes nothing. [`Segments::cohen_sutherland`](crate::clip::Segments::cohen_sutherland) gives the same
//! integers.
//!
//! The default: outcodes accept and reject what they can, and say of the rest which sides are crossed and in which
//! direction. Parameters are compared as fractions, by multiplying across, so a rejected segment costs no division and an
//! accepted one divides once for each end that is cut. That counts on a core without a divider. For a mix of segments
//! inside, across and outside it takes fewer instructions than any of its siblings, on a Cortex-M4 and on a Cortex-M0+.

use core::num::NonZeroU32;

use crate::{
    clip::{
        Outcode,
        segment::{
            crossing::{products_fit_32_bits, scaled},
            segments::Segments,
        },
    },
    geometry::{FixedPointWindow, SubPixel, SubPoint, coordinate_after, coordinate_before, distance},
};

impl Segments {
    /// The part of a segment inside a closed window, by how far along it enters and leaves: the default. `None` where no point
    /// of it is inside.
    ///
    /// Each end is the exact point rounded once to the nearest unit, ties to the larger coordinate.
    ///
    /// Cost: outcodes for what is plainly inside or outside; then six products at most to compare fractions, and a division for
    /// each end that is cut; 32-bit throughout for [`Sub4`](crate::geometry::Sub4). Takes any numbers the coordinates can hold,
    /// also outside the domain of `S`. Source: Liang and Barsky 1984.
    pub fn liang_barsky<S: SubPixel>(
        from: SubPoint<S>,
        to: SubPoint<S>,
        window: &FixedPointWindow<S>,
    ) -> Option<(SubPoint<S>, SubPoint<S>)> {
        if window.is_empty() {
            return None;
        }
        let (from_code, to_code) = (Outcode::of_sub_point(from, window), Outcode::of_sub_point(to, window));
        if from_code.either(to_code).is_inside() {
            return Some((from, to));
        }
        if !from_code.shared(to_code).is_inside() {
            return None;
        }
        cut(from, to, (from_code, to_code), window)
    }
}

/// Clips a segment whose outcodes neither accept nor reject it. Not inlined, because most segments do not come here.
#[inline(never)]
fn cut<S: SubPixel>(
    from: SubPoint<S>,
    to: SubPoint<S>,
    (from_code, to_code): (Outcode, Outcode),
    window: &FixedPointWindow<S>,
) -> Option<(SubPoint<S>, SubPoint<S>)> {
    let (first, last) = (window.top_left(), window.bottom_right());
    let x = Axis {
        from: from.x_units(),
        to: to.x_units(),
        before: (Outcode::LEFT, first.x_units()),
        beyond: (Outcode::RIGHT, last.x_units()),
    };
    let y = Axis {
        from: from.y_units(),
        to: to.y_units(),
        before: (Outcode::ABOVE, first.y_units()),
        beyond: (Outcode::BELOW, last.y_units()),
    };
    let (exit_x, exit_y) = (x.exit(to_code), y.exit(to_code));
    let entry = Cut::of(x.entry(from_code), y.entry(from_code), |x, y| !x.is_before::<S>(y));
    // On the axis of the entry the exit never comes first: the other axis alone is compared.
    let passes = match &entry {
        Some(Cut::X(entry)) => exit_y.is_some_and(|exit| exit.is_before::<S>(entry)),
        Some(Cut::Y(entry)) => exit_x.is_some_and(|exit| exit.is_before::<S>(entry)),
        None => false,
    };
    if passes {
        return None;
    }
    let exit = Cut::of(exit_x, exit_y, Fraction::is_before::<S>);
    // Never `None` for a crossing in the window: all of that lies in the domain.
    let end = |cut, whole| match cut {
        None => Some(whole),
        Some(Cut::X(cut)) => SubPoint::from_units(cut.side, y.at::<S>(&cut)).ok(),
        Some(Cut::Y(cut)) => SubPoint::from_units(x.at::<S>(&cut), cut.side).ok(),
    };
    Some((end(entry, from)?, end(exit, to)?))
}

/// Where the segment begins or ends in the window, and across which axis the side lies that is crossed there.
#[derive(Copy, Clone)]
enum Cut {
    X(Fraction),
    Y(Fraction),
}

impl Cut {
    /// The one that decides of the crossings with an upright side (`x`) and with a level one (`y`); where there are both,
    /// `takes_x` says whether it is the first of them.
    fn of(
        x: Option<Fraction>,
        y: Option<Fraction>,
        takes_x: impl FnOnce(&Fraction, &Fraction) -> bool,
    ) -> Option<Self> {
        match (x, y) {
            (None, None) => None,
            (None, Some(y)) => Some(Self::Y(y)),
            (Some(x), Some(y)) if !takes_x(&x, &y) => Some(Self::Y(y)),
            (Some(x), _) => Some(Self::X(x)),
        }
    }
}

/// A segment along one axis, the window's sides across it, and the outcodes of what is beyond them.
struct Axis {
    from: i32,
    to: i32,
    /// The side with the smaller coordinate: the outcode of what is outside of it, and the coordinate in units.
    before: (Outcode, i32),
    /// The side with the larger coordinate: the outcode of what is outside of it, and the coordinate in units.
    beyond: (Outcode, i32),
}

impl Axis {
    /// The fraction of the segment after which it enters the window along this axis, by the outcode of its start; `None` where
    /// that is not outside here. The end is not beyond the same side, so that the direction is known.
    fn entry(&self, code: Outcode) -> Option<Fraction> {
        if code.meets(self.before.0) {
            Some(self.upwards(self.before.1))
        } else if code.meets(self.beyond.0) {
            Some(self.downwards(self.beyond.1))
        } else {
            None
        }
    }

    /// The fraction of the segment after which it leaves the window along this axis, by the outcode of its end; `None` where
    /// that is not outside here.
    fn exit(&self, code: Outcode) -> Option<Fraction> {
        if code.meets(self.before.0) {
            Some(self.downwards(self.before.1))
        } else if code.meets(self.beyond.0) {
            Some(self.upwards(self.beyond.1))
        } else {
            None
        }
    }

    /// The fraction of a segment that runs to larger coordinates at which it crosses a side. Distances between 32-bit coordinates
    /// fit `u32`.
    fn upwards(&self, side: i32) -> Fraction {
        Fraction {
            side,
            distance: distance(self.from, side),
            length: distance(self.from, self.to),
        }
    }

    /// The fraction of a segment that runs to smaller coordinates at which it crosses a side.
    fn downwards(&self, side: i32) -> Fraction {
        Fraction {
            side,
            distance: distance(side, self.from),
            length: distance(self.to, self.from),
        }
    }

    /// The coordinate at a crossing with a side across the other axis: the nearest unit, ties to the larger one.
    fn at<S: SubPixel>(&self, cut: &Fraction) -> i32 {
        let falls = self.to < self.from;
        // Not 0: the side lies between the ends.
        let length = NonZeroU32::new(cut.length).unwrap_or(NonZeroU32::MIN);
        // Ties go to the larger coordinate: a segment to smaller ones takes a step less there.
        let half = (length.get() - u32::from(falls)) >> 1;
        let steps = scaled::<S>(cut.distance, self.from.abs_diff(self.to), half, length);
        if falls {
            coordinate_before(self.from, steps)
        } else {
            coordinate_after(self.from, steps)
        }
    }
}

/// Where a segment crosses the line through a side: `distance / length` of the way, at most 1.
#[derive(Copy, Clone)]
struct Fraction {
    /// The coordinate of the side, in units.
    side: i32,
    distance: u32,
    length: u32,
}

impl Fraction {
    /// Whether this crossing comes before another one, exactly.
    fn is_before<S: SubPixel>(&self, other: &Self) -> bool {
        if products_fit_32_bits::<S>() {
            self.distance * other.length < other.distance * self.length
        } else {
            // Products of 32-bit numbers: they fit.
            let product = |one: u32, other: u32| u64::from(one) * u64::from(other);
            product(self.distance, other.length) < product(other.distance, self.length)
        }
    }
}
