//! Where a point lies with respect to a polygon: four ways with one signature, which give the same answer.
//!
//! Exact: a product of two differences of 32 bits is 64 bits long, and is compared by sign and size. A point on an edge or a
//! vertex is on the boundary, whatever lies on either side. Nothing is stored.

use core::cmp::Ordering;

use crate::{geometry::Vertex, scan::polygon::scanline_polygon::FillRule};

// Why small functions are `inline(always)` here: with `inline` alone, filling by the crossing number takes 1.4 % to 1.8 % more
// instructions on a Cortex-M4 and 1.0 % to 1.1 % more on a Cortex-M0+.

mod crossing_number;
mod merged_crossings;
mod quadrant_arc_length;
mod winding_number;

/// Where a point lies with respect to a polygon.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Location {
    /// The point is inside by the fill rule.
    Inside,
    /// The point is outside by the fill rule.
    Outside,
    /// The point is on an edge or a vertex.
    OnBoundary,
}

impl Location {
    /// Where a point with this winding number lies that is not on the boundary.
    fn by_winding(winding: i32, rule: FillRule) -> Self {
        if rule.includes(winding) {
            Self::Inside
        } else {
            Self::Outside
        }
    }
}

/// Column and row in units of the vertices.
pub(crate) type Units = (i32, i32);

/// The coordinates of a point, which has the precision of the contours.
fn in_units_of<V: Vertex, P: Vertex>(point: &P) -> Units {
    const {
        assert!(
            P::FRACTION_BITS == V::FRACTION_BITS,
            "the point has other units than the contours"
        )
    }
    units(point)
}

fn units<V: Vertex>(vertex: &V) -> Units {
    (vertex.x_units(), vertex.y_units())
}

/// Visits the edges of all contours, each contour closed by itself, until a visit gives `None`.
#[inline(always)]
pub(crate) fn visit_edges<V: Vertex>(
    contours: &[&[V]],
    mut visit: impl FnMut(Units, Units) -> Option<()>,
) -> Option<()> {
    for contour in contours {
        let mut from = contour.last().map(units).unwrap_or_default();
        for to in contour.iter().map(units) {
            visit(from, to)?;
            from = to;
        }
    }
    Some(())
}

/// Whether an edge has no point in a row: most edges in most rows.
#[inline(always)]
fn misses_row(from: Units, to: Units, row: i32) -> bool {
    from.1.max(to.1) < row || from.1.min(to.1) > row
}

/// Whether a point lies between the ends of an edge along its row, ends included.
fn is_on_level_edge(point: Units, from: Units, to: Units) -> bool {
    from.1 == point.1 && to.1 == point.1 && (from.0.min(to.0)..=from.0.max(to.0)).contains(&point.0)
}

/// Where a point lies in its row as seen from an edge that reaches this row: left of it, on it, or right of it.
///
/// The edge is not horizontal, and either order of its ends gives the same answer.
pub(crate) fn from_edge(point: Units, from: Units, to: Units) -> Ordering {
    let (top, bottom) = if from.1 < to.1 { (from, to) } else { (to, from) };
    // Both are distances from the column of the top end, times the height of the edge.
    let to_point = product(top.0.abs_diff(point.0), top.1.abs_diff(bottom.1));
    let to_edge = product(top.0.abs_diff(bottom.0), top.1.abs_diff(point.1));
    match (point.0 < top.0, bottom.0 < top.0) {
        (false, false) => to_point.cmp(&to_edge),
        (true, true) => to_edge.cmp(&to_point),
        (true, false) => Ordering::Less,
        // On the edge only where both are the top end.
        (false, true) => to_point.max(to_edge).cmp(&0),
    }
}

/// The product of two numbers. It fits: 2^32 - 1 squared is below 2^64.
fn product(one: u32, other: u32) -> u64 {
    u64::from(one) * u64::from(other)
}
