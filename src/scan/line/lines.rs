//! The family of lines one pixel wide, which each algorithm's file adds a function to.

/// Lines one pixel wide, clipped to a window: a function for each algorithm, all with the signature
/// `fn(start, end, window)`.
///
/// They give the pixels in the window, in either order of the ends the same ones; clipped is unclipped without the pixels
/// outside. Pixels come from top to bottom, but for those of [`slope_intercept`](Self::slope_intercept), which come by growing x
/// where a line is wider than high, and of [`supercover`](Self::supercover), which come from the start to the end.
/// [`bresenham`](Self::bresenham) draws by default, and [`bresenham_runs`](Self::bresenham_runs) what has long runs; the others
/// are kept to compare them.
///
/// | algorithm | pixels | take it when |
/// |---|---|---|
/// | [`bresenham`](Self::bresenham) | exact | by default |
/// | [`bresenham_runs`](Self::bresenham_runs) | exact | runs are long, and filling them is cheap |
/// | [`double_step`](Self::double_step) | exact | a decision is dear beside a pixel |
/// | [`midpoint`](Self::midpoint) | exact | as the pattern for curves |
/// | [`dda_fixed`](Self::dda_fixed) | exact up to 181 steps | a colour or a depth is stepped in 16.16 anyway |
/// | [`dda`](Self::dda) | exact up to 1,365 steps | a course asks for it |
/// | [`slope_intercept`](Self::slope_intercept) | but ties, near the origin | to see what the others save |
/// | [`supercover`](Self::supercover) | all that the segment touches | for line of sight on a grid of cells |
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lines;
