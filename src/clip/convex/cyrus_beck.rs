//! Cyrus and Beck's segment clipping (1978, "Generalized Two- and Three-Dimensional Clipping", Computers and Graphics
//! 3(1)): against any convex window, by how far along the segment each side's line is crossed.
//!
//! [`Segments::liang_barsky`](crate::clip::Segments::liang_barsky) is its case of an upright window.
//!
//! Guarantees: the result is exactly what of the segment lies in the closed window, touching a corner included, and `None`
//! where no point does: a [`ParametricSegment`], the two end points with the parameters between them where it is cut, as
//! fractions. Clipping it again changes nothing, whatever the window; neither does the order of several windows, nor the
//! orientation of one. Exchanging the end points, or mirroring, does the same to the result. Two units could not promise
//! that: of the segment from (6, 5) to (-1, -1), the triangle (0, 0) (5, 4) (6, 5) keeps what lies between (6, 5) and (2.5,
//! 2), and whichever two units within one unit of these points are joined, clipping takes more than a unit of that away, or
//! all of it.
//!
//! What is drawn at last is rounded once, in one of two ways. [`ends`](ParametricSegment::ends) are the nearest units; in an
//! upright window they lie inside, and are what the siblings return. [`ends_within`](ParametricSegment::ends_within) lie
//! inside any window, but where another side is so close that no unit around the end does, as in a sliver.
//!
//! Cost: outcodes against the window's bounds; then four products a side, two long ones to compare two crossings, and for
//! each coordinate of an end that is cut a long division, with a step for each bit that the segment's length has in units.
//! On a Cortex-M4 that is four to five times what the siblings take. Rounding inwards costs up to eight products a side
//! more for each end that is cut. Take it when the window is not upright, or when there are several.

use crate::{
    clip::{Outcode, convex::convex_crossing::Fraction, segment::segments::Segments},
    geometry::{ConvexWindow, SideLine, SubPixel, SubPoint},
};

impl Segments {
    /// The part of a segment inside a closed convex window, as exact fractions of its length; `None` where no point of it is.
    ///
    /// Cost: four products a side, and a long division for each coordinate of an end that is cut and asked for. Source: Cyrus
    /// and Beck 1978.
    ///
    /// Takes any numbers the coordinates can hold, also outside the domain of `S`.
    ///
    /// ```
    /// use zrow::clip::Segments;
    /// use zrow::geometry::{ConvexWindow, Sub4, SubPoint};
    ///
    /// let at = SubPoint::<Sub4>::from_units;
    /// let triangle = [at(0, 0)?, at(90, 0)?, at(0, 90)?];
    /// let window = ConvexWindow::new(&triangle)?;
    /// let inside = Segments::cyrus_beck(at(-30, 20)?, at(100, 20)?, &window).ok_or("no point in common")?;
    /// assert_eq!(inside.ends(), (at(0, 20)?, at(70, 20)?));
    /// assert_eq!(inside.clip(&window), Some(inside));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn cyrus_beck<S: SubPixel>(
        from: SubPoint<S>,
        to: SubPoint<S>,
        window: &ConvexWindow<'_, S>,
    ) -> Option<ParametricSegment<S>> {
        let whole = ParametricSegment {
            from,
            to,
            entry: None,
            exit: None,
        };
        whole.clip(window)
    }
}

/// A part of a segment: its end points, and between which parameters, kept as exact fractions of its length.
///
/// For what is clipped more than once, as to a view, a panel in it and a mask in that: nothing is rounded in between. It
/// equals another one when it is the same part of the same segment.
/// RAM: 96 bytes.
#[derive(Debug, Copy, Clone)]
pub struct ParametricSegment<S: SubPixel> {
    from: SubPoint<S>,
    to: SubPoint<S>,
    entry: Option<Cut>,
    exit: Option<Cut>,
}

