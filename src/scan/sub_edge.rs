//! An edge with sub-pixel ends, cut into one segment a row of pixels: what the antialiasing tiers measure.
//!
//! Promises: where an edge passes from row to row it is the exact position rounded to 1/256 pixel, by quotient and
//! remainder; both neighbours of an edge compute the same integers, because it is ordered top to bottom first. Its ends
//! are exact.
//!
//! Units are 1/256 pixel from the corner of a pixel, not from its centre: pixel `x` lies from `256 x` to `256 (x + 1)`.

use crate::geometry::{Sub8, SubPoint};

/// Units of a pixel.
pub const UNIT: i32 = 256;

/// An edge from its top to its bottom.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SubEdge {
    top: [i32; 2],
    bottom: [i32; 2],
    /// What crossing it from left to right adds to the winding number.
    winding: i32,
}

/// The part of an edge that lies in one row of pixels.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RowSegment {
    /// Column at its top, in units.
    pub x_top: i32,
    /// Column at its bottom.
    pub x_bottom: i32,
    /// Units from the top of the row, from 0; above `y_bottom`.
    pub y_top: i32,
    /// Units from the top of the row, up to 256.
    pub y_bottom: i32,
    /// What crossing it from left to right adds to the winding number: 1 or -1.
    pub winding: i32,
    /// For the tier: where it is at the ordinate in question. A tier may also put the segments into another order.
    pub place: i32,
    /// For the tier, as `place`.
    pub end_place: i32,
}

/// An edge that crosses the current row, and where.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ActiveSubEdge {
    edge: SubEdge,
    /// Where it enters the row, rounded to the nearest, and what that leaves over in units / `height`, with the half that
    /// rounds.
    x: i32,
    rest: i32,
    /// From row to row.
    step: i32,
    rest_step: i32,
}

impl SubEdge {
    /// The edge between two points; `None` where it is level.
    pub fn new(from: &SubPoint<Sub8>, to: &SubPoint<Sub8>) -> Option<Self> {
        let units = |point: &SubPoint<Sub8>| [point.x_units(), point.y_units()];
        Self::from_units(units(from), units(to))
    }

    /// The same, in units from the centre of pixel (0, 0), in the domain of [`Sub8`].
    pub(crate) fn from_units(from: [i32; 2], to: [i32; 2]) -> Option<Self> {
        // From centres to corners. The domain leaves room.
        let corner = |[x, y]: [i32; 2]| [x.wrapping_add(UNIT / 2), y.wrapping_add(UNIT / 2)];
        let (from, to) = (corner(from), corner(to));
        if from[1] == to[1] {
            return None;
        }
        let downwards = from[1] < to[1];
        let (top, bottom) = if downwards { (from, to) } else { (to, from) };
        Some(Self {
            top,
            bottom,
            winding: if downwards { 1 } else { -1 },
        })
    }

    /// An edge that is level, which crosses nothing and so is in no table; `None` for any other.
    pub(crate) fn level(from: [i32; 2], to: [i32; 2]) -> Option<Self> {
        let corner = |[x, y]: [i32; 2]| [x.wrapping_add(UNIT / 2), y.wrapping_add(UNIT / 2)];
        (from[1] == to[1]).then(|| Self {
            top: corner(from),
            bottom: corner(to),
            winding: 0,
        })
    }

    /// Its top and its bottom.
    pub(crate) fn ends(&self) -> [[i32; 2]; 2] {
        [self.top, self.bottom]
    }

    /// Whether it runs down along a boundary between pixels, and from boundary to boundary.
    pub(crate) fn is_aligned(&self) -> bool {
        let ([left, top], [right, bottom]) = (self.top, self.bottom);
        left == right && (left | top | bottom) & (UNIT - 1) == 0
    }

    /// Whether two edges have a point in common that is not an end of both: exact, by orientations in 64 bits.
    pub(crate) fn touches(&self, other: &Self) -> bool {
        let side = |edge: &Self, [x, y]: [i32; 2]| {
            let [width, height] = edge.size();
            let (x, y) = (x.wrapping_sub(edge.top[0]), y.wrapping_sub(edge.top[1]));
            (i64::from(width) * i64::from(y) - i64::from(height) * i64::from(x)).signum()
        };
        if self.bottom[1] < other.top[1] || other.bottom[1] < self.top[1] {
            return false;
        }
        let ends = [self.top, self.bottom];
        let shared = ends
            .iter()
            .filter(|end| [other.top, other.bottom].contains(end))
            .count();
        let (a, b) = (side(self, other.top), side(self, other.bottom));
        let (c, d) = (side(other, self.top), side(other, self.bottom));
        match shared {
            0 => a != b && c != d && a.wrapping_mul(b) <= 0 && c.wrapping_mul(d) <= 0 || (a | b | c | d) == 0,
            // One common end: they meet elsewhere only where they run along the same line, the same way.
            1 => (a | b) == 0 && self.top != other.bottom && self.bottom != other.top,
            _ => true,
        }
    }

