//! Round shapes, row by row: circles, ellipses, rounded corners and sectors.

pub mod bresenham_circle;
pub mod circle;
pub mod ellipse;
mod forward_difference;
mod half_plane;
pub mod plane_sector;
pub mod rounded_corners;
mod sector_bounds;
mod symmetric_rows;

pub(crate) use forward_difference::{CurveNumber, ForwardDifference};
pub(crate) use symmetric_rows::{Curve, SymmetricRows};
