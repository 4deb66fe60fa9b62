//! Scenes of faces: projection, depths, clipping, bands in any order.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/numbered_scene.rs"]
mod numbered_scene;
#[path = "../reference"]
mod reference {
    pub mod nearest_faces;
}

mod clipped_faces;
mod depth_row;
mod number_range;
mod projection;
mod rotations;
mod scene;
mod unclipped_faces;
