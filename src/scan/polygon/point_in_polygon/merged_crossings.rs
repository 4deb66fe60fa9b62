//! The crossing number with coincident crossings merged: no rule says to which of two edges a vertex belongs.
//!
//! Where a ray to the left runs through a vertex, or along horizontal edges, all that lies on the ray is one crossing. It
//! counts where the contour comes from one side and leaves to the other, and does not count where it returns (the other of
//! the two classical treatments; Hearn and Baker, "Computer Graphics", 1986).
//!
//! Guarantees: what [its siblings](crate::scan::polygon::point_in_polygon) promise. Take it to see that the rule for
//! vertices and the merging agree.

use core::cmp::Ordering;

use crate::{
    geometry::Vertex,
    scan::polygon::{
        point_in_polygon::{Location, Units, from_edge, in_units_of, is_on_level_edge, units},
        polygons::Polygons,
        scanline_polygon::FillRule,
    },
};

impl Polygons {
    /// Where a point lies, by the crossings left of it, coincident ones merged. The point has the units of the
    /// contours, each of which is closed by itself.
    ///
    /// Cost: a few comparisons an edge, and two products for each edge with an end above and an end below the point.
    /// Source: Hearn and Baker 1986.
    pub fn merged_crossings<V: Vertex, P: Vertex>(contours: &[&[V]], rule: FillRule, point: &P) -> Location {
        let point = in_units_of::<V, P>(point);
        let mut winding = 0i32;
        for contour in contours {
            match winding_of(contour, point) {
                Some(of_contour) => winding += of_contour,
                None => return Location::OnBoundary,
            }
        }
        Location::by_winding(winding, rule)
    }
}

/// The winding number by the crossings left of a point: downward ones less upward ones; `None` where the point is on
/// the contour.
fn winding_of<V: Vertex>(contour: &[V], point: Units) -> Option<i32> {
    let side = |vertex: Units| vertex.1.cmp(&point.1);
    let mut from = contour.last().map(units).unwrap_or_default();
    // The side on which the contour was before it reached the ray; none where all of it lies along the row.
    let mut sides = contour.iter().rev().map(|vertex| side(units(vertex)));
    let mut side_before = sides.find(|side| side.is_ne()).unwrap_or(Ordering::Equal);
    let mut winding = 0i32;
    for to in contour.iter().map(units) {
        let side_after = side(to);
        if side_after.is_eq() {
            if to == point || is_on_level_edge(point, from, to) {
                return None;
            }
        } else if side_after != side_before {
            // All vertices on the row since the last change lie left of the point, or all right of it.
            let is_left = match side(from) {
                Ordering::Equal => from.0 < point.0,
                _ => match from_edge(point, from, to) {
                    Ordering::Less => false,
                    Ordering::Equal => return None,
                    Ordering::Greater => true,
                },
            };
            if is_left {
                winding += if side_after.is_gt() { 1 } else { -1 };
            }
            side_before = side_after;
        }
        from = to;
    }
    Some(winding)
}
