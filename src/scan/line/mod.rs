//! Lines one pixel wide, clipped to a window: one function for each algorithm, all with one signature.
//!
//! `fn(start, end, window)` gives the pixels in the window, from top to bottom, in either order of the ends the same ones;
//! clipped is unclipped without the pixels outside. [`bresenham()`] draws by default, and [`bresenham_runs()`] what has long
//! runs; the others are kept to compare them.
//!
//! | algorithm | pixels | take it when |
//! |---|---|---|
//! | [`bresenham()`] | exact | by default |
//! | [`bresenham_runs()`] | exact | runs are long, and filling them is cheap |
//! | [`double_step()`] | exact | a decision is dear beside a pixel |
//! | [`midpoint()`] | exact | as the pattern for curves |
//! | [`dda_fixed()`] | exact up to 181 steps | a colour or a depth is stepped in 16.16 anyway |
//! | [`dda()`] | exact up to 1,365 steps | a course asks for it |
//! | [`slope_intercept()`] | but ties, near the origin | to see what the others save |
//! | [`supercover()`] | all that the segment touches | for line of sight on a grid of cells |

pub(crate) mod bresenham;
pub(crate) mod bresenham_runs;
mod kuzmin;
mod siblings;

pub use bresenham::bresenham;
pub use bresenham_runs::{Run, bresenham_runs, line_runs};
pub use siblings::*;
