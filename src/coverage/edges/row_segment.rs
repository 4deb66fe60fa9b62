//! The part of an edge that lies in one row of pixels: what every antialiasing method measures.
//!
//! ```text
//!            x_top                 the row of pixels, y = 0
//!   ----+------\--+-----+-----+
//!       |       `.|     |     |    from row to row: x_bottom becomes x_top, and x_bottom moves by
//!       |         `.    |     |    `step`, plus 1 where the error term carries
//!   ----+-----+-----\---+-----+
//!                x_bottom          the bottom of the row, y = 256
//! ```
//!
//! Guarantees: where an edge passes from row to row, its x is the exact one rounded to 1/8192 pixel: a quotient with the
//! remainder as error term (a digital differential analyser in integers), from whichever row one begins. Cost: four additions
//! a row, and no division.

use core::num::Wrapping;

use crate::geometry::divide_floor_large;

/// The bits of a segment's x below a whole pixel: x is in 1/8192 pixel.
pub(crate) const X_BITS: u32 = 13;
/// A pixel's width in units of a segment's x, 1/8192 pixel.
pub(crate) const X_ONE: i32 = 1 << X_BITS;

/// The bits of a segment's y below a whole pixel: y is in 1/256 pixel.
pub(crate) const Y_BITS: u32 = 8;
/// A pixel's height in units of a segment's y, 1/256 pixel.
pub(crate) const Y_ONE: i32 = 1 << Y_BITS;

/// The bits of a height that is measured, below a whole pixel: finer than y, so that the parts of a segment in its pixels add
/// up to the whole segment, and so that a segment can be cut close to where it crosses another one.
pub(crate) const COVER_BITS: u32 = 14;
/// The height of a pixel, in 1/16384 pixel.
#[cfg(test)]
pub(crate) const COVER_ONE: i32 = 1 << COVER_BITS;
/// Shift from 1/256 pixel to 1/16384 pixel.
pub(super) const COVER_SHIFT: u32 = COVER_BITS - Y_BITS;

/// The part of an edge that lies in the current row of pixels, with what it takes to step to the next row.
///
/// x is in 1/8192 pixel from the left side of pixel 0; y in 1/256 pixel from the top of the row. Only
/// [`AntialiasedEdge`](crate::coverage::AntialiasedEdge) makes segments, so that their numbers are those of an edge.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RowSegment {
    /// x at the segment's top.
    pub(crate) x_top: i32,
    /// x at the segment's bottom.
    pub(crate) x_bottom: i32,
    /// y of the segment's top: from 0, and less than `y_bottom`.
    pub(crate) y_top: i32,
    /// y of the segment's bottom: up to 256.
    pub(crate) y_bottom: i32,
    /// What crossing the segment from left to right adds to the winding number: 1 or -1.
    pub(crate) winding: i32,
    /// Scratch of the method that measures: the segment's x at the y in question. (A method may also put segments into
    /// another order.)
    pub(crate) x: i32,
    /// Scratch of the method that measures: the segment's x at the bottom of the slab that begins at the y in question.
    pub(crate) end_x: i32,
    /// Left end of the segment, in 1/8192 pixel; kept because it is asked for more often than it changes.
    pub(super) left: i32,
    /// Right end of the segment, in 1/8192 pixel.
    pub(super) right: i32,
    /// Height times winding number, in 1/16384 pixel. It fits 16 bits with its sign.
    pub(super) signed_height: i16,
    /// Scratch of the method that measures: whether the inside begins (1) or ends (-1) at the segment, or neither (0), in the
    /// lowest two bits with sign; above them since which y, in 1/16384 pixel.
    pub(crate) side: u16,
    /// Error term: what rounding `x_bottom` down leaves over, in 1/8192 pixel / `height`, with the half that rounds to the
    /// nearest, less `height`; so it is negative until it carries.
    pub(super) error: i32,
    /// Whole 1/8192 pixels from row to row, 1 too many unless the error term carries.
    pub(super) step: i32,
    /// What each row adds to the error term.
    pub(super) error_step: i32,
    /// Height of the whole edge, in 1/256 pixel.
    pub(super) height: i32,
    /// The edge's index in its table, and the y of its bottom in 1/256 pixel. (One field, so that it comes first, out of the
    /// way of what changes from row to row.)
    pub(super) edge: (u32, i32),
}

