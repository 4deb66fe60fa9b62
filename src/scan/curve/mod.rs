//! Bézier curves, and how they become straight lines: [`Bezier`] says which algorithm is for what, and each has a file.

pub(crate) mod adaptive_forward_difference;
pub(crate) mod bezier;
mod flatten;
pub(crate) mod parabola;
mod polynomial_forward_difference;
mod siblings;

pub use bezier::Bezier;
pub use polynomial_forward_difference::PolynomialForwardDifference;
