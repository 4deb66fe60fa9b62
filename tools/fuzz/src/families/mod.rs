//! The targets, a folder or a file for each module of zrow.

pub mod any_scene;
pub mod band;
pub mod clip;
pub mod coverage;
pub mod depth_state;
pub mod draw;
pub mod geometry;
pub mod hidden_lines;
pub mod mesh;
pub mod planted;
pub mod scan;
pub mod scene;
pub mod shade;
pub mod shading;
pub mod space;
pub mod surface;
pub mod view;
pub mod visible;
