//! Shapes that embedded-graphics does not have: polygons, paths of curves, thin circles, markers, and seed fills.

mod flat_steps;
mod flood_fill;
mod path;
mod path_command;
mod points;
mod polygon;
mod thin_circle;

pub(crate) use flat_steps::{FlatPoint, FlatStep, nearest_pixel};
pub use flood_fill::SeedFill;
pub use path::Path;
pub use path_command::PathCommand;
pub use points::Points;
pub use polygon::Polygon;
pub use thin_circle::ThinCircle;
