//! Antialiased lines one pixel wide.

mod gupta_sproull;

pub use gupta_sproull::FilteredSegment;
