//! An edge of a polygon, walked exactly by quotient and remainder.
//!
//! Guarantees: in each row the first pixel whose centre is on the edge or right of it, in exact arithmetic. Both
//! neighbours of an edge compute the same integers, because it is ordered top to bottom first. An interior that lies
//! between two such pixels, the second excluded, in rows `ceil(top) <= row < ceil(bottom)`, is the top-left rule.

use core::num::{NonZeroU32, Wrapping};

use crate::{
    geometry::{Vertex, assert_fraction_bits, divide_floor_cut, divide_wide},
    scan::polygon::edge_walk::EdgeWalk,
};

/// The part of a shape that an edge bounds.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Part {
    /// The inside of the shape.
    Fill,
    /// The stroke along its outline.
    Stroke,
}

/// An edge that crosses at least one row of pixel centres.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Edge {
    /// First row of pixel centres that the edge crosses.
    pub first_row: i32,
    /// The row after the last one that the edge crosses.
    pub end_row: i32,
    /// Column and error term of the edge's crossing with its first row.
    pub crossing: Crossing,
    /// Columns from row to row, rounded down.
    step: i32,
    /// Remainder of `step`, in columns / `height`.
    error_step: u32,
    /// Height in units of the vertices.
    height: NonZeroU32,
    /// The change of the shape's winding number from left of the edge to right of it: 1 where the edge runs down, -1 where it
    /// runs up, 0 for an edge of the stroke.
    pub fill_winding: i8,
    /// The change of the stroke's winding number from left of the edge to right of it: 1, -1, or 0 for an edge of the fill.
    pub stroke_winding: i8,
}

/// An edge of whatever form, as scan-line conversion walks it: straight, or an arc that crosses each row at most once.
pub trait ScanEdge {
    /// First row of pixel centres that the edge crosses.
    fn first_row(&self) -> i32;
    /// The row after the last one that the edge crosses.
    fn end_row(&self) -> i32;
    /// Column and error term of the edge's crossing with `row`, the edge's first row or one below it, computed at once instead of
    /// stepping from row to row.
    fn crossing_at(&self, row: i32) -> Crossing;
    /// Column and error term of the edge's crossing with `row`, stepped from its crossing with the row before.
    fn next_crossing(&self, before: Crossing, row: i32) -> Crossing;
    /// The changes of two winding numbers from left of the edge to right of it: the shape's, and that of the shape's stroke.
    fn windings(&self) -> (i8, i8);
}

impl ScanEdge for Edge {
    #[inline]
    fn first_row(&self) -> i32 {
        self.first_row
    }

    #[inline]
    fn end_row(&self) -> i32 {
        self.end_row
    }

    #[inline]
    fn crossing_at(&self, row: i32) -> Crossing {
        Self::crossing_at(self, row)
    }

    #[inline]
    fn next_crossing(&self, before: Crossing, _row: i32) -> Crossing {
        Self::next_crossing(self, before)
    }

    #[inline]
    fn windings(&self) -> (i8, i8) {
        (self.fill_winding, self.stroke_winding)
    }
}

/// Where an edge crosses a row.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Crossing {
    /// First pixel whose centre is on the edge or right of it.
    pub x: i32,
    /// Error term, less the edge's height, modulo 2^32: adding to it overflows when a column more is due.
    error: Wrapping<u32>,
}

impl Crossing {
    /// A crossing at pixel `x` of an edge that keeps its error term elsewhere, such as an arc.
    pub(crate) const fn at(x: i32) -> Self {
        Self { x, error: Wrapping(0) }
    }
}

impl Edge {
    /// The edge between two vertices; `None` where it crosses no row of pixel centres.
    ///
    /// Cost: one division for the slope, and one to enter the first row where a vertex is not in its middle; 32-bit
    /// wherever the numbers fit.
    pub fn new<V: Vertex>(from: &V, to: &V, part: Part) -> Option<Self> {
        const { assert_fraction_bits::<V>() }
        let units = |vertex: &V| (vertex.x_units(), vertex.y_units());
        Self::from_units(units(from), units(to), V::FRACTION_BITS, part)
    }

