//! `zrow::draw`.

pub mod antialiased;
pub mod closed;
pub mod fills;
pub mod lines;
pub mod outline_texts;
pub mod pictures;
pub mod polygons;
pub mod strokes;
pub mod styles;
mod text_look;
pub mod texts;
