//! Round shapes, row by row: circles, ellipses, rounded corners and sectors.
//!
//! Thin circles are functions with the signature `fn(center, radius, window)`: [`bresenham_circle()`] draws by default, and
//! the others are kept to compare them. Thin ellipses have the signature `fn(center, radii, window)`. All give the pixels in
//! the window, or [`RadiusTooLarge`].

pub(crate) mod bresenham_circle;
pub(crate) mod circle;
pub(crate) mod ellipse;
mod forward_difference;
mod half_plane;
pub(crate) mod plane_sector;
mod radius;
pub(crate) mod rounded_corners;
mod sector_bounds;
mod siblings;
mod symmetric_rows;

pub use bresenham_circle::bresenham_circle;
pub use radius::RadiusTooLarge;
pub use siblings::*;

pub(crate) use forward_difference::{CurveNumber, ForwardDifference};
pub(crate) use symmetric_rows::{Curve, SymmetricRows};
