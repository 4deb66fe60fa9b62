//! An edge with sub-pixel ends, cut into one segment a row of pixels: what the antialiasing tiers measure.
//!
//! Guarantees: where an edge passes from row to row it is the exact position rounded to 1/8192 pixel, by quotient and
//! remainder; both neighbours of an edge compute the same integers, because it is ordered top to bottom first. Its ends
//! are exact.
//!
//! Units are 1/256 pixel from the corner of a pixel, not from its centre: pixel `x` lies from `256 x` to `256 (x + 1)`.
//! The columns of a segment are in fine units, 1/8192 pixel: with those of its ends, rounding them would be as large an
//! error of an area as rounding it to 1/255 is.

use crate::geometry::{Sub8, SubPoint, divide_floor_large, divide_long};

/// The place of an edge in its table.
pub(crate) type Place = u32;

/// The place of no edge.
pub(crate) const NONE: Place = u32::MAX >> 4;

/// Units of a pixel.
pub const UNIT: i32 = 256;

/// Fine units of a pixel: the columns of a [`RowSegment`].
pub const FINE: i32 = 1 << FINE_BITS;
/// The bits of a place within a pixel, in fine units.
pub const FINE_BITS: u32 = 13;
/// The bits of a height below a unit: so that what a piece is cut into adds up.
pub(crate) const HEIGHT_BITS: u32 = 6;
/// Fine units of a unit.
const FINE_PER_UNIT: i32 = FINE / UNIT;

/// The bits of a winding number.
const WINDING_BITS: u32 = 3;
/// The bit that says whether an edge goes on below.
const GOES_ON: u32 = 4;
/// The bit that says whether one is above it.
const IS_BELOW: u32 = 8;
/// The place of the next chain is above them.
const NEXT_SHIFT: u32 = 4;

/// An edge from its top to its bottom.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SubEdge {
    top: [i32; 2],
    bottom: [i32; 2],
    /// What crossing it from left to right adds to the winding number, in the lowest bits; whether edges of its chain are
    /// below and above it; above these bits where the next chain is.
    winding_and_next: u32,
}

/// The part of an edge that lies in the current row of pixels, and how it goes on.
///
/// Columns are in fine units, 1/8192 pixel, from the left side of pixel 0; ordinates in units, 1/256 pixel, from the top of
/// the row. Only [`SubEdge`] makes segments, so that their numbers are those of an edge.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RowSegment {
    /// Column at its top, in fine units.
    pub(crate) x_top: i32,
    /// Column at its bottom.
    pub(crate) x_bottom: i32,
    /// Units from the top of the row, from 0; above `y_bottom`.
    pub(crate) y_top: i32,
    /// Units from the top of the row, up to 256.
    pub(crate) y_bottom: i32,
    /// What crossing it from left to right adds to the winding number: 1 or -1.
    pub(crate) winding: i32,
    /// For the tier: where it is at the ordinate in question. A tier may also put the segments into another order.
    pub(crate) place: i32,
    /// For the tier, as `place`.
    pub(crate) end_place: i32,
    /// Left and right end, and the height with the sign of the winding, in 1/64 unit: asked for more often than they
    /// change.
    left: i32,
    right: i32,
    signed_height: i32,
    /// What the rounding of `x_bottom` leaves over in fine units / `height`, with the half that rounds, less `height`.
    rest: i32,
    /// From row to row, where one is carried.
    step: i32,
    rest_step: i32,
    /// Height of the whole edge, in 1/256 pixel.
    height: i32,
    /// The edge's index in its table, and where it ends, in 1/256 pixel. (One field, so that it comes first, out of the way
    /// of what changes from row to row.)
    edge: (Place, i32),
}

impl SubEdge {
    /// The edge between two points; `None` where it is level.
    pub fn new(from: &SubPoint<Sub8>, to: &SubPoint<Sub8>) -> Option<Self> {
        let units = |point: &SubPoint<Sub8>| [point.x_units(), point.y_units()];
        Self::from_units(units(from), units(to))
    }

    /// The edge between two points (x, y) in 1/256 pixel from the centre of pixel (0, 0), in the domain of [`Sub8`]; `None`
    /// where it is level.
    pub(crate) fn from_units(from: [i32; 2], to: [i32; 2]) -> Option<Self> {
        if from[1] == to[1] {
            return None;
        }
        let downwards = from[1] < to[1];
        let (top, bottom) = if downwards { (from, to) } else { (to, from) };
        Some(Self {
            top: from_corner(top),
            bottom: from_corner(bottom),
            winding_and_next: if downwards { 1 } else { WINDING_BITS },
        })
    }

