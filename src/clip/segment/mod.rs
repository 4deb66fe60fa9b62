//! Segments against an upright window: one function for each algorithm, all with one signature.
//!
//! `fn(from, to, window)` gives the two ends of what is inside, the same integers by every algorithm. [`liang_barsky()`] cuts
//! by default; the others are kept to compare them.

pub(crate) mod crossing;
mod liang_barsky;
mod siblings;

pub use liang_barsky::liang_barsky;
pub use siblings::*;
