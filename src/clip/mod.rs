//! Clipping: outcodes decide what can be skipped, one file per algorithm cuts the rest.
//!
//! Shapes of whole pixels are never cut: their outcodes say whether they are visible, and the scan conversion then
//! enters the window with an exact error term. The segment clippers serve sub-pixel segments.

mod outcode;

pub use outcode::Outcode;