    /// An edge that is level, which crosses nothing and so is in no table; `None` for any other.
    pub(crate) fn level(from: [i32; 2], to: [i32; 2]) -> Option<Self> {
        (from[1] == to[1]).then(|| Self {
            top: from_corner(from),
            bottom: from_corner(to),
            winding_and_next: 0,
        })
    }

    /// What crossing it from left to right adds to the winding number: 1 where the outline goes down, or else -1.
    #[inline(always)]
    pub(crate) fn winding(&self) -> i32 {
        let unused_bits = WINDING_BITS.leading_zeros();
        (self.winding_and_next << unused_bits) as i32 >> unused_bits
    }

    /// Where the first edge of the next chain is.
    #[inline(always)]
    pub(crate) fn next_chain(&self) -> Place {
        self.winding_and_next >> NEXT_SHIFT
    }

    pub(crate) fn set_next_chain(&mut self, next: Place) {
        let others = self.winding_and_next & (WINDING_BITS | GOES_ON | IS_BELOW);
        self.winding_and_next = next << NEXT_SHIFT | others;
    }

    /// Whether no edge of its chain is below it.
    #[inline(always)]
    pub(crate) fn is_last(&self) -> bool {
        self.winding_and_next & GOES_ON == 0
    }

    /// Whether no edge of its chain is above it.
    #[inline(always)]
    pub(crate) fn is_first(&self) -> bool {
        self.winding_and_next & IS_BELOW == 0
    }

    /// Joins this edge with the next one in the outline: where both go down, or both up, and meet, they are in one chain.
    #[inline(always)]
    pub(crate) fn join(&mut self, next: &mut Self) {
        if (self.winding_and_next ^ next.winding_and_next) & WINDING_BITS != 0 {
            return;
        }
        let (above, below) = if self.winding() > 0 { (self, next) } else { (next, self) };
        if above.bottom[0] == below.top[0] && above.bottom[1] == below.top[1] {
            above.winding_and_next |= GOES_ON;
            below.winding_and_next |= IS_BELOW;
        }
    }

    /// The edge's top and its bottom (x, y).
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

    /// The columns of its top and its bottom, in fine units.
    #[inline(always)]
    pub(crate) fn columns(&self) -> [i32; 2] {
        [self.top[0], self.bottom[0]].map(fine)
    }

    #[inline(always)]
    fn size(&self) -> [i32; 2] {
        [
            self.bottom[0].wrapping_sub(self.top[0]),
            self.bottom[1].wrapping_sub(self.top[1]),
        ]
    }

    /// The part of the edge in a row, from its first row on. Cost: up to two divisions.
    pub fn begin(&self, row: i32) -> RowSegment {
        self.begin_at(NONE, row)
    }

    /// The part of the edge in a row, from its first row on; the segment remembers the edge's index in its table.
    pub(crate) fn begin_at(&self, place_in_table: Place, row: i32) -> RowSegment {
        let [width, height] = self.size();
        let row_top = row.wrapping_mul(UNIT);
        let above = self.top[1].wrapping_sub(row_top);
        let mut segment = RowSegment {
            x_bottom: fine(self.top[0]),
            y_top: above.max(0),
            y_bottom: UNIT,
            winding: self.winding(),
            rest: (height >> 1).wrapping_sub(height),
            height,
            edge: (place_in_table, self.bottom[1]),
            ..RowSegment::default()
        };
        // Below its first row, if its end is not there.
        let first_step = if above > 0 { 2 } else { 1 };
        if self.end_row() > row.wrapping_add(first_step) {
            // Widths are below 2^22 units.
            (segment.step, segment.rest_step) = divide_finely(width.wrapping_mul(UNIT), height);
        }
        if above < 0 {
            let numerator = i64::from(width) * -i64::from(above);
            segment.go_on(divide_finely_long(numerator, height));
        }
        segment.x_top = segment.x_bottom;
        if self.bottom[1].wrapping_sub(row_top) <= UNIT {
            segment.end(row, self.bottom[0]);
        } else if above > 0 {
            // From its top to the bottom of the row: below 2^22 times 2^8.
            let numerator = width.wrapping_mul(UNIT.wrapping_sub(above));
            segment.go_on(divide_finely(numerator, height));
        } else {
            segment.step();
        }
        segment.measure();
        segment
    }
}

