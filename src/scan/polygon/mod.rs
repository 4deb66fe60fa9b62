//! Polygons: edges, the tables that hold them, and the rows that they enclose.
//!
//! [`scanline_polygon`] fills by default; [`naive_scanline`] and [`brute_force_fill`] are kept to compare them.

pub mod active_edge_table;
pub mod banded_polygon;
pub(crate) mod bisection;
pub(crate) mod bounding_box;
pub(crate) mod edge;
pub mod edge_table;
pub(crate) mod pixel_bounds;
pub mod point_in_polygon;
pub mod scanline_polygon;
pub(crate) mod shrunk_box;
mod siblings;

pub use active_edge_table::ActiveEdge;
pub use edge::{Crossing, Edge, Part, ScanEdge};
pub use siblings::{brute_force_fill, naive_scanline};
