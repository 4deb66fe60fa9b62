//! The methods that find out which face is seen in each pixel, one file or folder each.

mod depth_buffer;
mod depth_sort;
mod one_depth;
mod picking;
mod placed;
mod ray_casting;
mod span_scan_line;
mod tile_bins;
mod warnock;

pub use depth_buffer::DepthBuffer;
pub use depth_sort::{DepthSort, DepthSortCounters};
pub use one_depth::OneDepth;
pub use ray_casting::{GridRayCasting, RayCasting, SolidCombination, SolidNode};
pub use span_scan_line::SpanScanLine;
pub use tile_bins::TileBins;
pub use warnock::Warnock;

pub(crate) use picking::face_at;
