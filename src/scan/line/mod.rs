//! Lines one pixel wide: one file for each algorithm, all with the signature `line(start, end, window)`.
//!
//! [`bresenham`] draws by default, and [`bresenham_runs`] what has long runs; the others are kept to compare them.

pub mod bresenham;
pub mod bresenham_runs;
mod kuzmin;
mod siblings;

pub use siblings::{dda, dda_fixed, double_step, midpoint, slope_intercept, supercover};
