//! The winding number of a point by crossings with a direction (Hormann and Agathos 2001, "The point in polygon problem for
//! arbitrary polygons", Computational Geometry 20(3), in the version that knows the boundary).
//!
//! A ray to the right is crossed downwards or upwards. An edge with both ends right of the point crosses it for certain,
//! one with both ends left of it never does; only the others take two products.
//!
//! Guarantees: what [its siblings](crate::scan::polygon::point_in_polygon) promise. Take it by default: the fewest products.

use core::cmp::Ordering;

use crate::{
    geometry::Vertex,
    scan::polygon::{
        point_in_polygon::{Location, from_edge, in_units_of, is_on_level_edge, misses_row, visit_edges},
        polygons::Polygons,
        scanline_polygon::FillRule,
    },
};

impl Polygons {
    /// Where a point lies, by crossings with a direction: the fewest products. The point has the units of the contours,
    /// each of which is closed by itself.
    ///
    /// Cost: a few comparisons an edge, and two products for each edge that crosses both row and column of the point.
    /// Source: Hormann and Agathos 2001.
    pub fn winding_number<V: Vertex, P: Vertex>(contours: &[&[V]], rule: FillRule, point: &P) -> Location {
        let point = in_units_of::<V, P>(point);
        let mut winding = 0i32;
        let off_boundary = visit_edges(contours, |from, to| {
            if misses_row(from, to, point.1) {
                return Some(());
            }
            if to == point || is_on_level_edge(point, from, to) {
                return None;
            }
            if (from.1 < point.1) == (to.1 < point.1) {
                return Some(());
            }
            let crosses_right = match (from.0 > point.0, to.0 > point.0) {
                (true, true) => true,
                (false, false) if from.0 < point.0 && to.0 < point.0 => false,
                _ => match from_edge(point, from, to) {
                    Ordering::Less => true,
                    Ordering::Equal => return None,
                    Ordering::Greater => false,
                },
            };
            if crosses_right {
                winding += if from.1 < to.1 { 1 } else { -1 };
            }
            Some(())
        });
        match off_boundary {
            Some(()) => Location::by_winding(winding, rule),
            None => Location::OnBoundary,
        }
    }
}
