//! Pictures of how hidden surfaces and hidden lines are found: each method with the work it did, the depth row on its way down, and
//! line drawings.

mod hidden_lines;
mod order;
mod panel;
mod scan_line;
mod siblings;
mod solids;
mod work;

pub use hidden_lines::HiddenLineDrawings;
pub use scan_line::ScanLine;
pub use siblings::VisibilitySiblings;
