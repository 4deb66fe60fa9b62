//! An edge of a silhouette that is active: it is set up in its first row, and passes through rows until it ends.

use crate::{
    coverage::{X_BITS, X_ONE},
    geometry::{divide_floor_large, leading_zeros},
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
};

/// Pixels up to which an edge is short, in height and in width.
const SHORT: i32 = 16;

// Not re-exported.
/// An active edge of a silhouette: one division where it is set up, two products a row.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ActiveEdge<D> {
    /// x of its upper and of its lower end in 1/8192 pixel, from the left side of the row.
    upper: i32,
    lower: i32,
    /// Columns a row, shifted by as many bits as fit: times a part of the height it is at most the width, shifted as far.
    slope: i32,
    /// y of its upper and of its lower end, in units of the look's precision.
    first: i32,
    last: i32,
    /// Its face.
    face: u16,
    /// Bits: by how much a product with the slope is shifted down, the number of the edge in its face, whether it goes up, is
    /// added, is drawn, is long, and is precise.
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
    const IS_PRECISE: u16 = 1 << 11;

    /// What the x of a precise edge may be too small by, in 1/8192 pixel.
    const ROUNDED: i32 = X_ONE / 64;

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
        let (slope, _) = divide_floor_large(width << shift, height);
        let flag = |is_set: bool, flag: u16| if is_set { flag } else { 0 };
        // An x has at most 22 bits, so that the shift is not negative.
        let shift = shift + S::FRACTION_BITS - X_BITS;
        let flags = shift as u16
            | (number << Self::NUMBER) as u16
            | flag(goes_up, Self::GOES_UP)
            | flag(goes_up != is_reversed, Self::IS_ADDED)
            | flag(is_drawn, Self::IS_DRAWN)
            | flag(height.max(width.abs()) > SHORT << S::FRACTION_BITS, Self::IS_LONG)
            | flag(height >> shift < Self::ROUNDED - 1, Self::IS_PRECISE);
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
        let at = |y: i32| self.upper + ((self.slope * (y - self.first)) >> shift);
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

    /// Whether x is known to 1/64 pixel all along the edge: it is not very long both in height and in width.
    #[inline(always)]
    pub(super) fn is_precise(&self) -> bool {
        self.flags & Self::IS_PRECISE != 0
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
