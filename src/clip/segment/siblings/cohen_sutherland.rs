//! Cohen and Sutherland's segment clipping (1967; in print: Newman and Sproull, "Principles of Interactive Computer
//! Graphics", 1973): outcodes decide, and what they do not decide is cut side by side.
//!
//! Guarantees: accepts exactly the segments that share a point with the closed window, touching a corner included; each
//! end is the exact point rounded once to the nearest unit (ties to the larger coordinate), so at most half a unit off,
//! and never outside the window. Exchanging the end points exchanges the result and changes nothing else; clipping the
//! result again changes nothing. [`Segments::liang_barsky`](crate::clip::Segments::liang_barsky) gives the same integers.
//!
//! Prefer it where flash counts: it takes two thirds of its sibling's. What outcodes do not decide costs a division for each
//! cut, up to four, and a segment that passes a corner outside is cut before it is rejected.

use crate::{
    clip::{
        Outcode,
        segment::{crossing::SideCrossing, segments::Segments},
    },
    geometry::{FixedPointWindow, SubPixel, SubPoint},
};

impl Segments {
    /// The part of a segment inside a closed window, side by side, by outcodes; `None` where no point of it is.
    ///
    /// Each end is the exact point rounded once to the nearest unit, ties to the larger coordinate.
    ///
    /// Cost: a division for each cut, at most two an end; 32-bit throughout for [`Sub4`](crate::geometry::Sub4).
    /// Takes any numbers the coordinates can hold, also outside the domain of `S`. Source: Cohen and Sutherland 1967 (Newman and Sproull 1973).
    pub fn cohen_sutherland<S: SubPixel>(
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
        let mut start = End::of(from, from_code);
        let mut end = End::of(to, to_code);
        while start.code.shared(end.code).is_inside() {
            if !start.code.is_inside() {
                start = End::cut(from, to, start.code, window);
            } else if !end.code.is_inside() {
                end = End::cut(from, to, end.code, window);
            } else {
                return Some((start.point()?, end.point()?));
            }
        }
        None
    }
}

/// One end of what is left of the segment, in units.
struct End {
    x: i32,
    y: i32,
    /// The outcode of the exact point, not of the rounded one: rounding decides nothing.
    code: Outcode,
}

impl End {
    fn of<S: SubPixel>(point: SubPoint<S>, code: Outcode) -> Self {
        Self {
            x: point.x_units(),
            y: point.y_units(),
            code,
        }
    }

    /// Where the whole segment crosses one of the sides that an end is beyond. The other end is not beyond that side,
    /// so the side lies between the end points of the segment.
    fn cut<S: SubPixel>(from: SubPoint<S>, to: SubPoint<S>, code: Outcode, window: &FixedPointWindow<S>) -> Self {
        let (first, last) = (window.top_left(), window.bottom_right());
        if code.meets(Outcode::LEFT.either(Outcode::RIGHT)) {
            let side = if code.meets(Outcode::LEFT) { first.x } else { last.x };
            let crossing = SideCrossing::at_x(from, to, S::units(side));
            Self {
                x: S::units(side),
                y: crossing.rounded(),
                code: crossing.beyond((first.y_units(), Outcode::ABOVE), (last.y_units(), Outcode::BELOW)),
            }
        } else {
            let side = if code.meets(Outcode::ABOVE) { first.y } else { last.y };
            let crossing = SideCrossing::at_y(from, to, S::units(side));
            Self {
                x: crossing.rounded(),
                y: S::units(side),
                code: crossing.beyond((first.x_units(), Outcode::LEFT), (last.x_units(), Outcode::RIGHT)),
            }
        }
    }

    /// Never `None` for an end inside the window: all of that lies in the domain.
    fn point<S: SubPixel>(&self) -> Option<SubPoint<S>> {
        SubPoint::from_units(self.x, self.y).ok()
    }
}
