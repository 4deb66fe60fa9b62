//! Antialiased lines one pixel wide.

pub mod gupta_sproull;

pub use gupta_sproull::FilteredSegment;
