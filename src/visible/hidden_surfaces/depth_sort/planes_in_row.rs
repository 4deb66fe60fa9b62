//! Two faces along a row: which of them is in front, by stored depths.
//!
//! ```text
//!     depth of the face that is seen only where it is nearer, less that of the other one
//!
//!       \
//!     ---\-------------- a unit of stored depth     nearer: in front
//!         \  compare                                pixel by pixel: units may be the same
//!     -----\------------ 0                          not nearer: behind, or as near
//!           \
//! ```

use crate::{view::DepthWidth, visible::depth_plane::DepthPlane};

use super::counters::add;

/// The planes of two faces in a row, in columns that both cover.
pub(super) struct PlanesInRow<'p> {
    /// Of the face that is seen where both are as near.
    first: &'p DepthPlane,
    last: &'p DepthPlane,
    row: i32,
    /// Whether it is asked whether the first one is in front.
    is_first: bool,
}

/// What the depths of two planes at a pixel say before they are rounded to units.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Difference {
    /// The first face is nearer, or as near.
    First,
    /// Less than a unit apart.
    Close,
    Last,
}

impl<'p> PlanesInRow<'p> {
    /// The planes of a face and another one, and whether that face is seen where both are as near.
    pub(super) fn new([face, other]: [&'p DepthPlane; 2], row: i32, is_first: bool) -> Self {
        let (first, last) = if is_first { (face, other) } else { (other, face) };
        Self {
            first,
            last,
            row,
            is_first,
        }
    }

    /// Whether the face is in front at a column, and the first column up to an end where that may be different. Adds to the
    /// number of pixels that are compared one by one.
    pub(super) fn run<D: DepthWidth>(&self, [column, end]: [i32; 2], pixels: &mut u32) -> (bool, i32) {
        let difference = self.difference::<D>(column);
        let until = self.end_of::<D>(difference, [column, end]);
        let (is_last, until) = match difference {
            Difference::First => (false, until),
            Difference::Last => (true, until),
            Difference::Close => self.compare::<D>([column, until], pixels),
        };
        (is_last != self.is_first, until)
    }

    fn difference<D: DepthWidth>(&self, column: i32) -> Difference {
        let [first, last] = [self.first, self.last].map(|plane| plane.at(column, self.row).0);
        // A step of stored depth.
        let unit = if D::FRACTION_BITS == 16 { 1 << 16 } else { 1 };
        if first >= last {
            Difference::First
        } else if last - first >= unit {
            Difference::Last
        } else {
            Difference::Close
        }
    }

    /// The first column up to an end where there is another difference than at a column. Depths change evenly, so that the
    /// differences come in order.
    fn end_of<D: DepthWidth>(&self, difference: Difference, [mut column, mut end]: [i32; 2]) -> i32 {
        if self.difference::<D>(end - 1) == difference {
            return end;
        }
        end -= 1;
        while end - column > 1 {
            let middle = (column + end) >> 1;
            if self.difference::<D>(middle) == difference {
                column = middle;
            } else {
                end = middle;
            }
        }
        end
    }

    /// Whether the last face is nearer at a column, and the first column up to an end where that is different.
    fn compare<D: DepthWidth>(&self, [mut column, end]: [i32; 2], pixels: &mut u32) -> (bool, i32) {
        let [mut first, mut last] = [self.first, self.last].map(|plane| plane.at(column, self.row));
        let start = column;
        let is_last = D::from_interpolated(last.0) > D::from_interpolated(first.0);
        while column < end && (D::from_interpolated(last.0) > D::from_interpolated(first.0)) == is_last {
            first += self.first.per_column;
            last += self.last.per_column;
            column += 1;
        }
        add(pixels, (column - start) as u32);
        (is_last, column)
    }
}
