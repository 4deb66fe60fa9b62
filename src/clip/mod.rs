//! Clipping: outcodes decide what can be skipped, one file per algorithm cuts the rest.
//!
//! Which drawing path calls which: shapes of whole pixels (lines, polylines, circles, ...) are never cut. Their
//! [`Outcode`]s or bounding boxes say whether they are visible, and the scan conversion then enters the window with an
//! exact error term, so clipping moves no pixel. The segment clippers serve sub-pixel segments, and whoever needs the
//! visible part of one: [`liang_barsky`] by default, [`cohen_sutherland`] where most segments are wholly inside; both
//! give the same integers. Faces of a scene are cut where they cross the near plane or leave the guard band.

mod crossing;
mod outcode;
mod sutherland_hodgman;

pub mod cohen_sutherland;
pub mod liang_barsky;

pub use outcode::Outcode;

pub(crate) use sutherland_hodgman::{Plane, Polygon, sutherland_hodgman};
