//! Polygons against polygons: intersection, union and difference.

mod clip_error;
mod contours;
mod crossings;
mod direction;
pub mod greiner_hormann;
mod operation;
mod segment;
mod sides;
mod vertices;
