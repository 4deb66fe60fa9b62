//! Cells: what an edge contributes to the area of a shape in one pixel, by two numbers.
//!
//! ```text
//!      start                        The edge covers everything to its right. In each pixel that it passes it makes a cell:
//!   +----o---+--------+--------+
//!   |     `. |########|########|    cover: its height within the pixel, which is what it adds to every pixel to the right
//!   |  area `.########|########|    area:  what of its cover the own pixel lacks, because it lies left of the edge
//!   |        |`.######|########|
//!   +--------+--`o----+--------+    The pixel itself gets cover - area, and the pixels to the right get cover.
//!      x         end
//! ```
//!
//! Heights are in 1/16384 pixel, and the height at which an edge passes a boundary of pixels is rounded towards its beginning
//! (towards 0): a digital differential analyser over the boundaries, `height * distance / length` by quotient and error term.
//! A cell has the difference of two such heights, so that the cells of an edge add up to it exactly, and so that a cell is a
//! function of the edge and the pixel alone. A window cuts nothing: an edge that comes in from the left enters at the boundary
//! with the error term that the pixels before it would have left.
//!
//! Source: cells with cover and area (FreeType's smooth rasterizer, Turner 2000; libart, Levien 1998).

use core::{convert::Infallible, num::Wrapping, ops::Range};

use crate::{
    coverage::edges::{COVER_BITS, X_BITS, X_ONE},
    geometry::{divide_long, divide_to_zero},
};

/// The bits of a pixel's area: few enough for the sum of 8,191 pixels.
pub(crate) const AREA_BITS: u32 = 18;

/// Shift from a height, 2^14 for a whole pixel, to the area of a pixel that high.
pub(super) const COVER_SHIFT: u32 = AREA_BITS - COVER_BITS;
/// Shift from a height times the sum of two x to an area. A whole pixel's product is 2^28.
const AREA_SHIFT: u32 = COVER_BITS + X_BITS + 1 - AREA_BITS;

/// The cover and the area that an edge contributes in one pixel, of which the whole area is 2^18. Both wrap, because sums
/// over some of the edges of a row may be larger than 32 bits hold; the sum over all edges is an area, which fits.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct Cell {
    /// The column of the pixel.
    pub(crate) x: i32,
    /// What the edge adds to every pixel to the right.
    pub(crate) cover: Wrapping<i32>,
    /// The part of `cover` that the cell's own pixel lacks, because it lies left of the edge.
    pub(crate) area: Wrapping<i32>,
}

impl Cell {
    /// The cell of a part of an edge, at most 2^14 high, that enters the pixel and leaves it at two x whose sum is `x_sum`,
    /// less than 2^14.
    #[inline(always)]
    fn new(x: i32, height: i32, x_sum: i32) -> Self {
        Self {
            x,
            cover: Wrapping(height << COVER_SHIFT),
            area: Wrapping((height * x_sum) >> AREA_SHIFT),
        }
    }

    /// The cell of a part of an edge that passes the pixel from side to side.
    #[inline(always)]
    fn across(x: i32, height: i32) -> Self {
        Self {
            x,
            cover: Wrapping(height << COVER_SHIFT),
            area: Wrapping(height << (COVER_SHIFT - 1)),
        }
    }

    /// The cell of a part of an edge that lies in one pixel.
    #[inline(always)]
    pub(crate) fn within([start, end]: [i32; 2], height: i32) -> Self {
        let x_sum = (start & (X_ONE - 1)) + (end & (X_ONE - 1));
        Self::new(start >> X_BITS, height, x_sum)
    }

    /// The cells of a part of an edge that lies in two neighbouring pixels. Cost: a division and no branch.
    #[inline(always)]
    pub(crate) fn in_two([start, end]: [i32; 2], height: i32) -> [Self; 2] {
        let (x, from, to) = (start >> X_BITS, start & (X_ONE - 1), end & (X_ONE - 1));
        let (first, _) = divide_to_zero(height * (X_ONE - from), end - start);
        [Self::new(x, first, from + X_ONE), Self::new(x + 1, height - first, to)]
    }

    /// The cells of a part of an edge that lies in three neighbouring pixels. Cost: two divisions and no branch.
    #[inline(always)]
    pub(crate) fn in_three([start, end]: [i32; 2], height: i32) -> [Self; 3] {
        let (x, from, to) = (start >> X_BITS, start & (X_ONE - 1), end & (X_ONE - 1));
        let length = end - start;
        let (first, _) = divide_to_zero(height * (X_ONE - from), length);
        let (both, _) = divide_to_zero(height * (2 * X_ONE - from), length);
        [
            Self::new(x, first, from + X_ONE),
            Self::new(x + 1, both - first, X_ONE),
            Self::new(x + 2, height - both, to),
        ]
    }

