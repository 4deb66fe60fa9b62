//! Dashes: where along a path a stroke is on.
//!
//! Guarantees: lengths along the path in 1/2^24 pixel. A segment's length is short by at most 2^-29 of it, and rounded to
//! 1/2^24 pixel; what is left of a dash at a corner goes on behind it. Source: PostScript's `setdash` (Adobe 1985), with
//! SVG's rules for odd and empty patterns. Memory: none but the pattern. Cost: two divisions to enter a segment at any
//! distance, a walk of up to two rounds of the pattern from there, and a few instructions a dash.

use core::num::{NonZeroU64, NonZeroUsize};

use fixed::types::{I16F16, U16F16};

use crate::scan::stroke::LineCap;

/// Fractional bits of distances along a path.
pub(crate) const DISTANCE_BITS: u32 = 24;
/// The most lengths of a pattern that count; those after them are left out.
const MOST_LENGTHS: usize = 1 << 16;

/// The lengths of dashes and gaps along a path, in pixels, and where in the pattern the path begins.
///
/// [`StrokeStyle::dashes`](crate::draw::StrokeStyle::dashes) says what they mean.
#[derive(Copy, Clone)]
pub(crate) struct DashPattern<'a> {
    lengths: &'a [U16F16],
    offset: I16F16,
}

impl<'a> DashPattern<'a> {
    /// A pattern that begins where the path does.
    pub const fn new(lengths: &'a [U16F16]) -> Self {
        Self {
            lengths,
            offset: I16F16::ZERO,
        }
    }

    /// Lets the path begin so many pixels into the pattern: larger offsets move the dashes backwards along the path.
    #[must_use]
    pub const fn offset(self, offset: I16F16) -> Self {
        Self { offset, ..self }
    }

    /// The pattern as distances; `None` for a solid stroke. The cap, and half the width in 1/65,536 pixel, say which gaps
    /// are bridged.
    pub(crate) fn cycle(&self, cap: LineCap, half_width: i64) -> Option<DashCycle<'a>> {
        const MORE_BITS: u32 = DISTANCE_BITS - 16;
        let lengths = self.lengths.get(..MOST_LENGTHS).unwrap_or(self.lengths);
        // Fits: 2^16 times 2^32.
        let sum: i64 = lengths.iter().map(|length| i64::from(length.to_bits())).sum();
        let rounds = if lengths.len() % 2 == 0 { 1 } else { 2 };
        let length = (sum * rounds as i64) << MORE_BITS;
        let start = (i64::from(self.offset.to_bits()) << MORE_BITS).checked_rem_euclid(length)?;
        let size = NonZeroU64::new(length as u64)?;
        let mut cycle = DashCycle {
            lengths,
            count: NonZeroUsize::new(lengths.len())?,
            length: size,
            start,
            is_within_caps: cap.reach(half_width) << MORE_BITS > length,
            shortest_gap: i64::MAX,
            separating_gap: 0,
            has_separating_gap: false,
        };
        for index in (1..lengths.len() * rounds).step_by(2) {
            let gap = cycle.length_of(index);
            cycle.shortest_gap = cycle.shortest_gap.min(gap);
            if !(cycle.is_within_caps && cap.bridges((gap >> MORE_BITS) as u32, half_width)) {
                cycle.has_separating_gap = true;
            } else if gap >= cycle.separating_gap {
                cycle.separating_gap = gap + 1;
            }
        }
        Some(cycle)
    }
}

/// A pattern that repeats, in distances along a path.
#[derive(Copy, Clone)]
pub(crate) struct DashCycle<'a> {
    lengths: &'a [U16F16],
    /// The number of lengths in the pattern.
    count: NonZeroUsize,
    /// Sum of an even number of lengths: at most 2^57.
    length: NonZeroU64,
    /// Position in the cycle where the path begins.
    pub(crate) start: i64,
    /// Whether a cap reaches further than the cycle is long. Otherwise a pixel is within the caps of so few dashes that all
    /// of them can be looked at, and none are joined.
    pub(crate) is_within_caps: bool,
    /// Length of the shortest gap.
    pub(crate) shortest_gap: i64,
    /// Gaps as long as this, or longer, separate two dashes: 0 where the caps bridge none.
    separating_gap: i64,
    /// Whether the cycle has a gap that separates.
    has_separating_gap: bool,
}

/// Begin and end of a stretch of a path, as distances along the path.
pub(crate) type Stretch = (i64, i64);

/// A dash of a segment, or several that are joined over bridged gaps, in distances from the segment's begin.
#[derive(Copy, Clone)]
pub(crate) struct Dash {
    /// At least 0: what lies before the segment is cut off.
    pub(crate) from: i64,
    /// At most the length of the segment.
    pub(crate) to: i64,
    /// Whether the dash begins on the segment, and not before it.
    pub(crate) begins: bool,
    /// Whether the dash ends on the segment, and not behind it.
    pub(crate) ends: bool,
}

impl<'a> DashCycle<'a> {
    /// Length of the cycle: more than 0.
    pub(crate) const fn length(&self) -> i64 {
        self.length.get() as i64
    }

    /// Position in the cycle at `distance` behind `position`; neither is negative.
    pub(crate) fn after(&self, position: i64, distance: i64) -> i64 {
        debug_assert!(position >= 0 && distance >= 0);
        ((position + distance) as u64 % self.length) as i64
    }

    /// Whether all lengths and the position where the path begins are multiples of half a pixel. Cost: that of a walk over the
    /// pattern.
    pub(crate) fn is_in_halves(&self) -> bool {
        const MORE: i64 = (1 << (DISTANCE_BITS - 1)) - 1;
        let mut lengths = (0..self.lengths.len()).map(|index| self.length_of(index));
        self.start & MORE == 0 && lengths.all(|length| length & MORE == 0)
    }

