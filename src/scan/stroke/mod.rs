//! Strokes: the polygons and discs along a path, its dashes, caps and joins.

pub(crate) mod dash_pattern;
mod dense_dashes;
mod disc_side;
pub(crate) mod disc_walk;
pub(crate) mod grouped_primitives;
mod line_cap;
pub(crate) mod line_join;
pub(crate) mod numbered_shapes;
mod pen;
pub(crate) mod primitive;
mod segment_dashes;
pub(crate) mod stroke_edge;
pub(crate) mod styled_stroke;
pub(crate) mod wide_stroke;
#[cfg(test)]
pub(crate) mod work;

pub(crate) use dash_pattern::DashPattern;
pub(crate) use disc_side::DiscSide;
pub use line_cap::LineCap;
pub use line_join::LineJoin;
