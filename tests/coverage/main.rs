//! How much of a pixel a shape covers: exact areas, samples, filtered lines.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/snapped_faces.rs"]
mod snapped_faces;
#[path = "../reference"]
mod reference {
    pub mod cone_volume;
    pub mod exact_area;
    #[expect(dead_code, reason = "samples need the owners of pixels only, not how near they are")]
    pub mod nearest_faces;
}

mod coverage;
mod crossings;
mod edge_tables;
mod filtered_lines;
mod measured;
mod multisampling;
mod outline_domain;
mod published_accuracy;
mod sampled_edges;
mod shape_classes;
mod short_filtered_lines;
mod supersampling;
