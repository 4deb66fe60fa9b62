//! Clipping: segments, convex and any polygons, whole shapes, against exact numbers.

#[path = "../common/mod.rs"]
mod common;

mod any_units;
mod convex_clipping;
mod exact_boolean;
mod known_booleans;
mod large_booleans;
mod polygon_booleans;
mod segment_clipping;
mod trivial_clipping;
