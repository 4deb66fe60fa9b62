//! Scan conversion: every shape becomes horizontal spans or the steps of a line. No colour here; one file per algorithm.

pub mod active_edge_table;
pub mod adaptive_forward_difference;
pub mod banded_polygon;
mod bands;
pub mod barycentric_triangle;
pub mod bezier;
pub mod bresenham;
pub mod bresenham_circle;
pub mod brute_force_fill;
pub mod circle;
pub mod de_casteljau;
mod edge;
mod edge_function;
pub mod edge_function_triangle;
pub mod edge_table;
pub mod ellipse;
pub mod flatten;
mod forward_difference;
pub mod hierarchical_triangle;
pub mod incremental_edge_triangle;
mod mirrored_rows;
pub mod naive_scanline;
mod pixel_bounds;
pub mod point_in_polygon;
pub mod polynomial_forward_difference;
pub mod scanline_polygon;
mod small_triangle;
pub mod triangle;
pub mod uniform_subdivision;
pub(crate) mod wide_stroke;

pub use active_edge_table::ActiveEdge;
pub use bezier::{Bezier, Cubic, Quadratic};
pub use edge::{Crossing, Edge, Part};
pub use forward_difference::{CurveNumber, ForwardDifference};
pub use mirrored_rows::{Curve, MirroredRows};
pub use polynomial_forward_difference::{PolynomialForwardDifference, StepTooFine};
