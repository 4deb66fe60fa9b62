//! The dashes of one segment of a path, and where along it they lie.

use core::num::NonZeroU64;

use crate::{
    geometry::{Window, quotient_nearest},
    scan::stroke::{
        dash_pattern::{DISTANCE_BITS, Dash, DashCycle, Dashes, Stretch},
        wide_stroke::{Direction, FRACTION_BITS, Position, Segment, UNIT, cut},
    },
};

/// Which ends of a segment or a dash are ends of the stroke, and so have a cap.
#[derive(Copy, Clone)]
pub(crate) struct StrokeEnds {
    /// Whether the begin is an end of the stroke.
    pub(crate) begins: bool,
    /// Whether the end is an end of the stroke.
    pub(crate) ends: bool,
}

/// The dashes of a segment, in distances from its begin.
#[derive(Copy, Clone)]
pub(crate) struct SegmentDashes<'a> {
    pub(crate) cycle: &'a DashCycle<'a>,
    /// Position in the cycle where the segment begins.
    pub(crate) position: i64,
    pub(crate) length: i64,
    /// Which ends of the segment are ends of the stroke where a dash reaches them.
    pub(crate) ends: StrokeEnds,
}

impl<'a> SegmentDashes<'a> {
    /// The dashes that begin before `to` and do not end before `from`.
    pub(crate) fn between(&self, from: i64, to: i64) -> Dashes<'a, 'a> {
        self.cycle.dashes(self.position, self.length, (from, to))
    }

    /// Which ends of a dash have a cap: not where it is cut at the limit, and not where it goes on around a corner.
    pub(crate) fn ends_of(&self, dash: &Dash, ruler: &Ruler) -> StrokeEnds {
        StrokeEnds {
            begins: (dash.begins || self.ends.begins) && ruler.reaches(dash.from),
            ends: (dash.ends || self.ends.ends) && ruler.reaches(dash.to),
        }
    }
}

/// Distances along what is left of a segment when it is cut at the limit.
#[derive(Copy, Clone)]
pub(crate) struct Ruler {
    pub(crate) from: Position,
    pub(crate) to: Position,
    /// The distances of both.
    pub(crate) begin: i64,
    pub(crate) end: i64,
}

impl Ruler {
    pub(crate) fn along(segment: &Segment, length: i64) -> Option<Self> {
        let (from, to) = cut(segment.from, segment.to)?;
        let begin = if from == segment.from {
            0
        } else if to == segment.to {
            // The length of a far segment may err by more than what is left of it is long.
            (length - distance(from, to)).max(0)
        } else {
            distance(segment.from, from)
        };
        let end = if to == segment.to {
            length
        } else {
            begin + distance(from, to)
        };
        Some(Self { from, to, begin, end })
    }

    /// Whether a distance lies on the part of the segment within the limit.
    fn reaches(&self, distance: i64) -> bool {
        self.begin <= distance && distance <= self.end
    }

    /// The distance, clamped to the ends of the ruler.
    pub(crate) fn nearest(&self, distance: i64) -> i64 {
        debug_assert!(self.begin <= self.end);
        // Not by `Ord::clamp`, which panics where the ends are swapped: no compiler proves that they are not.
        distance.max(self.begin).min(self.end)
    }

    /// The position at a distance, to the nearest unit; for what is longer than 2^7 pixels within two.
    pub(crate) fn at(&self, distance: i64) -> Position {
        if distance <= self.begin {
            return self.from;
        }
        if distance >= self.end {
            return self.to;
        }
        // To 31 bits: the products fit.
        let length = self.end - self.begin;
        let shift = 33u32.saturating_sub(length.leading_zeros());
        let part = (distance - self.begin) >> shift;
        let Some(whole) = NonZeroU64::new((length >> shift) as u64) else {
            return self.from;
        };
        let between = |from: i64, to: i64| from + quotient_nearest((to - from) * part, whole);
        (between(self.from.0, self.to.0), between(self.from.1, self.to.1))
    }

    /// Distances between which all lies that comes as near as `reach` to the window, and some more.
    pub(crate) fn visible(&self, reach: i64, window: Option<&Window>) -> Stretch {
        let all = (self.begin, self.end);
        let Some(window) = window else { return all };
        let beside = self.between((self.from.0, self.to.0), (window.left, window.right), reach);
        let above = self.between((self.from.1, self.to.1), (window.top, window.bottom), reach);
        (beside.0.max(above.0), beside.1.min(above.1))
    }

    /// Distances between which the coordinates along an axis, from one to the other, are within `reach` of those pixels.
    fn between(&self, (from, to): (i64, i64), (first, end): (i32, i32), reach: i64) -> Stretch {
        /// Positions in 1/256 pixel and distances in 1/65,536: the products fit. Reaches have more than that to spare.
        const FEWER_BITS: u32 = 8;
        let all = (self.begin, self.end);
        let (first, end) = (i64::from(first) * UNIT - reach, i64::from(end) * UNIT + reach);
        let extent = (to - from).unsigned_abs() >> FEWER_BITS;
        // What is all within reach, or is shorter than 16 pixels, is not worth the divisions.
        let is_within = first <= from.min(to) && from.max(to) <= end;
        let is_short = extent < 16 << (FRACTION_BITS - FEWER_BITS);
        let (Some(extent), false) = (NonZeroU64::new(extent), is_within || is_short) else {
            return all;
        };
        let length = (self.end - self.begin) >> FEWER_BITS;
        let at = |coordinate: i64| {
            let part = ((coordinate - from) * (to - from).signum()) >> FEWER_BITS;
            let part = part.clamp(0, extent.get() as i64);
            self.begin + (quotient_nearest(part * length, extent) << FEWER_BITS)
        };
        let (near, far) = (at(first), at(end));
        // What shifting and rounding are worth is less than a pixel.
        let margin = 2 << DISTANCE_BITS;
        (
            (near.min(far) - margin).max(self.begin),
            (near.max(far) + margin).min(self.end),
        )
    }
}

/// The distance between two positions, rounded down to 2^-29 of itself and to 1/2^24 pixel.
pub(crate) fn distance(from: Position, to: Position) -> i64 {
    if from == to {
        return 0;
    }
    const MORE_BITS: i32 = (DISTANCE_BITS - FRACTION_BITS) as i32;
    let direction = Direction::of((to.0 - from.0, to.1 - from.1));
    let shift = direction.scale - MORE_BITS;
    let length = direction.length.get() as i64;
    if shift > 0 {
        (length + (1 << (shift - 1))) >> shift
    } else {
        length << -shift
    }
}