    /// Adds the cell to the differences of its pixel and of the next one.
    #[inline(always)]
    pub(super) fn add_to(&self, here: &mut i32, next: &mut i32) {
        *here = (Wrapping(*here) + self.cover - self.area).0;
        *next = (Wrapping(*next) + self.area).0;
    }
}

/// Visits the cells of a part of an edge from `start` to `end`, left to right, in 1/8192 pixel: all but the last one, which is
/// returned. `height` is in 1/16384 pixel.
///
/// Cost: a division where the part lies in two pixels, two where it lies in more, and none within a pixel.
///
/// # Errors
/// The first error that `visit` returns.
#[inline(always)]
pub(super) fn for_each<E>(
    [start, end]: [i32; 2],
    mut height: i32,
    mut visit: impl FnMut(Cell) -> Result<(), E>,
) -> Result<Cell, E> {
    let (mut x, last) = (start >> X_BITS, end >> X_BITS);
    // The sum of both ends' distances from the left side of the last pixel, by one subtraction; where the part begins further
    // left, it is found below.
    let mut x_sum = start + end - (last << (X_BITS + 1));
    if x < last {
        let (from, length) = (start & (X_ONE - 1), end - start);
        // At most 2^14 times 2^13.
        let (first, error) = divide_to_zero(height * (X_ONE - from), length);
        visit(Cell::new(x, first, from + X_ONE))?;
        let boundaries = Boundaries { height, length, error };
        (height, x_sum, x) = (height - first, end & (X_ONE - 1), x + 1);
        if x < last {
            height = boundaries.for_each(x..last, height, visit)?;
        }
    }
    Ok(Cell::new(last, height, x_sum))
}

/// Visits the cells of a part of an edge that are in the first `width` pixels, counted from x = 0, the left side of a
/// window. What lies left of the window goes into the cell of pixel 0, as if it ran along the window's side: cover
/// without area.
///
/// Cost: besides that of [`for_each`] a long division where the part enters at the side.
#[inline(never)]
pub(crate) fn for_each_visible(ends: [i32; 2], height: i32, width: i32, mut visit: impl FnMut(Cell)) {
    let [start, end] = ends;
    let last = end >> X_BITS;
    let (mut x, mut from, to) = (start >> X_BITS, start & (X_ONE - 1), end & (X_ONE - 1));
    if x >= width {
        return;
    }
    if last < 0 {
        visit(Cell::new(0, height, 0));
        return;
    }
    let mut left_over = height;
    if x < last {
        let length = end - start;
        let (first, error) = if start < 0 {
            // Rounded towards 0, as the division of 32 bits is.
            let sign = height >> 31 | 1;
            let distance = i64::from(height * sign) * -i64::from(start);
            let (above, error) = divide_long(distance, length.max(1));
            let above = above * sign;
            visit(Cell::new(0, above, 0));
            x = 0;
            (above, error * sign)
        } else {
            let (first, error) = divide_to_zero(height * (X_ONE - from), length);
            visit(Cell::new(x, first, from + X_ONE));
            x += 1;
            (first, error)
        };
        let boundaries = Boundaries { height, length, error };
        (left_over, from) = (height - first, 0);
        let visit = |cell| {
            visit(cell);
            Ok::<_, Infallible>(())
        };
        let Ok(rest) = boundaries.for_each(x..last.min(width), left_over, visit);
        left_over = rest;
    }
    if last < width {
        visit(Cell::new(last, left_over, from + to));
    }
}

/// The boundaries of pixels that a part of an edge passes, after the first one.
struct Boundaries {
    /// Height and length of the whole part.
    height: i32,
    length: i32,
    /// Error term at the first boundary: what rounding the height there leaves over, with the sign of the height.
    error: i32,
}

impl Boundaries {
    /// Visits the cells of pixels that the part passes from side to side, and returns what is left of `left_over`, the height
    /// from the first boundary on.
    #[inline(always)]
    fn for_each<E>(
        self,
        columns: Range<i32>,
        mut left_over: i32,
        mut visit: impl FnMut(Cell) -> Result<(), E>,
    ) -> Result<i32, E> {
        let Self { height, length, error } = self;
        let sign = height >> 31 | 1;
        let (step, error_step) = divide_to_zero(height * X_ONE, length);
        let (mut error, error_step) = (error * sign, error_step * sign);
        for x in columns {
            let mut part = step;
            error += error_step;
            if error >= length {
                (part, error) = (part + sign, error - length);
            }
            visit(Cell::across(x, part))?;
            left_over -= part;
        }
        Ok(left_over)
    }
}
