//! Segments and polygons against convex windows and planes: Cyrus and Beck's algorithm cuts segments,
//! [`ConvexWindow::sutherland_hodgman_2d`](crate::geometry::ConvexWindow::sutherland_hodgman_2d) polygons.

pub(crate) mod convex_crossing;
mod cyrus_beck;
mod sutherland_hodgman;
mod sutherland_hodgman_2d;
mod unit_cell;

pub use cyrus_beck::ParametricSegment;
pub use sutherland_hodgman::CutAttributes;
pub(crate) use sutherland_hodgman::{Plane, Polygon, PolygonCorner, cut_segment, sutherland_hodgman};
