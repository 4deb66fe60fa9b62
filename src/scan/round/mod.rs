//! Round shapes, row by row: circles, ellipses, rounded corners and sectors.
//!
//! [`Conics`] is the family of the thin ones; what is filled or thick comes from rows that are symmetric
//! about the center.

pub(crate) mod bresenham_circle;
pub(crate) mod circle;
mod conics;
pub(crate) mod ellipse;
mod forward_difference;
mod half_plane;
pub(crate) mod plane_sector;
mod radius;
pub(crate) mod rounded_corners;
mod sector_bounds;
mod siblings;
mod symmetric_rows;

pub use conics::Conics;

pub(crate) use forward_difference::{CurveNumber, ForwardDifference};
pub(crate) use symmetric_rows::{Curve, SymmetricRows};
