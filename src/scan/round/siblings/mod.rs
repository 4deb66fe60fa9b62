//! Thin circles and ellipses that are kept to compare them with the default ones.

mod arcs;
mod circle_arc;
mod ellipse_arc;
mod midpoint_circle;
mod midpoint_ellipse;
mod parametric_circle;
mod parametric_ellipse;
mod root_descent;
mod rotation;
mod square_root_circle;
mod square_root_ellipse;
