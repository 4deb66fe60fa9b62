//! The family of ways to flatten curves, which each algorithm's file adds a function to.

/// Flattening: a Bézier curve becomes straight lines that are nowhere further from it than a tolerance. A function for each
/// algorithm, all with the signature `fn(&curve, tolerance)`.
///
/// They give the ends of the lines; the first line begins at the first control point.
///
/// | algorithm | how | take it when |
/// |---|---|---|
/// | [`adaptive_forward_difference`](Self::adaptive_forward_difference) | the step grows and shrinks | lines are drawn: the default, fewest lines and no table |
/// | [`de_casteljau`](Self::de_casteljau) | halves the curve until its parts are flat | halves of curves are wanted by themselves; it gives the same lines |
/// | [`uniform_subdivision`](Self::uniform_subdivision) | equal steps, their number known before | the number of lines must be known, or lines are cheap |
///
/// A cubic with random control points on a display takes a third more lines by equal steps, and half the time to find them.
///
/// Guarantees of all three:
/// - each point of the curve has a point of the lines within the tolerance, and each of the lines one of the curve (their
///   Fréchet distance); the rounding of the ends to 1/256 pixel is included. The smallest tolerance that can be kept is
///   2/256 pixel, and smaller ones count as that;
/// - the last line ends exactly at the last control point;
/// - the reversed curve has the same lines, reversed;
/// - any curve in the domain of [`Sub8`](crate::geometry::Sub8): at most 4,096 lines, no number overflows.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Curves;