impl RowSegment {
    /// Column and ordinate at its top: from 0, and above those of its bottom.
    pub const fn top(&self) -> (i32, i32) {
        (self.x_top, self.y_top)
    }

    /// Column and ordinate at its bottom: up to 256.
    pub const fn bottom(&self) -> (i32, i32) {
        (self.x_bottom, self.y_bottom)
    }

    /// What crossing it from left to right adds to the winding number: 1 or -1.
    pub const fn winding(&self) -> i32 {
        self.winding
    }

    /// Goes on to the next row, which is none of its edge's ends.
    #[inline(always)]
    pub fn step(&mut self) {
        self.x_top = self.x_bottom;
        let width = self.step.wrapping_add(self.carry(self.rest_step));
        self.x_bottom = self.x_top.wrapping_add(width);
        let to_left = width.min(0);
        self.left = self.x_top.wrapping_add(to_left);
        self.right = self.x_bottom.wrapping_sub(to_left);
    }

    /// Goes on to any row after its first one, if its edge, which ends at `bottom_x`, has not ended before.
    #[inline(always)]
    pub(crate) fn advance(&mut self, row: i32, bottom_x: i32) {
        self.y_top = 0;
        if self.last_row() > row {
            self.step();
        } else {
            self.x_top = self.x_bottom;
            self.end(row, bottom_x);
        }
        self.measure();
    }

    fn measure(&mut self) {
        (self.left, self.right) = in_order(self.x_top, self.x_bottom);
        let height = self.y_bottom.wrapping_sub(self.y_top) << HEIGHT_BITS;
        self.signed_height = height.wrapping_mul(self.winding);
    }

    /// Where its edge ends.
    #[inline(always)]
    pub fn last_row(&self) -> i32 {
        self.edge.1.wrapping_sub(1) >> 8
    }

    /// In the row where the edge ends.
    #[inline(always)]
    fn end(&mut self, row: i32, bottom_x: i32) {
        self.x_bottom = fine(bottom_x);
        self.y_bottom = self.edge.1.wrapping_sub(row.wrapping_mul(UNIT));
    }

    /// Goes on by so many fine units, less one, and so many times 1 / `height` of one.
    #[inline(always)]
    fn go_on(&mut self, (width, rest): (i32, i32)) {
        let carried = self.carry(rest);
        self.x_bottom = self.x_bottom.wrapping_add(width).wrapping_add(carried);
    }

    /// Adds to the rest: -1 where nothing is carried, or else 0. All ones are cheaper than to branch.
    #[inline(always)]
    fn carry(&mut self, rest: i32) -> i32 {
        let rest = self.rest.wrapping_add(rest);
        let keeps = rest >> 31;
        self.rest = rest.wrapping_sub(self.height & !keeps);
        keeps
    }

    /// The index of the segment's edge in its table.
    #[inline(always)]
    pub(crate) fn place_in_table(&self) -> Place {
        self.edge.0
    }

    /// A segment of no height before the first edge of a chain.
    #[inline(always)]
    pub(crate) fn before(edge: &SubEdge) -> Self {
        Self {
            winding: edge.winding(),
            ..Self::default()
        }
    }

    /// Waits for the edge below one that ends at the bottom of a row, at `end_y`.
    #[inline(always)]
    pub(crate) fn wait_below(&mut self, place_in_table: Place, end_y: i32) {
        self.edge = (place_in_table, end_y);
    }

    /// Goes on to the bottom of the next row, which its edge does not end in.
    #[inline(always)]
    pub(crate) fn fall(&mut self) -> (i32, i32) {
        let x_top = self.x_bottom;
        self.go_on((self.step, self.rest_step));
        (x_top, self.x_bottom)
    }

    /// Begins with an edge that begins so many units above the bottom of a row and goes on below: where it is there.
    /// Nothing but what [`fall`](Self::fall) needs is right.
    #[inline(always)]
    pub(crate) fn fall_along(&mut self, place_in_table: Place, edge: &SubEdge, above: i32) -> (i32, i32) {
        let ([width, height], x_top) = (edge.size(), fine(edge.top[0]));
        self.x_bottom = x_top;
        self.rest = (height >> 1).wrapping_sub(height);
        self.height = height;
        // Widths are below 2^22 units.
        self.go_on(divide_finely(width.wrapping_mul(above), height));
        self.edge = (place_in_table, edge.bottom[1]);
        if height.wrapping_sub(above) > UNIT {
            (self.step, self.rest_step) = divide_finely(width.wrapping_mul(UNIT), height);
        }
        (x_top, self.x_bottom)
    }

