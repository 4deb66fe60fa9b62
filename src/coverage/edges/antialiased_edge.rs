//! An edge between two sub-pixel points, from its top to its bottom, and the segments that it is cut into, one for each
//! row of pixels.
//!
//! ```text
//!       top o                 An edge is ordered top to bottom before it is set up, whichever way the outline runs along
//!   ---------\------- row 0   it: the neighbours on both sides of an edge compute the same integers.
//!             \
//!   -----------\----- row 1   `begin` enters at any row, by one division: x at the row's top with the error term that
//!               \            stepping there from the first row would have left.
//!   -------------o--- row 2
//!             bottom
//! ```
//!
//! Guarantees: where an edge passes from row to row, x is the exact one rounded to 1/8192 pixel; the ends of the edge
//! are exact.
//!
//! Units are 1/256 pixel from the corner of a pixel, not from its centre: pixel `x` lies from `256 x` to `256 (x + 1)`.
//! The x of segments is finer, in 1/8192 pixel: rounded like the ends, it would bring as large an error into an area as
//! rounding the area to 1/255 does.

use core::ops::Range;

use crate::{
    coverage::edges::row_segment::{RowSegment, X_BITS, Y_BITS, Y_ONE},
    geometry::{divide_floor_large, divide_long},
};

/// The index that stands for no edge.
pub(crate) const NO_EDGE: u32 = u32::MAX >> 3;

/// Shift from 1/256 pixel to 1/8192 pixel.
const X_SHIFT: u32 = X_BITS - Y_BITS;

/// The bits of a winding number in an edge's flags.
const WINDING_BITS: u32 = 3;
/// The winding number 1, of an edge that the outline runs down along.
const DOWNWARDS: u32 = 1;
/// The winding number -1, of an edge that the outline runs up along.
const UPWARDS: u32 = 3;
/// The flag of an edge that has a successor: the next edge of its y-monotone chain, which begins where it ends.
const HAS_SUCCESSOR: u32 = 4;
/// A number lies above the flags: in the first edge of a chain the index of the next chain's first edge, in the second
/// one how many edges of its chain are below it; before the chains are linked, in the edge with which a chain begins in
/// the table, how many edges the chain has.
const NUMBER_SHIFT: u32 = 3;

/// An edge from its top to its bottom, with its links in a table of edges.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AntialiasedEdge {
    /// (x, y) of the upper end, in 1/256 pixel.
    top: [i32; 2],
    /// (x, y) of the lower end, in 1/256 pixel.
    bottom: [i32; 2],
    /// In the lowest two bits what crossing the edge from left to right adds to the winding number; whether the edge
    /// has a successor in its chain; above these bits a number for the search along chains.
    flags_and_number: u32,
}

impl AntialiasedEdge {
    /// The edge between two points; `None` where they are at the same height.
    #[cfg(test)]
    pub fn new(
        from: &crate::geometry::SubPoint<crate::geometry::Sub8>,
        to: &crate::geometry::SubPoint<crate::geometry::Sub8>,
    ) -> Option<Self> {
        let units = |point: &crate::geometry::SubPoint<_>| [point.x_units(), point.y_units()];
        Self::from_units(units(from), units(to))
    }

    /// The edge between two points (x, y) in 1/256 pixel from the centre of pixel (0, 0), in the domain of [`Sub8`];
    /// `None` where it is level.
    pub(crate) fn from_units(from: [i32; 2], to: [i32; 2]) -> Option<Self> {
        if from[1] == to[1] {
            return None;
        }
        let downwards = from[1] < to[1];
        let (top, bottom) = if downwards { (from, to) } else { (to, from) };
        Some(Self {
            top: from_corner(top),
            bottom: from_corner(bottom),
            flags_and_number: if downwards { DOWNWARDS } else { UPWARDS },
        })
    }

    /// The edge between a top in 1/256 pixel from the corner of pixel (0, 0), and a bottom, further down, from the centre of
    /// that pixel.
    #[inline]
    pub(crate) fn below(top: [i32; 2], bottom: [i32; 2], runs_up: bool) -> Self {
        Self {
            top,
            bottom: from_corner(bottom),
            flags_and_number: if runs_up { UPWARDS } else { DOWNWARDS },
        }
    }

