//! Nicholl, Lee and Nicholl's segment clipping (1987, "An Efficient New Algorithm for 2-D Line Clipping", Computer
//! Graphics 21(4), SIGGRAPH): on which side of the rays from the start to the window's corners the end lies.
//!
//! The start is inside, beyond one side (an edge region) or beyond two (a corner region). The rays from there to the
//! corners part the plane into areas, and the area of the end says which sides the segment crosses. Where the paper
//! turns and mirrors the picture until the start is in one of three regions, each axis is measured along the direction
//! of travel here.
//!
//! Guarantees: accepts exactly the segments that share a point with the closed window, touching a corner included; each
//! end is the exact point rounded once to the nearest unit (ties to the larger coordinate), so at most half a unit off,
//! and never outside the window. Exchanging the end points exchanges the result and changes nothing else; clipping the
//! result again changes nothing. [`Segments::liang_barsky`](crate::clip::Segments::liang_barsky) gives the same integers.
//!
//! Cost: outcodes for what is plainly inside or outside; then at most three comparisons of two products, and a division for
//! each end that is cut, never one for an end that is not part of the result. Take it to see how areas of the plane decide:
//! [`Segments::liang_barsky`](crate::clip::Segments::liang_barsky) makes as many comparisons, of numbers that the cuts need anyway.

use core::cmp::Ordering;

use crate::{
    clip::{
        Outcode,
        segment::{
            crossing::{SideCrossing, products_fit_32_bits},
            segments::Segments,
        },
    },
    geometry::{FixedPointWindow, SubPixel, SubPoint},
};

impl Segments {
    /// The part of a segment inside a closed window, by the area of the plane that its ends lie in; `None` where no point of it is.
    ///
    /// Each end is the exact point rounded once to the nearest unit, ties to the larger coordinate.
    ///
    /// Takes any numbers the coordinates can hold, also outside the domain of `S`.
    /// Source: Nicholl, Lee and Nicholl 1987.
    ///
    /// ```
    /// use zrow::clip::Segments;
    /// use zrow::geometry::{Sub4, SubPoint, FixedPointWindow};
    ///
    /// let at = SubPoint::<Sub4>::from_units;
    /// let window = FixedPointWindow::new(at(0, 0)?, at(100, 60)?)?;
    /// // From the left, out through the upper side.
    /// assert_eq!(
    ///     Segments::nicholl_lee_nicholl(at(-20, 30)?, at(80, -20)?, &window),
    ///     Some((at(0, 20)?, at(40, 0)?))
    /// );
    /// assert_eq!(Segments::nicholl_lee_nicholl(at(-20, 10)?, at(20, -20)?, &window), None);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn nicholl_lee_nicholl<S: SubPixel>(
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
        cut(from, to, window)
    }
}

/// Clips a segment whose outcodes neither accept nor reject it. Not inlined, because most segments do not come here.
#[inline(never)]
fn cut<S: SubPixel>(
    from: SubPoint<S>,
    to: SubPoint<S>,
    window: &FixedPointWindow<S>,
) -> Option<(SubPoint<S>, SubPoint<S>)> {
    let (first, last) = (window.top_left(), window.bottom_right());
    let x = Travel::along((from.x_units(), to.x_units()), (first.x_units(), last.x_units()));
    let y = Travel::along((from.y_units(), to.y_units()), (first.y_units(), last.y_units()));
    let entry = match (x.enters, y.enters) {
        (false, false) => None,
        (true, false) => Some(CrossedAxis::X),
        (false, true) => Some(CrossedAxis::Y),
        // A corner region: the side that is crossed later.
        (true, true) if ray::<S>(&x, x.to_near, &y, y.to_near).is_lt() => Some(CrossedAxis::Y),
        (true, true) => Some(CrossedAxis::X),
    };
    // The segment passes a corner outside: it leaves on one axis before it enters on the other.
    let passes = match entry {
        Some(CrossedAxis::X) => y.leaves && ray::<S>(&x, x.to_near, &y, y.to_far).is_gt(),
        Some(CrossedAxis::Y) => x.leaves && ray::<S>(&x, x.to_far, &y, y.to_near).is_lt(),
        None => false,
    };
    if passes {
        return None;
    }
    let exit = match (x.leaves, y.leaves) {
        (false, false) => None,
        (true, false) => Some(CrossedAxis::X),
        (false, true) => Some(CrossedAxis::Y),
        (true, true) if ray::<S>(&x, x.to_far, &y, y.to_far).is_lt() => Some(CrossedAxis::X),
        (true, true) => Some(CrossedAxis::Y),
    };
    let end = |axis: Option<CrossedAxis>, whole: SubPoint<S>, side_x: i32, side_y: i32| match axis {
        None => Some(whole),
        Some(CrossedAxis::X) => SubPoint::from_units(side_x, SideCrossing::at_x(from, to, side_x).rounded()).ok(),
        Some(CrossedAxis::Y) => SubPoint::from_units(SideCrossing::at_y(from, to, side_y).rounded(), side_y).ok(),
    };
    // Never `None` for a crossing in the window: all of that lies in the domain.
    Some((end(entry, from, x.near, y.near)?, end(exit, to, x.far, y.far)?))
}

/// Which sides are crossed: the left or right one along `X`, the upper or lower one along `Y`.
#[derive(Copy, Clone)]
enum CrossedAxis {
    X,
    Y,
}

/// A segment that outcodes do not reject, along one axis: the window's sides in the order in which it meets them.
struct Travel {
    /// The coordinate of the side that is met first, in units.
    near: i32,
    /// The coordinate of the side that is met last, in units.
    far: i32,
    /// Whether the start is before the near side.
    enters: bool,
    /// Whether the end is beyond the far side.
    leaves: bool,
    /// The distance between both ends.
    length: u32,
    /// The distance from the start to the near side. Where that side is behind the start, the number is not used.
    to_near: u32,
    /// The distance from the start to the far side, which is never behind the start.
    to_far: u32,
}

impl Travel {
    /// A segment by the coordinates of its start and its end, and the first and last one of the window, in units.
    fn along((from, to): (i32, i32), (first, last): (i32, i32)) -> Self {
        let (near, far, enters, leaves) = if from <= to {
            (first, last, from < first, to > last)
        } else {
            (last, first, from > last, to < first)
        };
        Self {
            near,
            far,
            enters,
            leaves,
            length: from.abs_diff(to),
            to_near: from.abs_diff(near),
            to_far: from.abs_diff(far),
        }
    }
}

/// The ray from the start to the corner at these distances against the segment: `Less` where the segment reaches the
/// corner's x before its y, `Equal` where it goes through the corner.
fn ray<S: SubPixel>(x: &Travel, to_x: u32, y: &Travel, to_y: u32) -> Ordering {
    if products_fit_32_bits::<S>() {
        (to_x * y.length).cmp(&(to_y * x.length))
    } else {
        // Products of 32-bit numbers: they fit.
        let product = |one: u32, other: u32| u64::from(one) * u64::from(other);
        product(to_x, y.length).cmp(&product(to_y, x.length))
    }
}
