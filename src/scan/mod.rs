//! Scan conversion: every shape becomes horizontal spans or the steps of a line. No colour here; a folder for each family
//! of shapes, a file for each algorithm.
//!
//! A family is a type with a function for each of its algorithms: [`Lines`], [`Conics`], [`Bezier`],
//! [`Polygons`]. The algorithms of one family share a signature, and the page of the type
//! says when to take which.

pub(crate) mod curve;
pub(crate) mod line;
pub(crate) mod polygon;
pub(crate) mod round;
pub(crate) mod stroke;
pub(crate) mod triangle;

pub use curve::{Bezier, PolynomialForwardDifference};
pub use line::Lines;
pub use polygon::{FillRule, Location, Polygons};
pub use round::Conics;
