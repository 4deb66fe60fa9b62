//! An edge of a silhouette that is active: it is set up in its first row, and passes through rows until it ends.
//!
//! Guarantees: in each row x is exact within 1/256 pixel, however high and wide the edge is.

use crate::{
    coverage::{X_BITS, X_ONE},
    geometry::{divide_floor_large, divide_long, leading_zeros, multiply_shift},
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
};

/// Pixels up to which an edge is short, in height and in width.
const SHORT: i32 = 16;

// Not re-exported.
/// An active edge of a silhouette: one division where it is set up, two products a row. Both have 64 bits where it is large.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ActiveEdge<D> {
    /// x of its upper and of its lower end in 1/8192 pixel, from the left side of the row.
    upper: i32,
    lower: i32,
    /// Columns a row, shifted by as many bits as fit: times a part of the height it is at most the width, shifted as far. Of a
    /// large edge the product may have more than 32 bits.
    slope: i32,
    /// y of its upper and of its lower end, in units of the look's precision.
    first: i32,
    last: i32,
    /// Its face.
    face: u16,
    /// Bits: by how much a product with the slope is shifted down, the number of the edge in its face, whether it goes up, is
    /// added, is drawn, is long, and is large.
    flags: u16,
    /// The depth of its middle.
    depth: D,
}

impl<D: DepthWidth> ActiveEdge<D> {
    pub(super) const EMPTY: Self = Self {
        upper: 0,
        lower: 0,
        slope: 0,
        first: 0,
        last: 0,
        face: 0,
        flags: 0,
        depth: D::FARTHEST,
    };

    const SHIFT: u16 = 31;
    const NUMBER: u32 = 5;
    const GOES_UP: u16 = 1 << 7;
    const IS_ADDED: u16 = 1 << 8;
    const IS_DRAWN: u16 = 1 << 9;
    const IS_LONG: u16 = 1 << 10;
    const IS_LARGE: u16 = 1 << 11;

    /// What x may be too small by, in 1/8192 pixel: half of what coverage may be off by.
    const ROUNDED: i32 = X_ONE / 256;

    /// The edge of that number of a face, clockwise, or the other way round where it is reversed, in rows that begin at a
    /// column. One that is not drawn counts in the number of surfaces alone.
    #[inline(always)]
    pub(crate) fn new<S: ScreenPrecision>(
        [from, to]: [&ScreenVertex<S, D>; 2],
        (face, number): (u16, u32),
        [is_reversed, is_drawn]: [bool; 2],
        left: i32,
    ) -> Self {
        let goes_up = to.y_units() < from.y_units();
        let [upper, lower] = if goes_up { [to, from] } else { [from, to] };
        // The left side of a pixel is half a pixel left of its centre.
        let left = left * X_ONE - X_ONE / 2;
        let x = |vertex: &ScreenVertex<S, D>| (vertex.x_units() << (X_BITS - S::FRACTION_BITS)) - left;
        let (width, height) = (lower.x_units() - upper.x_units(), lower.y_units() - upper.y_units());
        let shift = leading_zeros(width.unsigned_abs() | 1) - 2;
        let shifted = width << shift;
        // An x has at most 22 bits, so that the shift is not negative.
        let shift = shift + S::FRACTION_BITS - X_BITS;
        // The slope is rounded once, and the product with at most the height.
        let is_large = height >> shift >= Self::ROUNDED - 1;
        let (slope, shift) = if is_large {
            slope_of_large(shifted, height, shift)
        } else {
            (divide_floor_large(shifted, height).0, shift)
        };
        let flag = |is_set: bool, flag: u16| if is_set { flag } else { 0 };
        let flags = shift as u16
            | (number << Self::NUMBER) as u16
            | flag(goes_up, Self::GOES_UP)
            | flag(goes_up != is_reversed, Self::IS_ADDED)
            | flag(is_drawn, Self::IS_DRAWN)
            | flag(height.max(width.abs()) > SHORT << S::FRACTION_BITS, Self::IS_LONG)
            | flag(is_large, Self::IS_LARGE);
        Self {
            upper: x(upper),
            lower: x(lower),
            slope,
            first: upper.y_units(),
            last: lower.y_units(),
            face,
            flags,
            depth: D::from_units((upper.z.units() + lower.z.units()) >> 1),
        }
    }

    /// Overwrites another edge with this one.
    // A function of its own, for which the compiler knows that the two do not overlap: else it would call `memmove`.
    #[inline(never)]
    pub(super) fn move_to(&self, other: &mut Self) {
        *other = *self;
    }

    /// y of the upper and of the lower end of the part between two y.
    #[inline(always)]
    pub(super) fn part(&self, [top, bottom]: [i32; 2]) -> [i32; 2] {
        [self.first.max(top), self.last.min(bottom)]
    }

    /// y of the lower end.
    #[inline(always)]
    pub(super) fn last(&self) -> i32 {
        self.last
    }

