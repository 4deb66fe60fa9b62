//! Bézier curves, and how they become straight lines: `curves` says which algorithm is for what, and each has a file.

pub(crate) mod adaptive_forward_difference;
pub(crate) mod bezier;
pub(crate) mod curves;
mod flatten;
mod polynomial_forward_difference;
mod siblings;

pub use bezier::Bezier;
pub use curves::Curves;
pub use polynomial_forward_difference::PolynomialForwardDifference;
