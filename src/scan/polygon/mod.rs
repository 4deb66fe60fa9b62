//! Polygons: edges, the tables that hold them, the rows that they enclose, and where a point lies.
//!
//! Fills hand over spans, `fn(contours, rule, window, emit)`: [`scanline_polygon()`] is the default, [`naive_scanline()`] and
//! [`brute_force_fill()`] are kept to compare them. Where a single point lies is asked by `fn(contours, rule, point)`:
//!
//! Guarantees of all four: exact for any contours and any point, also on vertices and edges (a product of two differences of
//! 32 bits is 64 bits long, and is compared by sign and size). **The boundary rule**: a point that lies on an edge or a
//! vertex of any contour is [`Location::OnBoundary`], whatever lies on either side of that edge; any other is inside or
//! outside by its winding number. Nothing is stored: memory does not grow with the polygon.
//!
//! | algorithm | what it counts | an edge costs |
//! |---|---|---|
//! | [`crossing_number()`] | edges left of the point, by a rule for vertices | two products where it crosses the row |
//! | [`merged_crossings()`] | changes of side, coincident crossings merged | two products where it crosses the row |
//! | [`winding_number()`] | edges right of the point, with their direction | two products where it may lie on either side |
//! | [`quadrant_arc_length()`] | quarter turns around the point | two products where it joins opposite quadrants |
//!
//! [`winding_number()`] is the one to take: the fewest products. A fill by rows
//! ([`scanline_polygon()`]) asks once an edge and row instead of once an edge and
//! pixel.

mod active_edge_table;
pub(crate) mod banded_polygon;
pub(crate) mod bisection;
pub(crate) mod bounding_box;
mod edge;
pub(crate) mod edge_table;
mod fill_error;
pub(crate) mod pixel_bounds;
mod point_in_polygon;
pub(crate) mod scanline_polygon;
pub(crate) mod shrunk_box;
mod siblings;

pub(crate) use active_edge_table::ActiveEdge;
pub(crate) use edge::{Crossing, Edge, Part, ScanEdge};
pub use fill_error::FillError;
pub use point_in_polygon::{Location, crossing_number, merged_crossings, quadrant_arc_length, winding_number};
pub use scanline_polygon::{FillRule, scanline_polygon};
pub use siblings::*;
