//! Triangles.
//!
//! [`bresenham_triangle`] draws embedded-graphics' triangle; the others fill one by edge functions or barycentric
//! coordinates, and are kept to compare them.

pub mod bresenham_triangle;
mod siblings;
mod small_triangle;
pub(crate) mod vertex_order;

pub use siblings::{barycentric_triangle, edge_function_triangle, hierarchical_triangle, incremental_edge_triangle};
