//! Coverage by the centre of the pixel: all or nothing.
//!
//! Guarantees: the top-left rule, but for centres nearer than 1/8192 pixel to an edge, which may count as being on its other
//! side; on edges that run along pixel boundaries it is the exact coverage too. Elsewhere it is wrong by up to one pixel's
//! coverage, which is what the other methods are for. No memory. Shapes that need no coverage are drawn without this, by the
//! exact scan-line fill.

use core::ops::Range;

use crate::{
    coverage::{
        Coverage, CoverageMethod, Emit,
        edges::{RowSegment, Y_BITS, Y_ONE},
        samples::scanline::{rounded_up, sides_at},
    },
    scan::polygon::scanline_polygon::FillRule,
};

/// No antialiasing: for flat user interfaces and wherever speed counts most.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CentreSample;

impl CoverageMethod for CentreSample {
    type Cell = ();

    fn cells(_width: usize) -> usize {
        0
    }

    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        _cells: &mut [()],
        mut emit: impl Emit<E>,
    ) -> Result<(), E> {
        let (mut start, mut emitted) = (columns.start, Ok(()));
        sides_at(segments, Y_ONE / 2, fill_rule, |x, sign| {
            // The first pixel whose centre is at x or right of it. Reversed columns have none (`clamp` would panic).
            let column = ((rounded_up(x) + Y_ONE / 2 - 1) >> Y_BITS)
                .max(columns.start)
                .min(columns.end);
            if sign > 0 {
                start = column;
            } else if start < column && emitted.is_ok() {
                emitted = emit.span(start..column, Coverage::MAX);
            }
        });
        emitted
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use embedded_graphics::geometry::Point;

    use super::*;
    use crate::{
        coverage::edges::AntialiasedEdge,
        geometry::{Sub8, SubPoint},
    };

    #[test]
    fn reversed_columns_have_no_pixels() {
        let edge = |x: i32, from: i32, to: i32| {
            let point = |y| SubPoint::<Sub8>::from_pixel(Point::new(x, y)).unwrap();
            AntialiasedEdge::new(&point(from), &point(to)).unwrap().begin(0)
        };
        let covered = |columns| {
            let mut spans = Vec::new();
            let mut segments = [edge(2, 4, -4), edge(6, -4, 4)];
            let mut emit = |span: Range<i32>, _: u8| -> Result<(), ()> {
                spans.push((span.start, span.end));
                Ok(())
            };
            CentreSample
                .cover_row(&mut segments, FillRule::NonZero, columns, &mut [], &mut emit)
                .unwrap();
            spans
        };
        assert_eq!(covered(0..10), [(2, 6)]);
        assert_eq!(covered(4..10), [(4, 6)]);
        for (start, end) in [(10, 0), (5, 3), (7, 6), (1, 0), (i32::MAX, i32::MIN)] {
            assert!(covered(Range { start, end }).is_empty(), "{start}..{end}");
        }
    }
}
