//! Shapes of zrow's own.

mod flood_fill;
mod path;
mod points;
mod polygon;
mod thin_circle;

pub use flood_fill::{Connectivity, SeedFill};
pub use path::{Path, PathCommand, PreparedPath};
pub use points::Points;
pub use polygon::{Polygon, PreparedPolygon};
pub use thin_circle::ThinCircle;
