//! Polygons against polygons: intersection, union and difference.
//!
//! [`greiner_hormann`] is the default, and [`weiler_atherton`] kept to compare it. Both find where edges meet in the same way,
//! exactly, and give the same contours; they differ in how they tell what of a contour belongs to the result.

mod clip_error;
mod clipper;
mod contours;
mod crossings;
mod direction;
pub mod greiner_hormann;
mod operation;
mod segment;
mod siblings;
mod sides;
mod vertices;

pub use clipper::{BooleanMethod, Clipper};
pub use siblings::weiler_atherton;
