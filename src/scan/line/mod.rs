//! Lines one pixel wide: `lines` says which algorithm is for what, and each has a file.

pub(crate) mod bresenham;
pub(crate) mod bresenham_runs;
mod kuzmin;
mod lines;
mod siblings;

pub use lines::Lines;
