//! Polygons: edges, the tables that hold them, the rows that they enclose, and where a point lies.
//!
//! [`Polygons`] has the family of fills and that of tests for single points.

mod active_edge_table;
pub(crate) mod banded_polygon;
pub(crate) mod bisection;
pub(crate) mod bounding_box;
pub(crate) mod convex_walk;
mod edge;
pub(crate) mod edge_table;
mod edge_walk;
pub(crate) mod pixel_bounds;
mod point_in_polygon;
mod polygons;
pub(crate) mod scanline_polygon;
pub(crate) mod shrunk_box;
mod siblings;

pub(crate) use active_edge_table::ActiveEdge;
pub(crate) use edge::{Crossing, Edge, Part, ScanEdge, ceil_pixel};
pub(crate) use edge_walk::EdgeWalk;
pub use point_in_polygon::Location;
pub use polygons::Polygons;
pub use scanline_polygon::FillRule;
