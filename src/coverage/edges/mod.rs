//! Antialiased edges: chains of edges with sub-pixel ends, cut into one segment for each row of pixels.

pub(crate) mod edge_chains;
pub mod row_segments;
pub(crate) mod sub_edge;

pub(crate) use sub_edge::HEIGHT_BITS;
pub use sub_edge::{FINE, FINE_BITS, RowSegment, SubEdge, UNIT};
