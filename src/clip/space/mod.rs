//! Clipping in space, before the division by the distance: the textbook's 4x4 matrix and homogeneous coordinates.

mod clip_matrix;
mod clip_plane;
mod clip_point;
mod cyrus_beck;
mod fraction;
mod liang_barsky;
mod scale;
mod siblings;
mod space_segment;
mod sutherland_hodgman;

pub use clip_matrix::ClipMatrix;
pub use clip_plane::ClipPlane;
pub use clip_point::ClipPoint;
pub use space_segment::SpaceSegment;
