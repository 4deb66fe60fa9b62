//! Antialiased shapes: outlines at 1/256 pixel, prepared as polygons and drawn by a coverage method or by samples, and
//! filtered lines.

mod antialiased_target;
mod arcs;
mod closed_shapes;
mod coverage_choice;
mod filtered_line;
mod layers;
mod multisampled;
mod polygon;
mod polygons;
mod round_outline;
mod strokes;
mod sub_ellipse;
mod sub_line;
mod sub_outline;
mod triangles;

pub(crate) use antialiased_target::draw_error;
pub use antialiased_target::{AntialiasedTarget, DrawAntialiased};
pub use filtered_line::FilteredLine;
#[cfg(test)]
pub(crate) use layers::OutlinedShape;
pub(crate) use layers::{Layer, LayerSink};
pub use polygon::AntialiasedPolygon;
pub(crate) use polygon::DOMAIN;
pub(crate) use round_outline::{ARC_WORDS, Axis, OutlineArc, RoundContour, RoundOutline};
pub use sub_ellipse::{SubArc, SubEllipse};
pub use sub_line::SubLine;
pub use sub_outline::SubOutline;
