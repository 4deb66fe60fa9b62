//! The demo scenes, and the meshes that they show: one program, so that each scene is compiled once.

mod bands;
mod capacities;
mod meshes;
mod teapot;
