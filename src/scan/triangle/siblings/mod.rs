//! Ways to fill a triangle that are kept to compare them with the default one.

pub mod barycentric_triangle;
mod edge_function;
pub mod edge_function_triangle;
pub mod hierarchical_triangle;
pub mod incremental_edge_triangle;
