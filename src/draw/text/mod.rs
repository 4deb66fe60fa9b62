//! Antialiased text: fonts of coverage masks, which lie in flash, and the text style that draws them.
//!
//! `cargo run --release -- font FILE.ttf --size 24 --chars '0-9.:°C'` in zrow's repository writes such a font as a Rust
//! module. A mask says in 4 bits how much of each pixel a glyph covers, so that drawing is blending:
//!
//! ```text
//!   a row of the mask of "o":   0 3 b f f b 3 0        half a byte a pixel, the left one in the upper half
//!   each times 17:              0 51 187 255 ...       the alpha with which the text's colour is blended
//! ```

mod line;
mod mask_font;
mod mask_row;
mod mask_text;
mod mask_text_style;
mod text_renderer;

pub(in crate::draw) use line::{Line, Lines};
pub use mask_font::{MaskFont, MaskGlyph};
pub(in crate::draw) use mask_row::blend_mask_row;
pub use mask_text_style::MaskTextStyle;
