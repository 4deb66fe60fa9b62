//! The sides of the inside along one scanline of a row: where samples and sub-scanlines change between inside and outside.

use crate::{
    coverage::edges::{RowSegment, X_BITS, Y_BITS},
    scan::polygon::{edge_table::insertion_sort, scanline_polygon::FillRule},
};

/// The x of a segment that does not reach the y in question: right of all others.
const ABSENT: i32 = i32::MAX;

/// Finds the sides of the inside at one y of a row, left to right: `cross` takes x in 1/8192 pixel, and 1 for a left side, -1
/// for a right one. Cost: an insertion sort of what is nearly sorted.
#[inline]
pub(super) fn sides_at(segments: &mut [RowSegment], y: i32, fill_rule: FillRule, mut cross: impl FnMut(i32, i32)) {
    for segment in segments.iter_mut() {
        let is_there = segment.y_top <= y && y < segment.y_bottom;
        segment.x = if is_there { segment.x_at(y) } else { ABSENT };
    }
    insertion_sort(segments, 1, |segment| segment.x);
    let mut windings = 0i32;
    for segment in segments.iter().take_while(|segment| segment.x != ABSENT) {
        let was_inside = fill_rule.includes(windings);
        windings += segment.winding;
        match (was_inside, fill_rule.includes(windings)) {
            (false, true) => cross(segment.x, 1),
            (true, false) => cross(segment.x, -1),
            _ => {}
        }
    }
}

/// Converts x from 1/8192 pixel to 1/256 pixel, rounded up.
#[inline]
pub(super) fn rounded_up(x: i32) -> i32 {
    const SHIFT: u32 = X_BITS - Y_BITS;
    (x + (1 << SHIFT) - 1) >> SHIFT
}
