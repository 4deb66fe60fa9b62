//! Pictures of how hidden surfaces are found: each method with the work it did, and the depth row on its way down.

mod order;
mod panel;
mod scan_line;
mod siblings;
mod solids;
mod work;

pub use scan_line::ScanLine;
pub use siblings::VisibilitySiblings;
