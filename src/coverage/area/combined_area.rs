//! The exact area of what two outlines make together: a shape and its stroke, of which one is cut off along the other.
//!
//! ```text
//!        shape        stroke         edges of both lie in one row, those of the shape first in their table:
//!     ---/----------\                each segment changes one of two winding numbers, and a combination of the
//!       / ##########|\ .             two insides begins or ends where either of them does
//!      / ###########| \ .
//! ```
//!
//! Guarantees: those of [`InsideArea`](crate::coverage::InsideArea), which does the same with one winding number.
//!
//! Source: the sweep line that counts two polygons apart (Vatti 1992; Martínez, Rueda and Feito 2009), in each row by itself.

use core::ops::Range;

use crate::{
    coverage::{
        CoverageMethod, Emit, InsideArea,
        area::{
            accumulation_buffer::{coverage_of, in_room},
            inside_area::{Inside, Sides},
            sparse_row::cover,
        },
        edges::RowSegment,
    },
    scan::polygon::scanline_polygon::FillRule,
};

/// A boolean combination of a shape and its stroke: which points are drawn. The number of a variant is its truth table, a bit
/// each for points in neither of the two, in the shape alone, in the stroke alone and in both, from the lowest bit on.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum Combination {
    /// Points of the shape that the stroke does not cover.
    ShapeAlone = 0b0010,
    /// Points of the stroke that lie outside of the shape.
    StrokeAlone = 0b0100,
    /// Points of the stroke that lie inside of the shape.
    Both = 0b1000,
    /// Points of the shape, of the stroke, or of both.
    Either = 0b1110,
}

impl Combination {
    /// The combination with a number, the lowest bits of a word.
    pub(crate) const fn of_word(word: u32) -> Self {
        match word & 0b1111 {
            0b0010 => Self::ShapeAlone,
            0b0100 => Self::StrokeAlone,
            0b1000 => Self::Both,
            _ => Self::Either,
        }
    }

    /// 1 for a point that is drawn, or else 0.
    const fn includes(self, in_shape: bool, in_stroke: bool) -> i32 {
        self as i32 >> (in_shape as u32 | (in_stroke as u32) << 1) & 1
    }
}

/// The exact area of a [`Combination`] of a shape, by the fill rule, and a stroke, by the nonzero rule.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CombinedArea {
    pub(crate) combination: Combination,
    /// The index of the stroke's first edge: edges with a lower one are the shape's.
    pub(crate) first_of_stroke: u32,
}

/// The winding numbers of both outlines left of the next segment.
#[derive(Copy, Clone)]
struct TwoWindings {
    area: CombinedArea,
    fill_rule: FillRule,
    shape: i32,
    stroke: i32,
}

impl TwoWindings {
    fn is_drawn(&self) -> i32 {
        let (in_shape, in_stroke) = (self.fill_rule.includes(self.shape), self.stroke != 0);
        self.area.combination.includes(in_shape, in_stroke)
    }
}

impl Sides for TwoWindings {
    fn pass(&mut self, segment: &RowSegment) -> i32 {
        let before = self.is_drawn();
        if segment.edge_index() < self.area.first_of_stroke {
            self.shape += segment.winding;
        } else {
            self.stroke += segment.winding;
        }
        self.is_drawn() - before
    }

    fn pass_all(&mut self, _: &[RowSegment]) -> bool {
        false
    }
}

impl CoverageMethod for CombinedArea {
    type Cell = i32;

    fn cells(width: usize) -> usize {
        InsideArea::cells(width)
    }

    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i32],
        mut emit: impl Emit<E>,
    ) -> Result<(), E> {
        let (columns, cells) = in_room(&columns, cells);
        let left = TwoWindings {
            area: *self,
            fill_rule,
            shape: 0,
            stroke: 0,
        };
        let mut inside = Inside::new(segments, left);
        cover(segments, &columns, cells, &mut inside, coverage_of, &mut emit)
    }
}
