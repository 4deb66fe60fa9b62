//! Scan conversion: each shape as spans, each algorithm against its siblings and against the exact rule.

#[path = "../common/mod.rs"]
mod common;
#[expect(dead_code, reason = "what is left is for tests/draw")]
#[path = "../reference"]
mod reference {
    pub mod nearest_pixels;
    pub mod winding_numbers;
}

mod circle_siblings;
mod curves;
mod every_fill;
mod fill_siblings;
mod interpolations;
mod line_siblings;
mod paths;
mod polynomials;
mod triangle_fills;
