//! How much of a pixel a shape covers: exact areas, samples, filtered lines.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/numbered_scene.rs"]
mod numbered_scene;
#[path = "../reference"]
mod reference {
    pub mod cone_volume;
    pub mod nearest_faces;
}

mod coverage;
mod filtered_lines;
mod outline_domain;
mod sampled_edges;
mod samples;
mod short_filtered_lines;
