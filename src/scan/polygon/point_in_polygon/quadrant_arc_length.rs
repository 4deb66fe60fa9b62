//! The winding number of a point by the length of the arc that the contours describe around it, in quarter turns (Weiler
//! 1994, "An Incremental Angle Point in Polygon Test", Graphics Gems IV).
//!
//! Each vertex has a quadrant as seen from the point, half open: with the axis where it begins, without the one where it
//! ends. An edge to the next quadrant is a quarter turn, one to the same none. One to the opposite quadrant is half a turn,
//! to the side on which it leaves the point, and no other edge can run through the point.
//!
//! Guarantees: what [its siblings](crate::scan::polygon::point_in_polygon) promise. Take it where edges are short as seen
//! from the point: then it takes no products, and no question of rows.

use core::cmp::Ordering;

use crate::{
    geometry::Vertex,
    scan::polygon::{
        point_in_polygon::{Location, Units, in_units_of, product, units},
        polygons::Polygons,
        scanline_polygon::FillRule,
    },
};

impl Polygons {
    /// Where a point lies, by quarter turns of the contours around it. The point has the units of the contours, each of
    /// which is closed by itself.
    ///
    /// Cost: a few comparisons a vertex, and two products for each edge between opposite quadrants. Source: Weiler 1994.
    pub fn quadrant_arc_length<V: Vertex, P: Vertex>(contours: &[&[V]], rule: FillRule, point: &P) -> Location {
        let point = in_units_of::<V, P>(point);
        let mut quarters = 0i32;
        for contour in contours {
            match quarter_turns(contour, point) {
                Some(of_contour) => quarters += of_contour,
                None => return Location::OnBoundary,
            }
        }
        // Closed contours make whole turns.
        Location::by_winding(quarters >> 2, rule)
    }
}

/// Quarter turns of a contour around a point, clockwise; `None` where the point is on the contour.
fn quarter_turns<V: Vertex>(contour: &[V], point: Units) -> Option<i32> {
    let Some(mut from) = contour.last().map(units) else {
        return Some(0);
    };
    let mut from_quadrant = quadrant(from, point)?;
    let mut quarters = 0i32;
    for to in contour.iter().map(units) {
        let to_quadrant = quadrant(to, point)?;
        let turn = match (to_quadrant + 4 - from_quadrant) & 3 {
            0 => 0,
            1 => 1,
            3 => -1,
            _ => half_turn(from, from_quadrant, to, point)?,
        };
        quarters += turn;
        (from, from_quadrant) = (to, to_quadrant);
    }
    Some(quarters)
}

/// The quadrant of a vertex as seen from a point: 0 is right and below, the others follow clockwise; `None` in the
/// point itself.
fn quadrant(vertex: Units, point: Units) -> Option<u32> {
    match (vertex.0.cmp(&point.0), vertex.1.cmp(&point.1)) {
        (Ordering::Greater, Ordering::Equal | Ordering::Greater) => Some(0),
        (Ordering::Less | Ordering::Equal, Ordering::Greater) => Some(1),
        (Ordering::Less, Ordering::Less | Ordering::Equal) => Some(2),
        (Ordering::Equal | Ordering::Greater, Ordering::Less) => Some(3),
        (Ordering::Equal, Ordering::Equal) => None,
    }
}

/// The quarters of a turn between opposite quadrants: two, either way; `None` where the edge runs through the point.
fn half_turn(from: Units, from_quadrant: u32, to: Units, point: Units) -> Option<i32> {
    // Both products of the cross product have the same sign, which depends on the quadrant.
    let one = product(from.0.abs_diff(point.0), to.1.abs_diff(point.1));
    let other = product(from.1.abs_diff(point.1), to.0.abs_diff(point.0));
    let (clockwise, counterclockwise) = if from_quadrant & 1 == 0 {
        (other, one)
    } else {
        (one, other)
    };
    match clockwise.cmp(&counterclockwise) {
        Ordering::Greater => Some(2),
        Ordering::Equal => None,
        Ordering::Less => Some(-2),
    }
}
