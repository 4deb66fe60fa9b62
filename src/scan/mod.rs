//! Scan conversion: every shape becomes horizontal spans or the steps of a line. No colour here; a folder for each family
//! of shapes, a file for each algorithm.

pub mod curve;
pub mod line;
pub mod polygon;
pub mod round;
pub(crate) mod stroke;
pub mod triangle;
