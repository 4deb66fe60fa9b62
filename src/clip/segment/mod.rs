//! Segments against an upright window: what of a segment is visible. The table in `segments` says when to take which
//! algorithm; each of them has a file of its own.

pub(crate) mod crossing;
mod liang_barsky;
pub(crate) mod segments;
mod siblings;

pub use segments::Segments;
