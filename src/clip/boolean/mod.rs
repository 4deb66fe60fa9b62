//! Polygons against polygons: intersection, union and difference, by a [`Clipper`].
//!
//! The algorithm is a type: [`GreinerHormann`] is the default, and [`WeilerAtherton`] kept to compare it. Both find where edges
//! meet in the same way, exactly, and give the same contours; they differ in how they tell what of a contour belongs to the
//! result.

mod boolean_method;
mod clip_error;
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

pub use boolean_method::BooleanMethod;
pub use clip_error::ClipError;
pub use clipper::Clipper;
pub use contours::{Clipped, Contour};
pub use greiner_hormann::GreinerHormann;
pub use operation::Operation;
pub use siblings::*;
