//! Clippers in space to compare with the default.

mod cohen_sutherland;
mod eye_space;
mod eye_space_polygon;
