//! Cyrus and Beck's segment clipping (1978, "Generalized Two- and Three-Dimensional Clipping", Computers and Graphics
//! 3(1)): against any convex window, by how far along the segment each side's line is crossed.
//!
//! [`liang_barsky`](crate::clip::liang_barsky) is its case of an upright window.
//!
//! Promises: accepts exactly the segments that share a point with the closed window, touching a corner included. Each end
//! that is cut is the exact point rounded once, to the nearest of the units around it that lies in the window: less than a
//! unit off in x and in y. Of equally near ones it is that furthest from the side that cuts; where that does not decide, as
//! on an upright side, the one with the larger x, then y. Exchanging the end points exchanges the result and changes nothing
//! else; so does the orientation of the window, and mirroring but for that last tie. Clipping the result again changes
//! nothing. In an upright window the result is the sibling's.
//!
//! The exception: where none of the units around the exact end lies in the window, which takes another side within one and a
//! half units of it, as at a sharp corner or in a sliver. The end is then the nearest of them beyond the side that cuts, so
//! that what crosses a sliver still does. Clipping such a result again may cut it again, and seldom drops it. No rule that
//! accepts as exact arithmetic does, and stays within a unit, avoids that in every window: of the segment from (6, 5) to
//! (-1, -1), the triangle (0, 0) (5, 4) (6, 5) keeps what lies between (6, 5) and (2.5, 2), and whichever two units within
//! one unit of these points are joined, clipping takes more than a unit of that away, or all of it.
//!
//! Cost: outcodes against the window's bounds; then four products a side, two long ones to compare two crossings, and for
//! each coordinate of an end that is cut a long division, with a step for each bit that the segment's length has in
//! units. On a Cortex-M4 that is four to five times what the siblings take. A window that is not upright costs up to eight
//! products a side more for each end that is cut. Take it when the window is not upright.

use crate::{
    clip::{Outcode, convex_crossing::Fraction},
    geometry::{ConvexWindow, SubPixel, SubPoint},
};

/// The part of a segment inside a closed convex window; `None` where no point of it is.
///
/// Takes any numbers the coordinates can hold, also outside the domain of `S`.
///
/// ```
/// use zrow::clip::cyrus_beck::clip;
/// use zrow::geometry::{ConvexWindow, Sub4, SubPoint};
///
/// let at = SubPoint::<Sub4>::from_units;
/// let triangle = [at(0, 0)?, at(90, 0)?, at(0, 90)?];
/// let window = ConvexWindow::new(&triangle)?;
/// assert_eq!(
///     clip(at(-30, 20)?, at(100, 20)?, &window),
///     Some((at(0, 20)?, at(70, 20)?))
/// );
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub fn clip<S: SubPixel>(
    from: SubPoint<S>,
    to: SubPoint<S>,
    window: &ConvexWindow<'_, S>,
) -> Option<(SubPoint<S>, SubPoint<S>)> {
    let from_code = Outcode::of_sub_point(from, window.bounds());
    let to_code = Outcode::of_sub_point(to, window.bounds());
    if !from_code.shared(to_code).is_inside() {
        return None;
    }
    let (mut entry, mut exit) = (None::<Cut>, None::<Cut>);
    for (number, side) in window.sides().enumerate() {
        let (start, end) = (side.distance(from), side.distance(to));
        match (start < 0, end < 0) {
            (false, false) => {}
            (true, true) => return None,
            (true, false) => {
                let place = Fraction::of_crossing(start, end);
                if entry.is_none_or(|entry| entry.place.compare::<S>(&place).is_lt()) {
                    entry = Some(Cut { place, number });
                }
            }
            (false, true) => {
                let place = Fraction::of_crossing(start, end);
                if exit.is_none_or(|exit| place.compare::<S>(&exit.place).is_lt()) {
                    exit = Some(Cut { place, number });
                }
            }
        }
    }
    match (&entry, &exit) {
        (None, None) => return Some((from, to)),
        (Some(entry), Some(exit)) if exit.place.compare::<S>(&entry.place).is_lt() => return None,
        _ => {}
    }
    // Never `None` for a point in the window: all of that lies in the domain.
    let end = |cut: Option<Cut>, end| match cut {
        None => Some(end),
        Some(cut) if window.is_upright() => cut.place.point(from, to),
        Some(cut) => inner_end(&cut, from, to, window),
    };
    Some((end(entry, from)?, end(exit, to)?))
}

/// Where a side cuts a segment, and the number of the side.
#[derive(Copy, Clone)]
struct Cut {
    place: Fraction,
    number: usize,
}

/// What stands for the end that a side cuts. Not inlined: most segments have none.
#[inline(never)]
fn inner_end<S: SubPixel>(
    cut: &Cut,
    from: SubPoint<S>,
    to: SubPoint<S>,
    window: &ConvexWindow<'_, S>,
) -> Option<SubPoint<S>> {
    let crossed = window.side(cut.number)?;
    cut.place.cell(from, to)?.corner_inside(window, crossed)
}
