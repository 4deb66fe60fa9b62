//! The crossing number of a point (Shimrat 1962, "Algorithm 112: Position of point relative to polygon", Communications of
//! the ACM 5(8), as corrected by Hacker in 5(12)): how many edges a ray to the left crosses.
//!
//! A ray through a vertex meets two edges there. The rule for vertices settles it: an edge has its upper end and not its
//! lower one, and horizontal edges have neither (Franklin 1970; Haines 1994, "Point in Polygon Strategies", Graphics Gems
//! IV). So a passed vertex counts once, and a touched one twice or not at all. Crossings downwards and upwards are counted
//! apart: an odd sum is inside by the even-odd rule, a difference by the nonzero rule.
//!
//! Guarantees: what [its siblings](crate::scan::polygon::point_in_polygon) promise. Take it to see the textbook's way.

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
    /// Where a point lies, by the parity of the edges left of it. The point has the units of the contours, each of
    /// which is closed by itself.
    ///
    /// Cost: a few comparisons an edge, and two products for each edge that crosses the row of the point. Source: Shimrat 1962.
    ///
    /// ```
    /// use embedded_graphics::geometry::Point;
    /// use zrow::scan::{FillRule, Location, Polygons};
    ///
    /// let triangle = [Point::new(0, 0), Point::new(8, 0), Point::new(0, 8)];
    /// let at = |x, y| Polygons::crossing_number(&[&triangle], FillRule::EvenOdd, &Point::new(x, y));
    /// assert_eq!(at(3, 3), Location::Inside);
    /// assert_eq!(at(4, 4), Location::OnBoundary);
    /// assert_eq!(at(5, 5), Location::Outside);
    /// ```
    pub fn crossing_number<V: Vertex, P: Vertex>(contours: &[&[V]], rule: FillRule, point: &P) -> Location {
        let point = in_units_of::<V, P>(point);
        let mut downwards = 0i32;
        let mut upwards = 0i32;
        let off_boundary = visit_edges(contours, |from, to| {
            if misses_row(from, to, point.1) {
                return Some(());
            }
            // Every vertex ends an edge.
            if to == point || is_on_level_edge(point, from, to) {
                return None;
            }
            let (starts_above, ends_above) = (from.1 <= point.1, to.1 <= point.1);
            if starts_above != ends_above {
                match from_edge(point, from, to) {
                    Ordering::Less => {}
                    Ordering::Equal => return None,
                    Ordering::Greater if starts_above => downwards += 1,
                    Ordering::Greater => upwards += 1,
                }
            }
            Some(())
        });
        if off_boundary.is_none() {
            return Location::OnBoundary;
        }
        let is_inside = match rule {
            FillRule::EvenOdd => (downwards + upwards) & 1 != 0,
            FillRule::NonZero => downwards != upwards,
        };
        if is_inside { Location::Inside } else { Location::Outside }
    }
}
