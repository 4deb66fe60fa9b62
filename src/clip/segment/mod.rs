//! Segments against a window: `segments` says which algorithm is for what, and each has a file.

pub(crate) mod crossing;
mod liang_barsky;
pub(crate) mod segments;
mod siblings;

pub use segments::Segments;