impl RowSegment {
    /// A segment without height: memory that waits for one.
    pub(crate) const EMPTY: Self = Self {
        x_top: 0,
        x_bottom: 0,
        y_top: 0,
        y_bottom: 0,
        winding: 0,
        x: 0,
        end_x: 0,
        left: 0,
        right: 0,
        signed_height: 0,
        side: 0,
        error: 0,
        step: 0,
        error_step: 0,
        height: 0,
        edge: (0, 0),
    };

    /// Left and right end of the segment, in 1/8192 pixel.
    #[inline]
    pub fn ends(&self) -> (i32, i32) {
        (self.left, self.right)
    }

    /// The segment's height times its winding number, in 1/16384 pixel.
    #[inline]
    pub fn signed_height(&self) -> i32 {
        self.signed_height.into()
    }

    /// The last row of pixels that the segment's edge lies in.
    #[inline]
    pub fn last_row(&self) -> i32 {
        (self.edge.1 - 1) >> Y_BITS
    }

    /// The index of the segment's edge in its table.
    #[inline]
    pub(crate) fn edge_index(&self) -> u32 {
        self.edge.0
    }

    /// The y at which the segment's edge ends, in 1/256 pixel from the top of row 0.
    #[inline]
    pub(crate) fn end_y(&self) -> i32 {
        self.edge.1
    }

    /// Steps to the next row of pixels, through which the edge must pass from top to bottom.
    #[inline]
    pub fn step(&mut self) {
        self.x_top = self.x_bottom;
        let width = self.step + self.carry(self.error_step);
        let to_left = Wrapping(width.min(0));
        // Whoever steps on below the edge's end leaves the number range some time.
        let (top, bottom) = (Wrapping(self.x_top), Wrapping(self.x_top) + Wrapping(width));
        self.x_bottom = bottom.0;
        self.left = (top + to_left).0;
        self.right = (bottom - to_left).0;
    }

    /// Steps to `row`, which is the next one, whether the edge passes through or ends in it; `bottom_x` is where the edge ends.
    #[inline]
    pub(crate) fn step_to(&mut self, row: i32, bottom_x: i32) {
        self.y_top = 0;
        if self.last_row() > row {
            // Whoever went from edge to edge along a chain left the end of another one here.
            self.y_bottom = Y_ONE;
            self.step();
        } else {
            self.x_top = self.x_bottom;
            self.end(row, bottom_x);
        }
        self.measure();
    }

    /// Steps to the bottom of the next row of pixels, through which the edge must pass; returns x at its top and bottom. Only
    /// `x_bottom` and the error term are kept up to date: all that the dense sibling of [`SignedArea`](crate::coverage::SignedArea) needs.
    #[inline]
    pub(crate) fn step_bottom(&mut self) -> (i32, i32) {
        let x_top = self.x_bottom;
        self.move_by((self.step, self.error_step));
        (x_top, self.x_bottom)
    }

    /// Steps as [`step_bottom`](Self::step_bottom) does; returns the left and the right end of the segment in that row.
    #[inline(always)]
    pub(crate) fn step_ends(&mut self) -> [i32; 2] {
        let (top, bottom) = self.step_bottom();
        [top.min(bottom), top.max(bottom)]
    }

    /// Makes the height that of a segment that passes the row from top to bottom, as it does in all rows up to the next event.
    #[inline(always)]
    pub(crate) fn set_whole_height(&mut self) {
        self.signed_height = (self.winding << COVER_BITS) as i16;
    }

    /// Steps to the next row of pixels, which the edge passes, as [`step`](Self::step) does, once
    /// [`step_ends`](Self::step_ends) returned these ends.
    #[inline]
    pub(crate) fn go_between(&mut self, [left, right]: [i32; 2]) {
        self.x_top = if self.x_bottom == left { right } else { left };
        (self.left, self.right) = (left, right);
    }

    /// Makes the segment stand for an edge of its chain that ended at `end_y`, the bottom of the row, so that its successor
    /// begins in the next row.
    #[inline]
    pub(crate) fn wait_for_successor(&mut self, index: u32, end_y: i32) {
        self.edge = (index, end_y);
    }

