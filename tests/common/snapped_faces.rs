//! Faces as a scene has snapped them, in the numbers of the exact reference; pose and camera of the standard scenes.

use embedded_graphics::primitives::Rectangle;
use fixed::types::{I16F16, U0F16};
use zrow::scene::{Camera, DepthWidth, Look, Pose, Prepared, Rotation};

use crate::reference::nearest_faces::Face;

/// The pose of the standard scenes in a frame: 512 steps are a turn.
pub fn standard_pose(frame: u16) -> Pose {
    let steps = |steps: u16| U0F16::from_bits((steps % 512) * 128);
    let rotation = Rotation::about_x(steps(frame * 8)).then(&Rotation::about_y(steps(frame * 16)));
    Pose::new(rotation, at(0, 0, 3 * 512))
}

pub fn at(x: i32, y: i32, z: i32) -> [I16F16; 3] {
    [x, y, z].map(I16F16::from_num)
}

/// A camera at the origin with the near plane 128 units away.
pub fn camera(area: Rectangle) -> Camera {
    Camera::new(area, I16F16::from_num(128)).unwrap()
}

/// The faces as they were snapped and cut.
pub fn snapped<L: Look>(prepared: &Prepared<'_, '_, L>) -> Vec<Face> {
    prepared
        .faces()
        .map(|face| Face {
            order: face.order,
            corners: face.corners.map(|corner| {
                [
                    corner.point.x_units().into(),
                    corner.point.y_units().into(),
                    corner.depth.units().into(),
                ]
            }),
        })
        .collect()
}
