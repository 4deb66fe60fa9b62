//! Antialiased edges: y-monotone chains of edges with sub-pixel ends, cut into one segment for each row of pixels.

mod active_edge;
pub(crate) mod antialiased_edge;
pub(crate) mod chain_walk;
pub(crate) mod monotone_chains;
mod row_segment;
pub(crate) mod row_segments;

pub use active_edge::ActiveEdge;
pub use antialiased_edge::AntialiasedEdge;
pub(crate) use antialiased_edge::from_corner;
#[cfg(test)]
pub(crate) use row_segment::COVER_ONE;
pub use row_segment::RowSegment;
pub(crate) use row_segment::{COVER_BITS, X_BITS, X_ONE, Y_BITS, Y_ONE};
pub use row_segments::Rows;
