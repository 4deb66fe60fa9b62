//! The family of thin circles, which each algorithm's file adds a function to.

/// Circles one pixel wide, clipped to a window: a function for each algorithm, all with the signature
/// `fn(center, radius, window)`.
///
/// They give the pixels in the window, each once, or an error for a radius that the algorithm cannot draw.
///
/// | algorithm | pixels | take it when |
/// |---|---|---|
/// | [`bresenham`](Self::bresenham) | nearest to the circle | by default |
/// | [`midpoint`](Self::midpoint) | as Bresenham's | as the pattern for other curves |
/// | [`square_root`](Self::square_root) | as Bresenham's | to check the others, and for single pixels |
/// | [`parametric`](Self::parametric) | up to 0.72 pixel off | for points at equal steps of the angle |
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Circles;
