//! The methods that find out which parts of edges are hidden, one file or folder each, and what they share.
//!
//! All of them work in screen space: x and y as vertices were snapped, and the stored depth as third axis. Projection takes planes
//! to planes and convex solids to convex ones, so that what is true of faces and edges in space is true of them here, and all
//! numbers are integers.

mod appel;
mod face_against_segment;
mod face_box;
mod hiding;
mod intersection;
mod junction;
mod line_part;
mod line_table;
mod method;
mod parts;
mod roberts;

pub use appel::Appel;
pub use face_against_segment::FaceAgainstSegment;
pub use line_part::{LinePart, PartKind};
pub use method::HiddenLines;
pub use roberts::Roberts;

pub(crate) use line_table::{LineEdge, LineFace, LinePoint, LineTable};
