//! Antialiased shapes: outlines at 1/256 pixel, prepared as polygons and drawn by a coverage method or by samples, and
//! filtered lines.

mod aligned_strokes;
mod antialiased_target;
mod arc_turns;
mod arcs;
mod closed_shapes;
mod coverage_choice;
mod edges_in_rows;
mod filtered_line;
mod layers;
mod multisampled;
mod outline_arc;
mod polygon;
mod polygons;
mod round_outline;
mod strokes;
mod sub_ellipse;
mod sub_line;
mod sub_outline;
mod triangles;
mod turn;

pub use antialiased_target::DrawAntialiased;
pub(crate) use antialiased_target::{AntialiasedTarget, draw_error};
pub(crate) use arc_turns::Axis;
pub use filtered_line::FilteredLine;
#[cfg(test)]
pub(crate) use layers::OutlinedShape;
pub(crate) use layers::{AlignedSink, Layer, LayerSink};
pub(crate) use outline_arc::{ARC_WORDS, OutlineArc};
pub use polygon::AntialiasedPolygon;
pub(crate) use polygon::DOMAIN;
pub(crate) use round_outline::{RoundContour, RoundOutline};
pub use sub_ellipse::{SubArc, SubEllipse};
pub use sub_line::SubLine;
pub use sub_outline::SubOutline;