    /// Puts the bottom of the segment where its edge ends, in `row`.
    #[inline]
    pub(super) fn end(&mut self, row: i32, bottom_x: i32) {
        self.x_bottom = bottom_x;
        self.y_bottom = self.edge.1 - row * Y_ONE;
    }

    /// Sets what is derived from top and bottom.
    pub(super) fn measure(&mut self) {
        self.left = self.x_top.min(self.x_bottom);
        self.right = self.x_top.max(self.x_bottom);
        let height = (self.y_bottom - self.y_top) << COVER_SHIFT;
        self.signed_height = (height * self.winding) as i16;
    }

    /// Moves the bottom to the right by a number of 1/8192 pixels that is 1 too large, and adds to the error term, which takes
    /// that 1 away unless it carries.
    #[inline]
    pub(super) fn move_by(&mut self, (width, error): (i32, i32)) {
        let carried = self.carry(error);
        self.x_bottom += width + carried;
    }

    /// Adds to the error term. Returns 0 on carry, else -1 (all ones: used as a mask, no branch).
    #[inline]
    fn carry(&mut self, error: i32) -> i32 {
        let error = self.error + error;
        let keeps = error >> 31;
        self.error = error - (self.height & !keeps);
        keeps
    }

    /// The segment's x at a y of the row between its top and its bottom, in 1/8192 pixel, rounded to the nearest. y is in
    /// 1/256 pixel from the top of the row.
    #[inline(always)]
    pub fn x_at(&self, y: i32) -> i32 {
        let (width, height) = (
            Wrapping(self.x_bottom) - Wrapping(self.x_top),
            self.y_bottom - self.y_top,
        );
        // Another y gives some x.
        let part = Wrapping(y) - Wrapping(self.y_top);
        let x = if height == Y_ONE {
            // Below 2^27 times 2^8: in two products.
            let (pixels, rest) = (width.0 >> X_BITS, width.0 & (X_ONE - 1));
            let rest = (Wrapping(rest) * part + Wrapping(Y_ONE / 2)).0 >> Y_BITS;
            let pixels = (Wrapping(pixels) * part).0 << (X_BITS - Y_BITS);
            Wrapping(pixels) + Wrapping(rest)
        } else {
            part_of_width::<Y_BITS>(width, part, height)
        };
        (Wrapping(self.x_top) + x).0
    }

    /// The segment's x at a y of the row between its top and its bottom, in 1/8192 pixel, rounded to the nearest. y is in
    /// 1/16384 pixel from the top of the row.
    #[inline]
    pub(crate) fn x_within_row(&self, y: i32) -> i32 {
        let (top, bottom) = (self.y_top << COVER_SHIFT, self.y_bottom << COVER_SHIFT);
        if y == top {
            self.x_top
        } else if y == bottom {
            self.x_bottom
        } else {
            let width = Wrapping(self.x_bottom) - Wrapping(self.x_top);
            let x = part_of_width::<COVER_BITS>(width, Wrapping(y - top), bottom - top);
            (Wrapping(self.x_top) + x).0
        }
    }
}

/// width * part / height, rounded to the nearest, for a width below 2^27 in 1/8192 pixel, and a part and a height of at most
/// a pixel, which is 2^`BITS`; some number for any other width or part.
#[inline(never)]
fn part_of_width<const BITS: u32>(width: Wrapping<i32>, part: Wrapping<i32>, height: i32) -> Wrapping<i32> {
    let divide = |numerator: Wrapping<i32>| {
        let (quotient, remainder) = divide_floor_large(numerator.0, height);
        (Wrapping(quotient), remainder)
    };
    let half = Wrapping(height >> 1);
    if width.0.unsigned_abs() < 1 << (30 - BITS) {
        return divide(width * part + half).0;
    }
    let (pixels, rest) = (Wrapping(width.0 >> X_BITS), Wrapping(width.0 & (X_ONE - 1)));
    let (quotient, left_over) = divide(pixels * part);
    let product = rest * part + Wrapping(left_over << X_BITS);
    let (below, _) = divide(product + half);
    Wrapping(quotient.0 << X_BITS) + below
}