    /// First row of pixels that it lies in.
    #[inline(always)]
    pub fn first_row(&self) -> i32 {
        self.top[1] >> 8
    }

    /// The row after the last one that it lies in.
    #[inline(always)]
    pub fn end_row(&self) -> i32 {
        self.bottom[1].wrapping_add(UNIT - 1) >> 8
    }

    #[inline(always)]
    fn size(&self) -> [i32; 2] {
        [
            self.bottom[0].wrapping_sub(self.top[0]),
            self.bottom[1].wrapping_sub(self.top[1]),
        ]
    }

    /// The edge as it enters a row from its first one on. Cost: up to two divisions.
    pub fn begin(&self, row: i32) -> ActiveSubEdge {
        let [width, height] = self.size();
        let mut active = ActiveSubEdge {
            edge: *self,
            x: self.top[0],
            rest: height >> 1,
            step: 0,
            rest_step: 0,
        };
        if self.end_row() > row.wrapping_add(1) {
            // Widths are below 2^22 units.
            (active.step, active.rest_step) = divide_floor(width.wrapping_mul(UNIT), height);
        }
        let down = row.wrapping_mul(UNIT).wrapping_sub(self.top[1]);
        if down > 0 {
            let (x, rest) = divide_floor_long(i64::from(width) * i64::from(down) + i64::from(height >> 1), height);
            (active.x, active.rest) = (active.x.wrapping_add(x), rest);
        }
        active
    }
}

impl ActiveSubEdge {
    /// The row after its last one.
    #[inline(always)]
    pub fn end_row(&self) -> i32 {
        self.edge.end_row()
    }

    /// Its part in a row, and goes on to the next one.
    #[inline(always)]
    pub fn next_segment(&mut self, row: i32) -> RowSegment {
        let row_top = row.wrapping_mul(UNIT);
        let above = self.edge.top[1].wrapping_sub(row_top);
        let left_over = self.edge.bottom[1].wrapping_sub(row_top);
        let (x_top, y_top) = (self.x, above.max(0));
        if left_over <= UNIT {
            self.x = self.edge.bottom[0];
        } else if above > 0 {
            self.leave_first_row(UNIT.wrapping_sub(above));
        } else {
            self.x = self.x.wrapping_add(self.step);
            self.rest = self.rest.wrapping_add(self.rest_step);
            let height = self.edge.size()[1];
            if self.rest >= height {
                self.rest = self.rest.wrapping_sub(height);
                self.x = self.x.wrapping_add(1);
            }
        }
        RowSegment {
            x_top,
            x_bottom: self.x,
            y_top,
            y_bottom: left_over.min(UNIT),
            winding: self.edge.winding,
            place: 0,
            end_place: 0,
        }
    }

    /// From its top to the bottom of that row.
    #[inline(never)]
    fn leave_first_row(&mut self, down: i32) {
        let [width, height] = self.edge.size();
        // Below 2^22 times 2^8.
        let (x, rest) = divide_floor(width.wrapping_mul(down).wrapping_add(height >> 1), height);
        (self.x, self.rest) = (self.x.wrapping_add(x), rest);
    }
}

impl RowSegment {
    /// Where it is at an ordinate of the row within its own, rounded to the nearest.
    #[inline(always)]
    pub fn x_at(&self, y: i32) -> i32 {
        let (width, height) = (
            self.x_bottom.wrapping_sub(self.x_top),
            self.y_bottom.wrapping_sub(self.y_top),
        );
        // Below 2^22 times 2^8.
        let product = width.wrapping_mul(y.wrapping_sub(self.y_top)).wrapping_add(height >> 1);
        let x = if height == UNIT {
            product >> 8
        } else {
            divide_floor(product, height).0
        };
        self.x_top.wrapping_add(x)
    }
}

/// Quotient rounded down, and remainder; some numbers for a denominator of 0. The denominator is not negative.
#[inline(always)]
fn divide_floor(numerator: i32, denominator: i32) -> (i32, i32) {
    let quotient = numerator.checked_div(denominator).unwrap_or(0);
    let rest = numerator.wrapping_sub(quotient.wrapping_mul(denominator));
    if rest < 0 {
        (quotient.wrapping_sub(1), rest.wrapping_add(denominator))
    } else {
        (quotient, rest)
    }
}

/// The same for a product that may need more than 32 bits; the quotient is below the width of an edge.
fn divide_floor_long(numerator: i64, denominator: i32) -> (i32, i32) {
    match i32::try_from(numerator) {
        Ok(numerator) => divide_floor(numerator, denominator),
        Err(_) => crate::geometry::divide_long(numerator, denominator.max(1)),
    }
}
