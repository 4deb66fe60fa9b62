//! Scan conversion: every shape becomes horizontal spans or the steps of a line. No colour here; one file per algorithm.

pub mod bresenham;
pub mod bresenham_circle;
pub mod circle;
pub mod ellipse;
mod forward_difference;
mod mirrored;
pub mod triangle;

pub use forward_difference::{CurveNumber, ForwardDifference};
pub use mirrored::{Curve, MirroredBox, MirroredRows, RowPair};
