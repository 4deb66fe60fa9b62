//! Colours: paints, and blending with and without gamma.

#[path = "../common/mod.rs"]
mod common;

mod blending;
mod gamma;
mod paints;
