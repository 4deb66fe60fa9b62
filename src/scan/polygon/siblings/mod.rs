//! Ways to fill a polygon that are kept to compare them with the default one.

pub mod brute_force_fill;
pub mod naive_scanline;
