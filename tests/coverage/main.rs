//! How much of a pixel a shape covers: exact areas, samples, filtered lines.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/snapped_faces.rs"]
mod snapped_faces;
#[path = "../reference"]
mod reference {
    pub mod cone_volume;
    #[expect(dead_code, reason = "samples need the owners of pixels only, not how near they are")]
    pub mod nearest_faces;
}

mod coverage;
mod filtered_lines;
mod multisampling;
mod outline_domain;
mod sampled_edges;
mod short_filtered_lines;
mod supersampling;
