//! Converts a TrueType or OpenType font to coverage masks or outlines for zrow, written as a Rust module.
//!
//! Outlines, metrics and kerning are read by skrifa. For masks, each glyph's outline is scaled, flattened and rounded to 1/256
//! pixel; zrow's exact area gives the coverage of each pixel by the nonzero rule, and that is rounded to 4 bits. For outlines,
//! cubic curves become quadratic ones, and points are rounded to whole units.

pub mod characters;
pub mod crossing;
pub mod font;
pub mod kerning;
pub mod mask;
pub mod module;
pub mod module_parts;
pub mod outline;
pub mod outline_module;
pub mod outlines;
pub mod quadratics;