/// Where a side cuts a segment, and the side.
#[derive(Debug, Copy, Clone)]
struct Cut {
    parameter: Fraction,
    side: SideLine,
}

impl<S: SubPixel> ParametricSegment<S> {
    /// The part of it inside another closed convex window; `None` where no point of it is.
    #[inline]
    pub fn clip(&self, window: &ConvexWindow<'_, S>) -> Option<Self> {
        let (entry, exit) = cuts(self.from, self.to, window, (self.entry, self.exit))?;
        Some(Self { entry, exit, ..*self })
    }

    /// The two ends of the segment, each the nearest unit to the exact point, ties to the larger coordinate.
    ///
    /// An end that is cut by a slanted side may be half a unit outside in x and in y.
    #[inline]
    pub fn ends(&self) -> (SubPoint<S>, SubPoint<S>) {
        // Every cut lies in a window, and so in the domain.
        let end = |cut: Option<Cut>, end| {
            cut.and_then(|cut| cut.parameter.point(self.from, self.to))
                .unwrap_or(end)
        };
        (end(self.entry, self.from), end(self.exit, self.to))
    }

    /// The two ends of the segment, rounded inwards: each that is cut is the nearest of the units around the exact point
    /// that lies in the window, less than a unit off in x and in y. The window is one that it was clipped to.
    ///
    /// An end with several nearest units is that furthest from the side that cuts, or from the first one that it was clipped to
    /// where several cut in one point; where that does not decide, as on an upright side, the one with the larger x, then y. Where
    /// the segment between them is clipped and rounded again, nothing changes.
    ///
    /// The exception: where none of the units around the exact point lies in the window, which takes another side within one
    /// and a half units of it, as at a sharp corner or in a sliver. The end is then the nearest of them beyond the side that
    /// cuts, so that what crosses a sliver still does; a segment between such ends may be cut again, and is seldom lost.
    pub fn ends_within(&self, window: &ConvexWindow<'_, S>) -> (SubPoint<S>, SubPoint<S>) {
        // Every cut lies in a window, and so in the domain.
        let end = |cut: Option<Cut>, end| cut.and_then(|cut| self.inner_end(&cut, window)).unwrap_or(end);
        (end(self.entry, self.from), end(self.exit, self.to))
    }

    /// What stands for the end that a side cuts. Not inlined: most segments have none.
    #[inline(never)]
    fn inner_end(&self, cut: &Cut, window: &ConvexWindow<'_, S>) -> Option<SubPoint<S>> {
        if window.is_upright() && cut.side.is_upright() {
            // The nearest unit lies inside.
            return cut.parameter.point(self.from, self.to);
        }
        cut.parameter.cell(self.from, self.to)?.corner_inside(window, cut.side)
    }
}

impl<S: SubPixel> PartialEq for ParametricSegment<S> {
    fn eq(&self, other: &Self) -> bool {
        let is_same = |one: Option<Cut>, other: Option<Cut>| match (one, other) {
            (Some(one), Some(other)) => one.parameter.compare::<S>(&other.parameter).is_eq(),
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
    for side in window.sides() {
        let (start, end) = (side.distance(from), side.distance(to));
        match (start < 0, end < 0) {
            (false, false) => {}
            (true, true) => return None,
            (true, false) => {
                let parameter = Fraction::of_crossing(start, end);
                if entry.is_none_or(|entry| entry.parameter.compare::<S>(&parameter).is_lt()) {
                    entry = Some(Cut { parameter, side });
                }
            }
            (false, true) => {
                let parameter = Fraction::of_crossing(start, end);
                if exit.is_none_or(|exit| parameter.compare::<S>(&exit.parameter).is_lt()) {
                    exit = Some(Cut { parameter, side });
                }
            }
        }
    }
    match (&entry, &exit) {
        (Some(entry), Some(exit)) if exit.parameter.compare::<S>(&entry.parameter).is_lt() => None,
        _ => Some((entry, exit)),
    }
}