    /// An edge that is level, which crosses nothing and so is in no table; `None` for any other.
    pub(crate) fn level(from: [i32; 2], to: [i32; 2]) -> Option<Self> {
        (from[1] == to[1]).then(|| Self {
            top: from_corner(from),
            bottom: from_corner(to),
            flags_and_number: 0,
        })
    }

    /// Whether the edge has no height: it crosses nothing.
    #[inline]
    pub(crate) fn is_level(&self) -> bool {
        self.top[1] == self.bottom[1]
    }

    /// What crossing the edge from left to right adds to the winding number: 1 where the outline goes down, or else -1.
    #[inline]
    pub(crate) fn winding(&self) -> i32 {
        let unused_bits = WINDING_BITS.leading_zeros();
        (self.flags_and_number << unused_bits) as i32 >> unused_bits
    }

    /// In the first edge of a chain, the index of the next chain's first edge.
    #[inline]
    pub(crate) fn next_chain(&self) -> u32 {
        self.flags_and_number >> NUMBER_SHIFT
    }

    /// Sets the index of the next chain's first edge in the first edge of a chain.
    pub(crate) fn set_next_chain(&mut self, next: u32) {
        self.set_number(next);
    }

    /// In the edge with which a chain begins in the table, how many edges the chain has; only until the chains are
    /// linked.
    #[inline]
    pub(crate) fn count(&self) -> u32 {
        self.flags_and_number >> NUMBER_SHIFT
    }

    /// Sets how many edges the chain has that begins in the table with this one.
    pub(crate) fn set_count(&mut self, edges: u32) {
        self.set_number(edges);
    }

    /// In the second edge of a chain, how many edges of the chain are below it.
    #[inline]
    pub(crate) fn edges_below(&self) -> u32 {
        self.flags_and_number >> NUMBER_SHIFT
    }

    /// Sets how many edges of the chain are below its second edge.
    pub(crate) fn set_edges_below(&mut self, edges: u32) {
        self.set_number(edges);
    }

    fn set_number(&mut self, number: u32) {
        let flags = self.flags_and_number & (WINDING_BITS | HAS_SUCCESSOR);
        self.flags_and_number = number << NUMBER_SHIFT | flags;
    }

    /// Whether the edge is the lowest of its y-monotone chain: it has no successor.
    #[inline]
    pub(crate) fn is_last(&self) -> bool {
        self.flags_and_number & HAS_SUCCESSOR == 0
    }

    /// The edge that follows this one in the outline, between two points as for [`from_units`](Self::from_units), if both
    /// are in one y-monotone chain: they go down, or both up, and meet. The lower one is the successor of the upper one
    /// then. Cheaper than `from_units`, because the direction is known.
    #[inline]
    pub(crate) fn continued(&mut self, from: [i32; 2], to: [i32; 2]) -> Option<Self> {
        let ([x, y], to) = (from_corner(from), from_corner(to));
        if self.winding() > 0 {
            if self.bottom[0] != x || self.bottom[1] != y || to[1] <= y {
                return None;
            }
            self.flags_and_number |= HAS_SUCCESSOR;
            Some(Self {
                top: [x, y],
                bottom: to,
                flags_and_number: DOWNWARDS,
            })
        } else {
            if self.top[0] != x || self.top[1] != y || to[1] >= y {
                return None;
            }
            Some(Self {
                top: to,
                bottom: [x, y],
                flags_and_number: UPWARDS | HAS_SUCCESSOR,
            })
        }
    }

    /// The edge's top and bottom, each as (x, y) in 1/256 pixel.
    pub(crate) fn ends(&self) -> [[i32; 2]; 2] {
        [self.top, self.bottom]
    }

