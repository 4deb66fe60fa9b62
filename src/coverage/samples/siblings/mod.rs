//! The textbook's baseline of supersampling, kept to compare.

mod grid;

pub use grid::Grid;
