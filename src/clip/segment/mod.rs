//! Segments against an upright window: one file for each algorithm, all with the signature `clip(start, end, window)`.
//!
//! [`liang_barsky`] cuts by default; the others are kept to compare them.

pub(crate) mod crossing;
pub mod liang_barsky;
mod siblings;

pub use siblings::{cohen_sutherland, midpoint_subdivision, nicholl_lee_nicholl};
