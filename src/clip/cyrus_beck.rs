//! Cyrus and Beck's segment clipping (1978, "Generalized Two- and Three-Dimensional Clipping", Computers and Graphics
//! 3(1)): against any convex window, by how far along the segment each side's line is crossed.
//!
//! [`liang_barsky`](crate::clip::liang_barsky) is its case of an upright window.
//!
//! Promises, of a [`ParametricSegment`]: it keeps exactly the points of the segment that lie in the closed window, touching a
//! corner included, and nothing where there are none. Nothing is rounded but by [`ends`](ParametricSegment::ends), once, by
//! at most half a unit. Clipping the result again changes nothing, whatever the window; neither does the order of several
//! windows, nor the orientation of one. Exchanging the end points, or mirroring, does the same to the result.
//!
//! [`clip`] rounds at once, as its siblings do: in an upright window its result is theirs. It accepts the same segments. Each
//! end that is cut is the exact point rounded once, to the nearest of the units around it that lies in the window: less than
//! a unit off in x and in y. Of equally near ones it is that furthest from the side that cuts; where that does not decide, as
//! on an upright side, the one with the larger x, then y. Exchanging the end points exchanges the result and changes nothing
//! else; so does the orientation of the window, and mirroring but for that last tie. Clipping the result again changes
//! nothing.
//!
//! The exception: where none of the units around the exact end lies in the window, which takes another side within one and a
//! half units of it, as at a sharp corner or in a sliver. The end is then the nearest of them beyond the side that cuts, so
//! that what crosses a sliver still does. Clipping such a result again may cut it again, and seldom drops it: clip the
//! [`ParametricSegment`] instead. No two units can stand for every part of a segment. Of the one from (6, 5) to (-1, -1), the
//! triangle (0, 0) (5, 4) (6, 5) keeps what lies between (6, 5) and (2.5, 2), and whichever two units within one unit of
//! these points are joined, clipping takes more than a unit of that away, or all of it.
//!
//! Cost: outcodes against the window's bounds; then four products a side, two long ones to compare two crossings, and for
//! each coordinate of an end that is cut a long division, with a step for each bit that the segment's length has in
//! units. On a Cortex-M4 that is four to five times what the siblings take. A window that is not upright costs up to eight
//! products a side more for each end that is cut and rounded into it. Take it when the window is not upright.

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
    let (entry, exit) = cuts(from, to, window, (None, None))?;
    if entry.is_none() && exit.is_none() {
        return Some((from, to));
    }
    let end = |cut: Option<Cut>, end| match cut {
        None => Some(end),
        Some(cut) if window.is_upright() => cut.place.point(from, to),
        Some(cut) => inner_end(&cut, from, to, window),
    };
    // Never `None` for a point in the window: all of that lies in the domain.
    Some((end(entry, from)?, end(exit, to)?))
}

/// A part of a segment: its end points, and between which places on it, kept as exact fractions of its length.
///
/// For what is clipped more than once, as to a view, a panel in it and a mask in that: nothing is rounded in between. It
/// equals another one when it is the same part of the same segment.
///
/// Cost: 80 bytes; clipping it takes what [`clip`] does without the ends, and [`ends`](Self::ends) two long divisions for
/// each end that is cut.
///
/// ```
/// use zrow::clip::cyrus_beck::ParametricSegment;
/// use zrow::geometry::{ConvexWindow, Sub4, SubPoint};
///
/// let at = SubPoint::<Sub4>::from_units;
/// let sliver = [at(0, 0)?, at(5, 4)?, at(6, 5)?];
/// let window = ConvexWindow::new(&sliver)?;
/// let segment = ParametricSegment::new(at(6, 5)?, at(-1, -1)?);
/// let inside = segment.clip(&window).expect("they share a point");
/// assert_eq!(inside.ends(), (at(6, 5)?, at(3, 2)?)); // Rounded from (2.5, 2).
/// assert_eq!(inside.clip(&window), Some(inside));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone)]
pub struct ParametricSegment<S: SubPixel> {
    from: SubPoint<S>,
    to: SubPoint<S>,
    entry: Option<Cut>,
    exit: Option<Cut>,
}

/// Where a side cuts a segment, and the number of the side in the window that has it.
#[derive(Debug, Copy, Clone)]
struct Cut {
    place: Fraction,
    number: usize,
}

impl<S: SubPixel> ParametricSegment<S> {
    /// All of a segment. Takes any numbers the coordinates can hold, also outside the domain of `S`.
    pub const fn new(from: SubPoint<S>, to: SubPoint<S>) -> Self {
        Self {
            from,
            to,
            entry: None,
            exit: None,
        }
    }

    /// The part of it inside a closed convex window; `None` where no point of it is.
    pub fn clip(&self, window: &ConvexWindow<'_, S>) -> Option<Self> {
        let (entry, exit) = cuts(self.from, self.to, window, (self.entry, self.exit))?;
        Some(Self { entry, exit, ..*self })
    }

    /// Its two ends, each the nearest unit to the exact point, ties to the larger coordinate.
    ///
    /// An end that is cut may be half a unit outside the window in x and in y: [`clip`] is what rounds inwards.
    pub fn ends(&self) -> (SubPoint<S>, SubPoint<S>) {
        // Every cut lies in a window, and so in the domain.
        let end = |cut: Option<Cut>, end| cut.and_then(|cut| cut.place.point(self.from, self.to)).unwrap_or(end);
        (end(self.entry, self.from), end(self.exit, self.to))
    }
}

impl<S: SubPixel> PartialEq for ParametricSegment<S> {
    fn eq(&self, other: &Self) -> bool {
        let is_same = |one: Option<Cut>, other: Option<Cut>| match (one, other) {
            (Some(one), Some(other)) => one.place.compare::<S>(&other.place).is_eq(),
            (None, None) => true,
            _ => false,
        };
        let has_same_ends = self.from == other.from && self.to == other.to;
        has_same_ends && is_same(self.entry, other.entry) && is_same(self.exit, other.exit)
    }
}

impl<S: SubPixel> Eq for ParametricSegment<S> {}

#[cfg(feature = "defmt")]
impl<S: SubPixel> defmt::Format for ParametricSegment<S> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        let (from, to) = self.ends();
        defmt::write!(formatter, "ParametricSegment {} to {}", from, to);
    }
}

/// Where a segment enters the window and leaves it, if it has entered and left there before; `None` where nothing is left.
#[inline]
fn cuts<S: SubPixel>(
    from: SubPoint<S>,
    to: SubPoint<S>,
    window: &ConvexWindow<'_, S>,
    (mut entry, mut exit): (Option<Cut>, Option<Cut>),
) -> Option<(Option<Cut>, Option<Cut>)> {
    let from_code = Outcode::of_sub_point(from, window.bounds());
    let to_code = Outcode::of_sub_point(to, window.bounds());
    if !from_code.shared(to_code).is_inside() {
        return None;
    }
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
        (Some(entry), Some(exit)) if exit.place.compare::<S>(&entry.place).is_lt() => None,
        _ => Some((entry, exit)),
    }
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
