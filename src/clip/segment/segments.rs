//! The family of segment clippers, which each algorithm's file adds a function to.

/// What of a segment lies inside a window: a function for each algorithm, all with the signature `fn(from, to, window)`.
///
/// Against an upright window they give the two ends of what is inside, the same integers by every algorithm;
/// [`cyrus_beck`](Self::cyrus_beck) takes a convex window, and gives exact fractions of the segment. So do those in space,
/// between vertices of a model, which take the matrix of a camera instead of a window, or planes.
///
/// | algorithm | window | take it when |
/// |---|---|---|
/// | [`liang_barsky`](Self::liang_barsky) | upright | by default |
/// | [`cohen_sutherland`](Self::cohen_sutherland) | upright | flash counts |
/// | [`nicholl_lee_nicholl`](Self::nicholl_lee_nicholl) | upright | to see how areas of the plane decide |
/// | [`midpoint_subdivision`](Self::midpoint_subdivision) | upright | nothing multiplies or divides |
/// | [`cyrus_beck`](Self::cyrus_beck) | convex | the window is not upright, or there are several |
/// | [`homogeneous_liang_barsky`](Self::homogeneous_liang_barsky) | a camera | in space, by default |
/// | [`homogeneous_cohen_sutherland`](Self::homogeneous_cohen_sutherland) | a camera | most segments are inside or on one side |
/// | [`eye_space`](Self::eye_space) | a camera | to see that homogeneous clipping is clipping in space |
/// | [`cyrus_beck_in_space`](Self::cyrus_beck_in_space) | convex volume | planes bound something else: a room, a portal |
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Segments;
