//! Random faces, and poses before the camera.

use fixed::types::U0F16;
use proptest::prelude::*;
use zrow::scene::{Pose, Rotation};

use crate::common::meshes::Mesh;
use crate::snapped_faces::at;

fn angle() -> impl Strategy<Value = U0F16> {
    any::<u16>().prop_map(U0F16::from_bits)
}

/// Any rotation, at a distance from the camera.
pub fn pose(distance: std::ops::Range<i32>) -> BoxedStrategy<Pose> {
    (angle(), angle(), angle(), -300..300, -300..300, distance)
        .prop_map(|(a, b, c, x, y, z)| {
            let rotation = Rotation::about_z(a)
                .then(&Rotation::about_x(b))
                .then(&Rotation::about_y(c));
            Pose::new(rotation, at(x, y, z))
        })
        .boxed()
}

/// Random faces, each with corners of its own, seen from both sides.
pub fn faces(size: i16, count: usize) -> BoxedStrategy<Mesh> {
    let corner = prop::array::uniform3(-size..=size);
    prop::collection::vec(prop::array::uniform3(corner), 1..=count)
        .prop_map(|faces| {
            let vertices = faces.concat();
            let faces = (0..faces.len() as u16)
                .map(|face| [3 * face, 3 * face + 1, 3 * face + 2])
                .collect();
            Mesh::new(vertices, faces).two_sided()
        })
        .boxed()
}
