//! The Rust module of a converted font, formatted as rustfmt would.

use std::fmt::Write;

use crate::{
    font::{Converted, Decoration, Hinting, Options},
    module_parts::{self, Origin, grouped, plain, quoted},
};

/// A module, and how many bytes of flash its tables take.
#[derive(Debug, Clone)]
pub struct Module {
    /// The Rust source.
    pub source: String,
    /// Bytes of the masks.
    pub mask_bytes: usize,
    /// Bytes of all tables.
    pub bytes: usize,
}

/// Writes a font as a module with a `static` of that name.
pub fn write(font: &Converted, options: &Options, name: &str, origin: Origin<'_>) -> Module {
    let ranges = module_parts::ranges(font.glyphs.iter().map(|glyph| glyph.character));
    let masks: Vec<Vec<u8>> = font.glyphs.iter().map(|glyph| glyph.mask.bytes()).collect();
    let mask_bytes = masks.iter().map(Vec::len).sum();
    let bytes = mask_bytes + 12 * font.glyphs.len() + 6 * font.kerning.len() + 8 * ranges.len();
    let mut source = head(font, options, origin, bytes);
    // Writing to a string does not fail.
    let _ = write_tables(&mut source, font, options, name, &ranges, &masks, mask_bytes);
    Module {
        source,
        mask_bytes,
        bytes,
    }
}

/// The name of a font's `static`, such as `DEJAVU_SANS_24`.
pub fn static_name(family: &str, size: f32) -> String {
    module_parts::name_of(&format!("{family} {size}"))
}

fn head(font: &Converted, options: &Options, origin: Origin<'_>, bytes: usize) -> String {
    let size = options.size;
    let title = format!(
        "{} at {size} px: coverage masks of {} characters, {} bytes of flash.",
        module_parts::title(&font.names),
        font.glyphs.len(),
        grouped(bytes)
    );
    let mut arguments = format!("--size {size} --chars {}", quoted(origin.characters));
    if options.hinting == Hinting::Vertical {
        arguments.push_str(" --hinting vertical");
    }
    module_parts::add_choices(&mut arguments, options.kerning, options.replacement);
    module_parts::head(&font.names, &title, origin, &arguments)
}

fn write_tables(
    to: &mut String,
    font: &Converted,
    options: &Options,
    name: &str,
    ranges: &[(char, u16, u16)],
    masks: &[Vec<u8>],
    mask_bytes: usize,
) -> std::fmt::Result {
    writeln!(to, "use embedded_graphics::mono_font::DecorationDimensions;")?;
    writeln!(to, "use zrow::draw::{{MaskFont, MaskGlyph}};\n")?;
    writeln!(to, "/// {} at {} px.", plain(&font.names.family), options.size)?;
    writeln!(to, "pub static {name}: MaskFont = MaskFont {{")?;
    writeln!(
        to,
        "    ranges: &RANGES,\n    glyphs: &GLYPHS,\n    coverage: &COVERAGE,"
    )?;
    writeln!(
        to,
        "    kerning: {},",
        if font.kerning.is_empty() { "&[]" } else { "&KERNING" }
    )?;
    writeln!(to, "    height: {},", font.above + font.below)?;
    writeln!(to, "    baseline: {},", font.above.saturating_sub(1))?;
    writeln!(to, "    line_height: {},", font.line_height)?;
    for (field, Decoration { offset, height }) in [("underline", font.underline), ("strikethrough", font.strikethrough)]
    {
        let offset = i32::from(font.above) + offset;
        writeln!(to, "    {field}: DecorationDimensions::new({offset}, {height}),")?;
    }
    let index = |replacement| font.glyphs.iter().position(|glyph| glyph.character == replacement);
    module_parts::write_replacement(to, options.replacement.and_then(index))?;
    module_parts::write_ranges(to, ranges)?;
    writeln!(to, "\n#[rustfmt::skip]")?;
    write_glyphs(to, font, masks)?;
    module_parts::write_kerning(to, &font.kerning)?;
    writeln!(to, "\n#[rustfmt::skip]\nstatic COVERAGE: [u8; {mask_bytes}] = [")?;
    for (glyph, mask) in font.glyphs.iter().zip(masks) {
        if mask.is_empty() {
            continue;
        }
        writeln!(to, "    // {:?}", glyph.character)?;
        let row = (glyph.mask.window.width() as usize).div_ceil(2);
        for bytes in mask.chunks(row) {
            let numbers: Vec<String> = bytes.iter().map(|byte| format!("0x{byte:02x},")).collect();
            writeln!(to, "    {}", numbers.join(" "))?;
        }
    }
    writeln!(to, "];")
}

fn write_glyphs(to: &mut String, font: &Converted, masks: &[Vec<u8>]) -> std::fmt::Result {
    writeln!(to, "static GLYPHS: [MaskGlyph; {}] = [", font.glyphs.len())?;
    let mut offset = 0;
    for (glyph, mask) in font.glyphs.iter().zip(masks) {
        let window = glyph.mask.window;
        let top = if window.is_empty() {
            0
        } else {
            i32::from(font.above) + window.top
        };
        writeln!(
            to,
            "    MaskGlyph {{ offset: {offset}, left: {}, top: {top}, width: {}, height: {}, advance: {} }}, // {:?}",
            window.left,
            window.width(),
            window.height(),
            glyph.advance,
            glyph.character
        )?;
        offset += mask.len();
    }
    writeln!(to, "];")
}
