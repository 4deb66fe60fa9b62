//! A small scene: faces of one model in front of a camera.

use embedded_graphics::{geometry::Point, prelude::Size, primitives::Rectangle};
use fixed::types::I16F16;
use heapless::Vec;
use zrow::{
    geometry::InputError,
    scene::{Camera, Pose},
};

/// Columns and rows of the picture.
pub const SPACE_SIZE: usize = 96;
/// Pixels of the focal length.
pub const FOCAL_LENGTH: i32 = 96;
/// Vertices of a scene, at most.
pub const VERTICES: usize = 48;
/// Faces of a scene, at most.
pub const FACES: usize = 32;

/// Faces of one model in front of a camera at the origin, which looks along z and is not turned.
#[derive(Debug, Clone)]
pub struct SpaceInput {
    /// The distance of the near plane.
    pub near: i32,
    /// The position and the rotation of the model in the world.
    pub pose: Pose,
    /// The vertices of the model.
    pub vertices: Vec<[i16; 3], VERTICES>,
    /// The faces of the model, as indices of three of its vertices each.
    pub faces: Vec<[u16; 3], FACES>,
    /// A pair of numbers for each vertex: texture coordinates.
    pub coordinates: Vec<[i16; 2], VERTICES>,
}

impl SpaceInput {
    /// No faces.
    pub(super) const fn new(near: i32) -> Self {
        Self {
            near,
            pose: Pose::IDENTITY,
            vertices: Vec::new(),
            faces: Vec::new(),
            coordinates: Vec::new(),
        }
    }

    /// Its camera.
    ///
    /// # Errors
    /// The near plane is too near.
    pub fn camera(&self) -> Result<Camera, InputError> {
        Camera::new(Self::area(), I16F16::from_num(self.near))?.with_focal_length(I16F16::from_num(FOCAL_LENGTH))
    }

    /// The pixels of its picture.
    pub const fn area() -> Rectangle {
        Rectangle::new(Point::zero(), Size::new_equal(SPACE_SIZE as u32))
    }
}