    /// Where it is at the bottom of the row that it has come to, in fine units.
    #[inline(always)]
    pub(crate) fn bottom_x(&self) -> i32 {
        self.x_bottom
    }

    /// Where its edge ends, in units.
    #[inline(always)]
    pub(crate) fn end_y(&self) -> i32 {
        self.edge.1
    }

    /// Left and right end, in fine units.
    #[inline(always)]
    pub fn ends(&self) -> (i32, i32) {
        (self.left, self.right)
    }

    /// The segment's height times its winding number, in 1/64 of 1/256 pixel.
    #[inline(always)]
    pub fn signed_height(&self) -> i32 {
        self.signed_height
    }

    /// Where it is at an ordinate of the row within its own, in fine units, rounded to the nearest.
    #[inline(always)]
    pub fn x_at(&self, y: i32) -> i32 {
        let (width, height) = (
            self.x_bottom.wrapping_sub(self.x_top),
            self.y_bottom.wrapping_sub(self.y_top),
        );
        let part = y.wrapping_sub(self.y_top);
        let x = if height == UNIT {
            // Below 2^27 times 2^8: in two products.
            let (pixels, rest) = (width >> FINE_BITS, width & (FINE - 1));
            let rest = rest.wrapping_mul(part).wrapping_add(UNIT / 2) >> 8;
            (pixels.wrapping_mul(part) << (FINE_BITS - 8)).wrapping_add(rest)
        } else {
            part_of_width(width, part, height)
        };
        self.x_top.wrapping_add(x)
    }
}

/// A point that is given from the centre of a pixel. The domain leaves room.
fn from_corner([x, y]: [i32; 2]) -> [i32; 2] {
    [x.wrapping_add(UNIT / 2), y.wrapping_add(UNIT / 2)]
}

/// 1/256 pixel as 1/8192 pixel.
#[inline(always)]
pub(crate) fn fine(units: i32) -> i32 {
    units.wrapping_mul(FINE_PER_UNIT)
}

/// A product of units / height, in fine units, less one, from which a carry takes that away; and the remainder.
#[inline(never)]
fn divide_finely(product: i32, height: i32) -> (i32, i32) {
    let (quotient, rest) = if product.unsigned_abs() < 1 << 26 {
        divide_floor_large(fine(product), height)
    } else {
        divide_again(divide_floor_large(product, height), height)
    };
    (quotient.wrapping_add(1), rest)
}

/// From a quotient in units to one in fine units: the remainder, below 2^22, is divided again.
#[inline(always)]
fn divide_again((units, rest): (i32, i32), height: i32) -> (i32, i32) {
    let (below, rest) = divide_floor_large(fine(rest), height);
    (fine(units).wrapping_add(below), rest)
}

/// [`divide_finely`] for a product that may need more than 32 bits; the quotient is below the width of an edge.
fn divide_finely_long(product: i64, height: i32) -> (i32, i32) {
    match i32::try_from(product) {
        Ok(product) => divide_finely(product, height),
        Err(_) => {
            let (quotient, rest) = divide_again(divide_long(product, height.max(1)), height);
            (quotient.wrapping_add(1), rest)
        }
    }
}

/// width * part / height, rounded to the nearest, for a width below 2^27 fine units and a part of at most a pixel.
#[inline(never)]
fn part_of_width(width: i32, part: i32, height: i32) -> i32 {
    if width.unsigned_abs() < 1 << 22 {
        return divide_floor_large(width.wrapping_mul(part).wrapping_add(height >> 1), height).0;
    }
    let (pixels, rest) = (width >> FINE_BITS, width & (FINE - 1));
    let (quotient, left_over) = divide_floor_large(pixels.wrapping_mul(part), height);
    let product = rest.wrapping_mul(part).wrapping_add(left_over << FINE_BITS);
    let below = divide_floor_large(product.wrapping_add(height >> 1), height).0;
    (quotient << FINE_BITS).wrapping_add(below)
}

#[inline(always)]
fn in_order(one: i32, other: i32) -> (i32, i32) {
    if one <= other { (one, other) } else { (other, one) }
}
