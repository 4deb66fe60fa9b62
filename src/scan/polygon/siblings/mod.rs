//! Ways to fill a polygon that are kept to compare them with the default one.

mod brute_force_fill;
mod naive_scanline;