    /// The edge between two points (x, y) in units of `1 / (1 << fraction_bits)` pixel, at most 16 bits; `None` where no
    /// centre of a row lies between them.
    pub(crate) fn from_units(from: (i32, i32), to: (i32, i32), fraction_bits: u32, part: Part) -> Option<Self> {
        let downwards = from.1 < to.1;
        let (top, bottom) = if downwards { (from, to) } else { (to, from) };
        let winding = if downwards { 1 } else { -1 };
        let (fill_winding, stroke_winding) = match part {
            Part::Fill => (winding, 0),
            Part::Stroke => (0, winding),
        };
        let first_row = ceil_pixel(top.1, fraction_bits);
        let end_row = ceil_pixel(bottom.1, fraction_bits);
        if first_row >= end_row {
            return None;
        }
        // What crosses a row has a height. `?` instead costs polygons up to 1 % more instructions (Cortex-M4).
        let height = NonZeroU32::new(top.1.abs_diff(bottom.1)).unwrap_or(NonZeroU32::MIN);
        let width = i64::from(bottom.0) - i64::from(top.0);
        let (step, error_step) = divide_floor_cut(width, height);
        // In columns / height, seen from the pixel left of the top vertex; the fractions are below 2^16, so it fits.
        let fraction = i64::from(fraction(top.0, fraction_bits));
        let down_to_first_row = i64::from(fraction_of_negated(top.1, fraction_bits));
        let units = fraction * i64::from(height.get()) + down_to_first_row * width;
        // All pixel centres share the fraction: what is rounded up here keeps every later comparison exact.
        let columns = -((-units) >> fraction_bits);
        let (offset, remainder) = divide_floor_cut(columns + i64::from(height.get()) - 1, height);
        Some(Self {
            first_row,
            end_row,
            crossing: Crossing {
                x: (top.0 >> fraction_bits) + offset,
                error: Wrapping(remainder) - Wrapping(height.get()),
            },
            step,
            error_step,
            height,
            fill_winding,
            stroke_winding,
        })
    }

    /// An edge from a walk that is set up already: first row and end row, x and error term in the first row, and what each row
    /// adds to both. The error terms are those of [`Crossing`].
    pub(crate) const fn stepped(
        rows: (i32, i32),
        x: i32,
        error: u32,
        step: (i32, u32),
        height: NonZeroU32,
        downwards: bool,
    ) -> Self {
        Self {
            first_row: rows.0,
            end_row: rows.1,
            crossing: Crossing {
                x,
                error: Wrapping(error),
            },
            step: step.0,
            error_step: step.1,
            height,
            fill_winding: if downwards { 1 } else { -1 },
            stroke_winding: 0,
        }
    }

    /// An edge of the stroke instead of the fill, at the same pixels.
    #[must_use]
    pub(crate) const fn into_stroke(self) -> Self {
        Self {
            fill_winding: 0,
            stroke_winding: self.fill_winding,
            ..self
        }
    }

    /// Column and error term of the edge's crossing with `row`, the edge's first row or one below it: exact, by a division instead
    /// of stepping from row to row.
    pub fn crossing_at(&self, row: i32) -> Crossing {
        // Up to 2^32 - 1.
        let rows = Wrapping(row as u32) - Wrapping(self.first_row as u32);
        if rows.0 == 0 {
            return self.crossing;
        }
        // Fits: (2^32 - 1) * (2^32 - 1) + 2^32 - 1.
        let error = self.crossing.error + Wrapping(self.height.get());
        let total = u64::from(rows.0) * u64::from(self.error_step) + u64::from(error.0);
        let (columns, remainder) = divide_wide(total, self.height);
        // Between the ends of the edge again, whatever wrapped on the way.
        let x = Wrapping(self.crossing.x) + Wrapping(rows.0 as i32) * Wrapping(self.step) + Wrapping(columns as i32);
        Crossing {
            x: x.0,
            error: Wrapping(remainder) - Wrapping(self.height.get()),
        }
    }

    /// The edge on its way down from `row`, its first row or one below it.
    pub(crate) fn walk_from(&self, row: i32) -> EdgeWalk {
        let crossing = self.crossing_at(row);
        EdgeWalk {
            x: Wrapping(crossing.x),
            error: crossing.error,
            step: Wrapping(self.step),
            error_step: self.error_step,
            height: Wrapping(self.height.get()),
        }
    }