    /// How much of a dash there is before a position in the cycle; `None` in a gap. Where a dash begins it is 0, where one
    /// ends it is in the gap.
    pub(crate) fn dash_before(&self, position: i64) -> Option<i64> {
        let mut begin = 0;
        for index in 0..self.lengths.len() * 2 {
            let end = begin + self.length_of(index);
            if position < end {
                return (index % 2 == 0).then_some(position - begin);
            }
            begin = end;
        }
        None
    }

    /// The dashes of a segment of this length that begin before `to` and do not end before `from`, in their order and in
    /// distances from the segment's begin, which is at that position in the cycle.
    ///
    /// A dash belongs to the segment when it begins before the end of the segment, and begins at the segment's begin or
    /// ends behind it. Those that lie within the segment are joined over a gap that is bridged.
    pub(crate) fn dashes(&self, position: i64, length: i64, (from, to): Stretch) -> Dashes<'_, 'a> {
        // Before the first round as in it.
        let rounds = ((from + position).max(0) as u64 / self.length) as i64;
        let skipped = match self.separating_gap {
            0 => rounds,
            // Enters a round early: a gap that separates lies between, so the same dashes are joined whatever `from` is.
            _ if self.has_separating_gap => rounds - 1,
            // All are joined.
            _ => 0,
        };
        Dashes {
            cycle: self,
            index: 0,
            begin: skipped.max(0) * self.length() - position,
            end: length,
            from,
            to: to.min(length),
            is_whole: skipped <= 0 || self.separating_gap == 0,
        }
    }

    /// A distance along the path within which there are never more than `dashes` dashes; negative where one round of
    /// the pattern may have as many.
    pub(crate) fn stretch_of(&self, dashes: usize) -> i64 {
        // A round has at most as many dashes as the pattern has lengths, and parts of a round may lie at both ends.
        let rounds = (dashes / self.count) as i64 - 2;
        rounds.saturating_mul(self.length())
    }

    /// An upper bound for the number of dashes along a distance.
    pub(crate) fn most_within(&self, distance: i64) -> u64 {
        // Parts of a round at both ends, and a round has at most as many dashes as the pattern has lengths.
        let rounds = distance.unsigned_abs() / self.length + 2;
        rounds.saturating_mul(self.count.get() as u64)
    }

    /// Length of the dash or gap with that index; there are twice as many as lengths.
    fn length_of(&self, index: usize) -> i64 {
        let index = index.checked_sub(self.lengths.len()).unwrap_or(index);
        let length = self.lengths.get(index).map_or(0, |length| length.to_bits());
        i64::from(length) << (DISTANCE_BITS - 16)
    }
}

/// The dashes of a segment: see [`DashCycle::dashes`].
#[derive(Copy, Clone)]
pub(crate) struct Dashes<'c, 'a> {
    cycle: &'c DashCycle<'a>,
    /// Index of the next dash in the cycle: even.
    index: usize,
    /// The distance at which the next dash begins.
    begin: i64,
    /// Length of the segment.
    end: i64,
    /// Dashes that end before this distance are left out.
    from: i64,
    /// The end of the interval: dashes that begin there or behind it are left out.
    to: i64,
    /// Whether the next dash is the first of those that are joined: the segment begins, or a gap that separates lies before.
    is_whole: bool,
}

impl Dashes<'_, '_> {
    /// Goes on by one dash and the gap behind it. Returns the dash, and whether the next one is another one.
    fn step(&mut self) -> (Stretch, bool) {
        #[cfg(test)]
        crate::scan::stroke::work::step();
        let dash = (self.begin, self.begin + self.cycle.length_of(self.index));
        let gap = self.cycle.length_of(self.index + 1);
        self.begin = dash.1 + gap;
        self.index += 2;
        if self.index >= self.cycle.lengths.len() * 2 {
            self.index = 0;
        }
        (
            dash,
            gap >= self.cycle.separating_gap || dash.0 < 0 || self.next_goes_on(),
        )
    }

    /// Whether the next dash goes on behind the segment, or begins there. What goes on around a corner, or comes in around
    /// one, has no cap there: it stays a dash of its own.
    fn next_goes_on(&self) -> bool {
        self.begin >= self.end || self.begin + self.cycle.length_of(self.index) > self.end
    }

    /// Leaves out whole rounds of dashes that are all joined, but for the last round.
    fn skip_rounds(&mut self) {
        let rest = self.end - self.begin;
        if rest >= 2 * self.cycle.length() {
            let rounds = (rest as u64 / self.cycle.length) as i64 - 1;
            self.begin += rounds * self.cycle.length();
        }
    }
}

impl Iterator for Dashes<'_, '_> {
    type Item = Dash;

    fn next(&mut self) -> Option<Dash> {
        // The first of the dashes that are joined.
        let mut first: Option<Stretch> = None;
        while self.begin < first.map_or(self.to, |_| self.end) {
            let ((begin, end), is_separate) = self.step();
            // What began before the segment and ends at its begin is no dash of it.
            if begin < 0 && end <= 0 {
                continue;
            }
            let (first_begin, first_end) = *first.get_or_insert((begin, end));
            if !is_separate {
                if !self.cycle.has_separating_gap {
                    self.skip_rounds();
                }
                continue;
            }
            first = None;
            let is_whole = core::mem::replace(&mut self.is_whole, true);
            if is_whole && end >= self.from {
                return Some(Dash {
                    from: first_begin.max(0),
                    to: end.min(self.end),
                    // One that has no length has its caps at the first vertex even where another one runs through.
                    begins: first_begin > 0 || first_begin == first_end,
                    ends: end <= self.end,
                });
            }
        }
        None
    }
}