    /// The columns of pixels, the first one and the one after the last, that the edge lies in, in those of its rows
    /// that are among some rows, of which there is one. None where it runs along the boundary between two columns: the
    /// second one begins there. Exact but for a column more where the edge crosses a corner of a pixel.
    pub(crate) fn columns_in(&self, rows: &Range<i32>) -> [i32; 2] {
        let ([top_x, top], [bottom_x, bottom]) = (self.top, self.bottom);
        let height = i64::from(bottom) - i64::from(top);
        // Below 2^24 each.
        let x_at = |y: i32, round_up: i64| {
            // Where the rows have all of the edge, which is the rule, no division is needed.
            if y == top {
                return top_x;
            }
            if y == bottom {
                return bottom_x;
            }
            let down = i64::from(y) - i64::from(top);
            let width = i64::from(bottom_x) - i64::from(top_x);
            let to_y = (width * down + round_up).checked_div_euclid(height).unwrap_or(0);
            top_x + to_y as i32
        };
        let (first, end) = (top.max(rows.start << Y_BITS), bottom.min(rows.end << Y_BITS));
        let (lowest, highest) = (
            x_at(first, 0).min(x_at(end, 0)),
            x_at(first, height - 1).max(x_at(end, height - 1)),
        );
        [lowest >> Y_BITS, (highest + Y_ONE - 1) >> Y_BITS]
    }

    /// Whether the edge runs straight down along a boundary between columns of pixels, from row boundary to row
    /// boundary.
    pub(crate) fn is_aligned(&self) -> bool {
        let ([left, top], [right, bottom]) = (self.top, self.bottom);
        left == right && (left | top | bottom) & (Y_ONE - 1) == 0
    }

    /// Whether two edges have a point in common that is not an end of both: exact, by orientations in 64 bits.
    pub(crate) fn touches(&self, other: &Self) -> bool {
        // Edges outside the domain are asked too, before their outline is refused: they may wrap.
        let side = |edge: &Self, [x, y]: [i32; 2]| {
            let [width, height] = edge.size();
            let (x, y) = (x.wrapping_sub(edge.top[0]), y.wrapping_sub(edge.top[1]));
            (i64::from(width) * i64::from(y) - i64::from(height) * i64::from(x)).signum()
        };
        // Most edges lie beside each other.
        let columns = |edge: &Self| [edge.top[0].min(edge.bottom[0]), edge.top[0].max(edge.bottom[0])];
        let ([left, right], [other_left, other_right]) = (columns(self), columns(other));
        let are_beside = right < other_left || other_right < left;
        if are_beside || self.bottom[1] < other.top[1] || other.bottom[1] < self.top[1] {
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
            0 => a != b && c != d && a * b <= 0 && c * d <= 0 || (a | b | c | d) == 0,
            // One common end: they meet elsewhere only where they run along the same line, the same way.
            1 => (a | b) == 0 && self.top != other.bottom && self.bottom != other.top,
            _ => true,
        }
    }

    /// The first row of pixels that the edge lies in.
    #[inline]
    pub fn first_row(&self) -> i32 {
        self.top[1] >> Y_BITS
    }

    /// The row after the last one that the edge lies in.
    #[inline]
    pub fn end_row(&self) -> i32 {
        (self.bottom[1] + Y_ONE - 1) >> Y_BITS
    }

    /// x of the edge's top and of its bottom, in 1/8192 pixel.
    #[inline]
    pub(crate) fn ends_x(&self) -> [i32; 2] {
        [self.top[0], self.bottom[0]].map(fine)
    }

    /// Width, negative where the edge runs to the left, and height, in 1/256 pixel; modulo 2^32 for an edge outside the domain,
    /// whose outline is refused.
    #[inline]
    fn size(&self) -> [i32; 2] {
        [
            self.bottom[0].wrapping_sub(self.top[0]),
            self.bottom[1].wrapping_sub(self.top[1]),
        ]
    }

    /// The segment of the edge in a row; where the edge does not lie in that row, the segment of the nearest row that
    /// it lies in. Cost: up to two divisions.
    #[cfg(test)]
    pub fn begin(&self, row: i32) -> RowSegment {
        // The edge lies in one row at least.
        self.begin_at(NO_EDGE, row.min(self.end_row() - 1).max(self.first_row()))
    }

