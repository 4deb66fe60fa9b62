//! The family of thin ellipses, which each algorithm's file adds a function to.

/// Ellipses one pixel wide, clipped to a window: a function for each algorithm, all with the signature
/// `fn(center, radii, window)`.
///
/// They give the pixels in the window, each once, or an error for a semi-axis that the algorithm cannot draw.
///
/// | algorithm | pixels | take it when |
/// |---|---|---|
/// | [`midpoint`](Self::midpoint) | nearest to the ellipse | as the pattern for other curves |
/// | [`square_root`](Self::square_root) | as the midpoint rule's | to check the others, and for single pixels |
/// | [`parametric`](Self::parametric) | up to 0.72 pixel off | for points at equal steps of the parameter |
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ellipses;
