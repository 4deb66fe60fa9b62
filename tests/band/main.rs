//! The band and other targets, the loop that walks it down the picture, and displays behind it.

#[path = "../common/mod.rs"]
mod common;
#[expect(dead_code, reason = "what is left is for tests/draw")]
#[path = "../reference"]
mod reference {
    pub mod nearest_pixels;
}

mod band;
mod dithering;
mod faults;
mod mipidsi;
mod overlapping_loops;
mod pages;
mod panel_rotation;
mod picture_loop;
mod target_calls;
mod targets;
