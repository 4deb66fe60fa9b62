//! Where a segment crosses a plane: an exact fraction of its length, compared exactly, rounded once.

use core::cmp::Ordering;

use crate::clip::space::scale::scale_nearest;

/// A position along a segment: `part / whole` of the way from its start to its end. Both are below 2^62, and `whole` is not 0.
#[derive(Debug, Copy, Clone)]
pub(super) struct Fraction {
    part: u64,
    whole: u64,
}

impl Fraction {
    /// The position at which the segment crosses a plane. `from` and `to` are the signed distances of its start and its end
    /// from the plane, and have different signs.
    pub(super) const fn of_crossing(from: i64, to: i64) -> Self {
        let part = from.unsigned_abs();
        Self {
            part,
            whole: part + to.unsigned_abs(),
        }
    }

    /// Compares two positions along one segment: `Less` where this one comes first.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        product(self.part, other.whole).cmp(&product(other.part, self.whole))
    }

    /// Whether a value that changes evenly from `from` to `to` along the segment is below 0 at this position.
    pub(super) fn is_below_zero(&self, from: i64, to: i64) -> bool {
        let rest = self.whole - self.part;
        match (from < 0, to < 0) {
            (false, false) => false,
            (true, true) => true,
            (true, false) => product(from.unsigned_abs(), rest) > product(to.unsigned_abs(), self.part),
            (false, true) => product(from.unsigned_abs(), rest) < product(to.unsigned_abs(), self.part),
        }
    }

    /// The number at this position between those of the segment's start and end, rounded to the nearest, ties to the larger
    /// one. The segment from the end to the start has the same one at the same point.
    pub(super) fn between(&self, from: i64, to: i64) -> i64 {
        let (low, part) = if from <= to {
            (from, self.part)
        } else {
            (to, self.whole - self.part)
        };
        // At most the difference, so that the sum is at most the larger number.
        low.saturating_add_unsigned(scale_nearest(from.abs_diff(to), part, self.whole).0)
    }
}

/// The product of two numbers: its upper and its lower 64 bits, which compare as it does.
fn product(one: u64, other: u64) -> (u64, u64) {
    const LOW: u64 = u32::MAX as u64;
    let (one_high, one_low) = (one >> 32, one & LOW);
    let (other_high, other_low) = (other >> 32, other & LOW);
    let low = one_low * other_low;
    // A product of two numbers of 32 bits has room for two more of them.
    let middle = one_high * other_low + (low >> 32);
    let second = one_low * other_high + (middle & LOW);
    let high = one_high * other_high + (middle >> 32) + (second >> 32);
    (high, second << 32 | low & LOW)
}
