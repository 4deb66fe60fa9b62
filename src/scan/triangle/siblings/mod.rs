//! Ways to fill a triangle that are kept to compare them with the default one, and ways to interpolate what its corners have.

mod barycentric_interpolation;
mod barycentric_triangle;
mod edge_and_span_interpolation;
mod edge_function;
mod edge_function_triangle;
mod hierarchical_triangle;
mod homogeneous_triangle;
mod incremental_edge_triangle;
mod plane_interpolation;
