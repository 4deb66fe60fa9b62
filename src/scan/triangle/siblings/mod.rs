//! Ways to fill a triangle that are kept to compare them with the default one.

mod barycentric_triangle;
mod edge_function;
mod edge_function_triangle;
mod hierarchical_triangle;
mod homogeneous_triangle;
mod incremental_edge_triangle;
