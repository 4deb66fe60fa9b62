//! `zrow::draw`.

pub mod antialiased;
pub mod closed;
pub mod fills;
pub mod lines;
pub mod pictures;
pub mod polygons;
pub mod strokes;
pub mod styles;
pub mod texts;
