//! Antialiased lines one pixel wide.

mod cone;
mod gupta_sproull;

pub use gupta_sproull::FilteredSegment;
