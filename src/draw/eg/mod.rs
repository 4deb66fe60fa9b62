//! embedded-graphics' primitives and its text in monospaced fonts, drawn by zrow's scan conversion.

mod arc;
pub(crate) mod areas;
pub(crate) mod circle;
mod ellipse;
pub(super) mod font_glyphs;
pub(super) mod glyph_bits;
pub(super) mod image_bytes;
mod line;
pub(crate) mod polyline;
pub(crate) mod rectangle;
mod rounded_rectangle;
mod styled_areas;
mod styled_pixels;
pub(super) mod text;
pub(super) mod text_lines;
mod triangle;

pub use styled_areas::StyledAreas;
pub use styled_pixels::StyledPixels;