    /// The left and the right end of the part of the edge between two y, in 1/8192 pixel from the left side of the row.
    #[inline(always)]
    pub(super) fn ends(&self, [start, end]: [i32; 2]) -> [i32; 2] {
        let shift = self.flags & Self::SHIFT;
        // All large edges are long: where an edge is known to be short, this needs no look.
        let is_large = self.is_long() && self.flags & Self::IS_LARGE != 0;
        let at = |y: i32| {
            let part = y - self.first;
            let columns = if is_large {
                multiply_shift(self.slope, part, shift.into())
            } else {
                (self.slope * part) >> shift
            };
            self.upper + columns
        };
        let (start, end) = (at(start), if end < self.last { at(end) } else { self.lower });
        [start.min(end), start.max(end)]
    }

    /// 1 where the surface lies right of the edge, -1 where it lies left of it.
    #[inline(always)]
    pub(super) fn sign(&self) -> i32 {
        i32::from(self.flags / Self::IS_ADDED % 2) * 2 - 1
    }

    /// Whether the edge is drawn.
    #[inline(always)]
    pub(super) fn is_drawn(&self) -> bool {
        self.flags & Self::IS_DRAWN != 0
    }

    /// Whether the depth differs along the edge: it is longer than 16 pixels.
    #[inline(always)]
    pub(super) fn is_long(&self) -> bool {
        self.flags & Self::IS_LONG != 0
    }

    /// Whether the edge goes up in the order of its face.
    pub(super) fn goes_up(&self) -> bool {
        self.flags & Self::GOES_UP != 0
    }

    /// The depth of the middle of the edge.
    #[inline(always)]
    pub(super) fn depth(&self) -> D {
        self.depth
    }

    /// The face of the edge.
    #[inline(always)]
    pub(crate) fn face(&self) -> u16 {
        self.face
    }

    /// The two corners of its face that are its ends, in the order of the face.
    pub(super) fn corners_of<T>(&self, [a, b, c]: [T; 3]) -> [T; 2] {
        match u32::from(self.flags) >> Self::NUMBER & 3 {
            0 => [a, b],
            1 => [b, c],
            _ => [c, a],
        }
    }
}

/// The slope of a large edge and its shift, from the shifted width and its shift: shifted on by as many bits as the height has,
/// the slope is as precise as its 32 bits allow.
#[cold]
#[inline(never)]
fn slope_of_large(width: i32, height: i32, shift: u32) -> (i32, u32) {
    let most = 31 - leading_zeros(height.unsigned_abs() | 1);
    let more = most.min(u32::from(ActiveEdge::<u16>::SHIFT) - shift);
    let (slope, _) = divide_long(i64::from(width) << more, height);
    (slope, shift + more)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Sub4, Sub8};

    /// Compares x in rows of an edge, from its upper end to its lower one, with the exact x.
    fn check<S: ScreenPrecision>([width, height]: [i32; 2]) {
        let corner = |[x, y]: [i32; 2]| ScreenVertex::<S, u16> {
            x: S::narrow(x),
            y: S::narrow(y),
            z: 0,
        };
        let upper = [S::MIN_UNITS + (-width).max(0), S::MIN_UNITS];
        let lower = [upper[0] + width, upper[1] + height];
        let corners = [upper, lower].map(corner);
        let edge = ActiveEdge::new::<S>([&corners[0], &corners[1]], (0, 0), [false, true], 0);
        let column = |y: i32| {
            let units = f64::from(upper[0]) + f64::from(width) * f64::from(y - upper[1]) / f64::from(height);
            (units / f64::from(1 << S::FRACTION_BITS) + 0.5) * f64::from(X_ONE)
        };
        for row in 0..64 {
            let start = upper[1] + (i64::from(height) * row / 64) as i32;
            let rows = [start, (start + (1 << S::FRACTION_BITS)).min(lower[1])];
            let mut expected = rows.map(column);
            expected.sort_by(f64::total_cmp);
            for (found, expected) in edge.ends(rows).into_iter().zip(expected) {
                let off = expected - f64::from(found);
                let most = f64::from(X_ONE) / 256.0;
                assert!(
                    (-0.001..=most).contains(&off),
                    "{width} x {height}, rows {rows:?}: off by {off}"
                );
            }
        }
    }

    /// From a unit to the whole domain, in both directions.
    #[test]
    fn x_is_exact_to_a_256th_of_a_pixel() {
        fn check_all<S: ScreenPrecision>() {
            let lengths = || {
                let powers = (0..24)
                    .map(|bit| 1 << bit)
                    .flat_map(|power| [power - 1, power, power / 8 * 11 + 1]);
                let most = S::MAX_UNITS - S::MIN_UNITS;
                powers.filter(move |length| *length < most).chain([most])
            };
            for width in lengths() {
                for height in lengths().filter(|height| *height > 0) {
                    check::<S>([width, height]);
                    check::<S>([-width, height]);
                }
            }
        }
        check_all::<Sub4>();
        check_all::<Sub8>();
    }
}
