//! Scan conversion: every shape becomes horizontal spans or the steps of a line. No colour here; one file per algorithm.

pub mod bresenham;
pub mod triangle;
