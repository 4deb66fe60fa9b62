//! Thin circles and ellipses that are kept to compare them with the default ones.

mod arcs;
mod circle_arc;
mod ellipse_arc;
pub mod midpoint_circle;
pub mod midpoint_ellipse;
pub mod parametric_circle;
pub mod parametric_ellipse;
mod root_descent;
mod rotation;
pub mod square_root_circle;
pub mod square_root_ellipse;
