//! Round shapes, row by row: circles, ellipses, rounded corners and sectors.
//!
//! Thin circles have siblings with the signature `circle(center, radius, window)`: [`bresenham_circle`] draws by default, and
//! the others are kept to compare them. Thin ellipses are siblings with the signature `ellipse(center, radii, window)`.

pub mod bresenham_circle;
pub mod circle;
pub mod ellipse;
mod forward_difference;
mod half_plane;
pub mod plane_sector;
mod radius;
pub mod rounded_corners;
mod sector_bounds;
mod siblings;
mod symmetric_rows;

pub use radius::RadiusTooLarge;
pub use siblings::{
    midpoint_circle, midpoint_ellipse, parametric_circle, parametric_ellipse, square_root_circle, square_root_ellipse,
};

pub(crate) use forward_difference::{CurveNumber, ForwardDifference};
pub(crate) use symmetric_rows::{Curve, SymmetricRows};
