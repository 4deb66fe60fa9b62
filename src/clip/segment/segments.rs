//! The family of segment clippers, which each algorithm's file adds a function to.

/// What of a segment lies inside a window: a function for each algorithm, all with the signature `fn(from, to, window)`.
///
/// Against an upright window they give the two ends of what is inside, the same integers by every algorithm;
/// [`cyrus_beck`](Self::cyrus_beck) takes a convex window, and gives exact fractions of the segment.
///
/// | algorithm | window | take it when |
/// |---|---|---|
/// | [`liang_barsky`](Self::liang_barsky) | upright | by default |
/// | [`cohen_sutherland`](Self::cohen_sutherland) | upright | flash counts |
/// | [`nicholl_lee_nicholl`](Self::nicholl_lee_nicholl) | upright | to see how areas of the plane decide |
/// | [`midpoint_subdivision`](Self::midpoint_subdivision) | upright | nothing multiplies or divides |
/// | [`cyrus_beck`](Self::cyrus_beck) | convex | the window is not upright, or there are several |
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Segments;