    /// Column and error term of the edge's crossing with the row after that of `crossing`.
    #[inline]
    pub fn next_crossing(&self, crossing: Crossing) -> Crossing {
        // Below the edge's last row, x may leave the number range.
        let x = Wrapping(crossing.x) + Wrapping(self.step);
        let (error, carry) = crossing.error.0.overflowing_add(self.error_step);
        let error = Wrapping(error);
        if carry {
            Crossing {
                x: (x + Wrapping(1)).0,
                error: error - Wrapping(self.height.get()),
            }
        } else {
            Crossing { x: x.0, error }
        }
    }
}

/// The first pixel centre at or after a coordinate.
pub(crate) fn ceil_pixel(units: i32, fraction_bits: u32) -> i32 {
    (units >> fraction_bits) + i32::from(fraction(units, fraction_bits) != 0)
}

/// The part of a coordinate after its last whole pixel, in its units.
fn fraction(units: i32, fraction_bits: u32) -> u32 {
    units as u32 & ((1 << fraction_bits) - 1)
}

/// The distance to the first pixel centre at or after a coordinate.
fn fraction_of_negated(units: i32, fraction_bits: u32) -> u32 {
    fraction((-Wrapping(units)).0, fraction_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// First pixel whose centre is on the line through two points or right of it, in exact arithmetic.
    fn exact_column(top: (i32, i32), bottom: (i32, i32), bits: u32, row: i32) -> i128 {
        let [x, y, end_x, end_y] = [top.0, top.1, bottom.0, bottom.1].map(i128::from);
        let height = end_y - y;
        let numerator = x * height + ((i128::from(row) << bits) - y) * (end_x - x);
        let denominator = height << bits;
        -(-numerator).div_euclid(denominator)
    }

    fn check(from: (i32, i32), to: (i32, i32), bits: u32) {
        let edge = Edge::from_units(from, to, bits, Part::Fill);
        let (top, bottom) = if from.1 < to.1 { (from, to) } else { (to, from) };
        let (first, end) = (ceil_pixel(top.1, bits), ceil_pixel(bottom.1, bits));
        let Some(edge) = edge else {
            assert!(first >= end, "{from:?} {to:?} {bits}");
            return;
        };
        assert_eq!((edge.first_row, edge.end_row), (first, end), "{from:?} {to:?} {bits}");
        assert_eq!(edge.fill_winding, if from.1 < to.1 { 1 } else { -1 });
        let middle = ((i64::from(first) + i64::from(end)) / 2) as i32;
        for row in [first, first.saturating_add(1), middle, end.saturating_sub(2), end - 1] {
            if first <= row && row < end {
                let crossing = edge.crossing_at(row);
                let expected = exact_column(top, bottom, bits, row);
                assert_eq!(i128::from(crossing.x), expected, "{from:?} {to:?} {bits}: row {row}");
                if row < end - 1 {
                    let mut walk = EdgeWalk::of_words(edge.walk_from(row).to_words());
                    assert_eq!(walk.x(), crossing.x);
                    walk.step();
                    assert_eq!(walk, edge.walk_from(row + 1), "{from:?} {to:?} {bits}: row {row}");
                    let next = edge.next_crossing(crossing);
                    assert_eq!(next, edge.crossing_at(row + 1), "{from:?} {to:?} {bits}: row {row}");
                }
            }
        }
    }

    /// All edges between points of a small grid, level ones included.
    #[test]
    fn small_edges_cross_rows_where_they_should() {
        let points = || (-9..10).flat_map(|x| (-9..10).map(move |y| (x, y)));
        for (from, to) in points().flat_map(|from| points().map(move |to| (from, to))) {
            for bits in [0, 2] {
                check(from, to, bits);
            }
        }
    }

    /// Edges over the whole number range.
    #[test]
    fn large_edges_cross_rows_where_they_should() {
        let numbers = [
            i32::MIN,
            i32::MIN + 1,
            -65_537,
            -1,
            0,
            1,
            255,
            65_536,
            i32::MAX - 1,
            i32::MAX,
        ];
        let points = || numbers.into_iter().flat_map(|x| numbers.map(|y| (x, y)));
        for (from, to) in points().flat_map(|from| points().map(move |to| (from, to))) {
            for bits in [0, 4, 8, 16] {
                check(from, to, bits);
            }
        }
    }
}
