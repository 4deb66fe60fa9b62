//! Every combination of wrappers around looks, shadings and attributes: what each of them is alone, and that both orders of two name
//! the same look.

#![allow(dead_code, reason = "modules that are shared with tests/scene")]

#[path = "../common/mod.rs"]
mod common;
#[path = "../reference"]
mod reference {
    pub mod nearest_faces;
}
#[path = "../common/snapped_faces.rs"]
mod snapped_faces;

#[path = "../scene/numbered_scene.rs"]
mod numbered_scene;
#[path = "../scene/random_faces.rs"]
mod random_faces;
#[path = "../scene/same_looks.rs"]
mod same_looks;
#[path = "../scene/shaded_scene.rs"]
mod shaded_scene;

mod attribute_pairs;
mod shadings;
mod wrappers;
