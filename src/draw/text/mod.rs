//! Antialiased text: fonts of coverage masks and fonts of outlines, which lie in flash, and the text styles that draw them.
//!
//! `cargo run --release -- font FILE.ttf --size 24 --chars '0-9.:°C'` in zrow's repository writes a font of masks as a Rust
//! module. A mask says in 4 bits how much of each pixel a glyph covers, so that drawing is blending:
//!
//! ```text
//!   a row of the mask of "o":   0 3 b f f b 3 0        half a byte a pixel, the left one in the upper half
//!   each times 17:              0 51 187 255 ...       the alpha with which the text's colour is blended
//! ```
//!
//! With `--outlines` instead of a size it writes a font of outlines, which is drawn in any size: the outline of each glyph is
//! scaled and flattened where it is met, and its coverage is the exact area.

mod character_tables;
mod glyph_outline;
mod line;
mod line_fill;
mod mask_font;
mod mask_row;
mod mask_text;
mod mask_text_style;
mod outline_font;
mod outline_text;
mod outline_text_style;
mod scale;
mod sized_font;
mod text_outline;
mod text_renderer;

pub(in crate::draw) use line::{Line, LineFont, LineStyle, Lines};
pub use mask_font::{MaskFont, MaskGlyph};
pub(in crate::draw) use mask_row::blend_mask_row;
pub use mask_text_style::MaskTextStyle;
pub use outline_font::{OutlineFont, OutlineGlyph};
pub use outline_text_style::OutlineTextStyle;
pub(in crate::draw) use scale::Scale;
pub(in crate::draw) use sized_font::SizedFont;
