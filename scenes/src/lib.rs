//! Demo scenes, shared by every board: the same code draws on the desktop and in firmware.
//!
//! One file holds one scene. [`Scene`] is the shape they share, and [`visit`] walks through all of them.
#![no_std]
#![forbid(unsafe_code)]

pub mod antialiased;
pub mod arcs;
pub mod booleans;
#[cfg(not(target_os = "none"))]
mod catalogue;
pub mod clipping;
pub mod cockpit;
pub mod curves;
pub mod dashboard;
pub mod effects;
pub mod fill_siblings;
pub mod flight;

pub mod fonts;
pub mod gauge;
pub mod gem;
pub mod hidden;
pub mod instruments;
pub mod line_siblings;
pub mod meshes;
pub mod multisampled;
pub mod needle;
pub mod oled;
pub mod oled_teapot;
mod paint;
pub mod paints;
pub mod panes;
mod picture_capacities;
mod picture_memory;
pub mod polygons;
pub mod samples;
mod scene;
pub mod segment_siblings;
pub mod shapes;
#[cfg(test)]
mod shown;
mod sine;
pub mod squares;
pub mod standard;
pub mod strokes;
pub mod teapot;
pub mod teapots;
// Draws one picture by nine methods, for whom a chip has no use: in its program they would be compiled for nothing.
#[cfg(not(target_os = "none"))]
pub mod visibility;

#[cfg(not(target_os = "none"))]
pub use catalogue::{NAMES, Visitor, visit};
pub use picture_capacities::PictureCapacities;
pub use scene::{PrepareError, Prepared, Scene};
