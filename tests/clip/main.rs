//! Clipping: segments, convex and any polygons, whole shapes, against exact numbers.

#[path = "../common/mod.rs"]
mod common;
#[path = "../reference"]
mod reference {
    pub mod convex_parts;
    pub mod seen_pixels;
}

mod any_units;
mod clip_matrix;
mod convex_polygons;
mod convex_segments;
mod convex_windows;
mod exact_boolean;
mod homogeneous_triangles;
mod known_booleans;
mod large_booleans;
mod polygon_booleans;
mod segment_clipping;
mod space_polygons;
mod space_segments;
mod trivial_clipping;