    /// The segment of the edge in a row in which it lies. The segment remembers the edge's index in its table.
    pub(crate) fn begin_at(&self, index: u32, row: i32) -> RowSegment {
        let [width, height] = self.size();
        let row_top = row * Y_ONE;
        let below_top = self.top[1] - row_top;
        let mut segment = RowSegment {
            x_bottom: fine(self.top[0]),
            y_top: below_top.max(0),
            y_bottom: Y_ONE,
            winding: self.winding(),
            error: (height >> 1) - height,
            height,
            edge: (index, self.bottom[1]),
            ..RowSegment::default()
        };
        // From its second row on an edge steps, unless it ends there.
        let first_step = if below_top > 0 { 2 } else { 1 };
        if self.end_row() > row + first_step {
            (segment.step, segment.error_step) = self.step_of(Y_ONE);
        }
        if below_top < 0 {
            let product = i64::from(width) * -i64::from(below_top);
            segment.move_by(divide_wide(product, height));
        }
        segment.x_top = segment.x_bottom;
        if self.bottom[1] - row_top <= Y_ONE {
            segment.end(row, fine(self.bottom[0]));
        } else if below_top > 0 {
            segment.move_by(self.step_of(Y_ONE - below_top));
        } else {
            segment.step();
        }
        segment.measure();
        segment
    }

    /// Makes this edge the one of a segment: it begins `height` above the bottom of a row and passes that. Returns x at
    /// the edge's top and at the bottom of the row. Sets only what [`RowSegment::step_bottom`] needs.
    #[inline]
    pub(crate) fn step_bottom_along(&self, segment: &mut RowSegment, index: u32, height: i32) -> (i32, i32) {
        let ([_, edge_height], x_top) = (self.size(), fine(self.top[0]));
        segment.x_bottom = x_top;
        segment.error = (edge_height >> 1) - edge_height;
        segment.height = edge_height;
        segment.move_by(self.step_of(height));
        segment.edge = (index, self.bottom[1]);
        if edge_height - height > Y_ONE {
            (segment.step, segment.error_step) = self.step_of(Y_ONE);
        }
        (x_top, segment.x_bottom)
    }

    /// A segment that stands for a y-monotone chain of which this is the first edge, at the chain's top.
    #[inline]
    pub(crate) fn chain_top(&self) -> RowSegment {
        RowSegment {
            winding: self.winding(),
            ..RowSegment::default()
        }
    }

    /// How far the edge moves in x over a height, which is in 1/256 pixel and at most a pixel: the distance in 1/8192
    /// pixel, 1 more than rounded down, and the remainder for the error term.
    #[inline]
    pub(super) fn step_of(&self, height: i32) -> (i32, i32) {
        let [width, edge_height] = self.size();
        // Widths are below 2^22, so that the product fits.
        divide(width * height, edge_height)
    }
}

/// Moves the origin of a point from the centre of pixel (0, 0) to the corner of that pixel. The domain leaves room; a point
/// so far outside that it wraps is refused with its outline, once all edges of that have come.
pub(crate) fn from_corner([x, y]: [i32; 2]) -> [i32; 2] {
    [x.wrapping_add(Y_ONE / 2), y.wrapping_add(Y_ONE / 2)]
}

/// Converts 1/256 pixel to 1/8192 pixel.
#[inline]
pub(crate) fn fine(x: i32) -> i32 {
    x << X_SHIFT
}

/// `product / height`, from 1/256 pixel to 1/8192 pixel, rounded down and 1 more, which the error term takes away
/// unless it carries; and the remainder.
#[inline(never)]
fn divide(product: i32, height: i32) -> (i32, i32) {
    let (quotient, remainder) = if product.unsigned_abs() < 1 << 26 {
        divide_floor_large(fine(product), height)
    } else {
        finer_quotient(divide_floor_large(product, height), height)
    };
    (quotient + 1, remainder)
}

/// `product / height` as [`divide`] gives it, for a product that may need more than 32 bits; the quotient is below the
/// width of an edge.
fn divide_wide(product: i64, height: i32) -> (i32, i32) {
    match i32::try_from(product) {
        Ok(product) => divide(product, height),
        Err(_) => {
            let (quotient, remainder) = finer_quotient(divide_long(product, height.max(1)), height);
            (quotient + 1, remainder)
        }
    }
}

/// Converts a quotient in 1/256 pixel and its remainder, below 2^22, to a quotient in 1/8192 pixel and its remainder.
#[inline]
fn finer_quotient((quotient, remainder): (i32, i32), height: i32) -> (i32, i32) {
    let (below, remainder) = divide_floor_large(fine(remainder), height);
    (fine(quotient) + below, remainder)
}
