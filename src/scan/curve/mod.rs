//! Bézier curves, and how they become straight lines.
//!
//! [`adaptive_forward_difference`] flattens by default; the others are kept to compare them.

pub mod adaptive_forward_difference;
pub mod bezier;
pub mod flatten;
pub mod polynomial_forward_difference;
mod siblings;

pub use bezier::{Bezier, Cubic, Quadratic};
pub use polynomial_forward_difference::{PolynomialForwardDifference, StepTooFine};
pub use siblings::{de_casteljau, uniform_subdivision};
