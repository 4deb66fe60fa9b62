//! From model to eye to screen: rotations from angles, axes, quaternions and directions, poses, affine maps, the camera, screen
//! vertices.
//!
//! Axes: x to the right, y up, z away from the viewer. Angles enter once per frame, as fractions of
//! a turn. All arithmetic is that of integers, so that every machine computes the same vertices.

mod affine;
mod affine_eye_transform;
mod back_face_test;
mod camera;
mod depth_width;
mod eye_transform;
mod orientation;
mod parallel_projection;
mod pose;
mod precision;
mod projection;
mod rotation;
mod sine;
mod unit_vector;
mod view_volume;

pub use affine::Affine;
pub use camera::Camera;
pub use depth_width::DepthWidth;
pub use pose::Pose;
pub(crate) use precision::EdgeSum;
pub use precision::ScreenPrecision;
pub use rotation::Rotation;

pub(crate) use affine_eye_transform::AffineEyeTransform;
pub(crate) use back_face_test::{BackFaceTest, PlanesOfMesh};
pub(crate) use eye_transform::{EyeAxis, EyePoint, EyeTransform, ToEye};
pub(crate) use projection::{Position, Projection, ScreenVertex, WideVertex};
pub(crate) use sine::sine;
pub(crate) use view_volume::ViewVolume;
