//! Clipping in space, before the division by the distance: the textbook's 4x4 matrix and homogeneous coordinates.

mod clip_matrix;
mod clip_point;
mod scale;

pub use clip_matrix::ClipMatrix;
pub use clip_point::ClipPoint;
