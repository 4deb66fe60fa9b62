//! Segments and polygons against convex windows and planes.

pub(crate) mod convex_crossing;
pub mod cyrus_beck;
mod sutherland_hodgman;
pub mod sutherland_hodgman_2d;
mod unit_cell;

pub(crate) use sutherland_hodgman::{Plane, Polygon, sutherland_hodgman};
