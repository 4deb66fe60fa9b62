//! Polygons against polygons: intersection, union and difference, by a [`Clipper`].
//!
//! Vertices, and where edges meet, are computed in one way for all algorithms; an algorithm links what of the contours belongs
//! to the result.

mod clipper;
mod contours;
mod crossings;
mod direction;
mod greiner_hormann;
mod operation;
mod segment;
mod siblings;
mod sides;
mod vertices;

pub use clipper::Clipper;
pub use contours::Contour;
pub use operation::Operation;
