//! Dashes: where along a path a stroke is on.
//!
//! Promises: lengths along the path in 1/2^24 pixel. A segment's length is short by at most 2^-29 of it, and rounded to
//! 1/2^24 pixel; what is left of a dash at a corner goes on behind it. Source: PostScript's `setdash` (Adobe 1985), with
//! SVG's rules for odd and empty patterns. Memory: none but the pattern. Cost: two divisions to enter a segment, wherever it
//! becomes visible, and a few instructions a dash.

use fixed::types::{I16F16, U16F16};

/// Fractional bits of distances along a path.
pub(super) const DISTANCE_BITS: u32 = 24;
/// Lengths that count.
const MOST_LENGTHS: usize = 1 << 16;

/// The lengths of dashes and gaps along a path, in pixels, and where in the pattern the path begins.
///
/// The lengths are those of a dash, a gap, a dash and so on; after the last one the first follows again, and an odd number
/// of them so swaps dashes and gaps with every round: `[5]` is `[5, 5]`, `[1, 2, 3]` is `[1, 2, 3, 1, 2, 3]`. A pattern
/// without lengths, or of zeros alone, is a solid stroke. A dash of length 0 is its two caps: a dot where they are round.
/// The first 65,536 lengths count.
///
/// Every dash has the stroke's caps. They lie outside its length, except for butt caps.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
pub struct DashPattern<'a> {
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

    /// The same pattern, with the path beginning so many pixels into it: more of them move the dashes backwards.
    #[must_use]
    pub const fn offset(self, offset: I16F16) -> Self {
        Self { offset, ..self }
    }

    /// The pattern as distances; `None` for a solid stroke.
    pub(super) fn cycle(&self) -> Option<DashCycle<'a>> {
        const MORE_BITS: u32 = DISTANCE_BITS - 16;
        let lengths = self.lengths.get(..MOST_LENGTHS).unwrap_or(self.lengths);
        // Fits: 2^16 times 2^32.
        let sum: i64 = lengths.iter().map(|length| i64::from(length.to_bits())).sum();
        let rounds = if lengths.len() % 2 == 0 { 1 } else { 2 };
        let length = (sum * rounds) << MORE_BITS;
        let start = (i64::from(self.offset.to_bits()) << MORE_BITS).checked_rem_euclid(length)?;
        Some(DashCycle { lengths, length, start })
    }
}

/// A pattern that repeats, in distances along a path.
#[derive(Copy, Clone)]
pub(super) struct DashCycle<'a> {
    lengths: &'a [U16F16],
    /// Of an even number of lengths; more than 0.
    length: i64,
    /// Where in it the path begins.
    pub(super) start: i64,
}

/// From where to where something goes, in distances.
pub(super) type Stretch = (i64, i64);

impl<'a> DashCycle<'a> {
    /// The place in the cycle behind a distance.
    pub(super) fn after(&self, place: i64, distance: i64) -> i64 {
        (place + distance).checked_rem_euclid(self.length).unwrap_or(0)
    }

    /// How much of a dash there is before a place in the cycle; `None` in a gap. Where a dash begins it is 0, where one
    /// ends it is in the gap.
    pub(super) fn dash_before(&self, place: i64) -> Option<i64> {
        let mut begin = 0;
        for index in 0..self.lengths.len() * 2 {
            let end = begin + self.length_of(index);
            if place < end {
                return (index % 2 == 0).then_some(place - begin);
            }
            begin = end;
        }
        None
    }

    /// The dashes that begin before `to` and do not end before `from`, in distances from a place in the cycle.
    pub(super) fn dashes(&self, place: i64, (from, to): Stretch) -> impl Iterator<Item = Stretch> + use<'a> {
        let cycle = *self;
        let place = cycle.after(place, from);
        let mut index = 0;
        let mut begin = from - place;
        while begin + cycle.length_of(index) < from {
            begin += cycle.length_of(index);
            index = cycle.next(index);
        }
        core::iter::from_fn(move || {
            while begin < to {
                let dash = (begin, begin + cycle.length_of(index));
                let is_dash = index % 2 == 0;
                begin = dash.1;
                index = cycle.next(index);
                if is_dash {
                    return Some(dash);
                }
            }
            None
        })
    }

    /// The length of the shortest gap.
    pub(super) fn shortest_gap(&self) -> i64 {
        let gaps = (1..self.lengths.len() * 2).step_by(2);
        gaps.map(|index| self.length_of(index)).min().unwrap_or(0)
    }

    fn next(&self, index: usize) -> usize {
        if index + 1 < self.lengths.len() * 2 {
            index + 1
        } else {
            0
        }
    }

    /// Of the dash or gap of that number; there are twice as many as lengths.
    fn length_of(&self, index: usize) -> i64 {
        let index = index.checked_sub(self.lengths.len()).unwrap_or(index);
        let length = self.lengths.get(index).map_or(0, |length| length.to_bits());
        i64::from(length) << (DISTANCE_BITS - 16)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for DashPattern<'_> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "DashPattern of {} lengths", self.lengths.len());
    }
}
