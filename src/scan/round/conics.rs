//! The family of thin circles and ellipses, which each algorithm's file adds a function to.

/// Circles and ellipses one pixel wide, clipped to a window: a function for each algorithm, with the signature
/// `fn(center, radius, window)` for circles and `fn(center, radii, window)` for ellipses.
///
/// They give the pixels in the window, each once, or an error for a radius or semi-axis that the algorithm cannot draw.
///
/// | algorithm | pixels | take it when |
/// |---|---|---|
/// | [`bresenham_circle`](Self::bresenham_circle) | nearest to the circle | by default |
/// | [`midpoint_circle`](Self::midpoint_circle) | as Bresenham's | as the pattern for other curves |
/// | [`square_root_circle`](Self::square_root_circle) | as Bresenham's | to check the others, and for single pixels |
/// | [`parametric_circle`](Self::parametric_circle) | up to 0.72 pixel off | for points at equal steps of the angle |
/// | [`midpoint_ellipse`](Self::midpoint_ellipse) | nearest to the ellipse | as the pattern for other curves |
/// | [`square_root_ellipse`](Self::square_root_ellipse) | as the midpoint rule's | to check the others, and for single pixels |
/// | [`parametric_ellipse`](Self::parametric_ellipse) | up to 0.72 pixel off | for points at equal steps of the parameter |
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Conics;
