//! The Rust module of a converted font, formatted as rustfmt would.

use std::fmt::Write;

use crate::font::{Converted, Decoration, Hinting, Options};

/// Columns of the module's comments at most.
const COLUMNS: usize = 100;

/// Where a module comes from: what is written into its head.
#[derive(Debug, Copy, Clone)]
pub struct Origin<'a> {
    /// The name of the font's file, without folders.
    pub file: &'a str,
    /// The characters as they were typed.
    pub characters: &'a str,
}

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

/// The name of a font's `static`, such as `DEJAVU_SANS_24`.
pub fn static_name(family: &str, size: f32) -> String {
    let mut name = String::new();
    for character in format!("{family} {size}").chars() {
        if character.is_ascii_alphanumeric() {
            name.push(character.to_ascii_uppercase());
        } else if !name.ends_with('_') && !name.is_empty() {
            name.push('_');
        }
    }
    if name.starts_with(|first: char| first.is_ascii_digit()) {
        name.insert_str(0, "FONT_");
    }
    name
}

/// Characters that follow each other: the first one, how many they are, and the index of the first one's glyph.
fn ranges(font: &Converted) -> Vec<(char, u16, u16)> {
    let mut ranges: Vec<(char, u16, u16)> = Vec::new();
    for (index, glyph) in (0u16..).zip(&font.glyphs) {
        match ranges.last_mut() {
            Some((first, count, _)) if u32::from(*first) + u32::from(*count) == u32::from(glyph.character) => {
                *count += 1
            }
            _ => ranges.push((glyph.character, 1, index)),
        }
    }
    ranges
}

/// Writes a font as a module with a `static` of that name.
pub fn write(font: &Converted, options: &Options, name: &str, origin: Origin<'_>) -> Module {
    let ranges = ranges(font);
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

/// What the module is, what the font says about its licence, and how the module was made.
fn head(font: &Converted, options: &Options, origin: Origin<'_>, bytes: usize) -> String {
    let names = &font.names;
    let style = match names.style.as_str() {
        "" => String::new(),
        style => format!(" {style}"),
    };
    let size = options.size;
    let mut head = String::new();
    let title = format!(
        "{}{style} at {size} px: coverage masks of {} characters, {} bytes of flash.",
        plain(&names.family),
        font.glyphs.len(),
        grouped(bytes)
    );
    add_comment(&mut head, "//!", &title);
    head.push_str("//!\n");
    add_comment(
        &mut head,
        "//!",
        "Written by zrow's converter; do not edit it, but convert again:",
    );
    head.push_str("//! ```text\n");
    let mut command = format!(
        "cargo run --release -- font {} --size {size} --chars {}",
        plain(origin.file),
        quoted(origin.characters)
    );
    if options.hinting == Hinting::Vertical {
        command.push_str(" --hinting vertical");
    }
    if !options.kerning {
        command.push_str(" --no-kerning");
    }
    if let Some(replacement) = options.replacement {
        let _ = write!(command, " --replacement {}", quoted(&replacement.to_string()));
    }
    let _ = writeln!(head, "//! {command}\n//! ```\n");
    for (title, text) in [
        ("Copyright", &names.copyright),
        ("Licence", &names.licence),
        ("Licence at", &names.licence_url),
    ] {
        if !text.is_empty() {
            add_comment(&mut head, "//", &format!("{title}, as the font says: {text}"));
        }
    }
    if names.copyright.is_empty() && names.licence.is_empty() {
        add_comment(
            &mut head,
            "//",
            "The font says nothing about its copyright and licence.",
        );
    }
    head.push('\n');
    head
}

/// Text in which no character has a meaning in documentation.
fn plain(text: &str) -> String {
    let is_plain = |character: &char| character.is_alphanumeric() || " .,-_+&'()".contains(*character);
    text.chars().filter(is_plain).collect()
}

/// An argument as a shell takes it; line ends, which no comment holds, become spaces.
fn quoted(argument: &str) -> String {
    let shown: String = argument
        .chars()
        .map(|character| if character.is_control() { ' ' } else { character })
        .collect();
    format!("'{}'", shown.replace('\'', r"'\''"))
}

/// Adds a comment in lines of up to [`COLUMNS`] columns.
fn add_comment(to: &mut String, prefix: &str, text: &str) {
    let mut columns = 0;
    for word in text.split_whitespace() {
        let width = word.chars().count();
        if columns == 0 || columns + 1 + width > COLUMNS {
            if columns > 0 {
                to.push('\n');
            }
            to.push_str(prefix);
            columns = prefix.len();
        }
        to.push(' ');
        to.push_str(word);
        columns += 1 + width;
    }
    to.push('\n');
}

/// A number with commas between thousands.
pub fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut grouped = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped
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
    let replacement = options
        .replacement
        .and_then(|replacement| font.glyphs.iter().position(|glyph| glyph.character == replacement));
    match replacement {
        Some(index) => writeln!(to, "    replacement: Some({index}),")?,
        None => writeln!(to, "    replacement: None,")?,
    }
    writeln!(to, "}};\n\n#[rustfmt::skip]")?;
    writeln!(to, "static RANGES: [(char, u16, u16); {}] = [", ranges.len())?;
    for (first, count, glyph) in ranges {
        writeln!(to, "    ({first:?}, {count}, {glyph}),")?;
    }
    writeln!(to, "];\n\n#[rustfmt::skip]")?;
    write_glyphs(to, font, masks)?;
    if !font.kerning.is_empty() {
        writeln!(
            to,
            "\n#[rustfmt::skip]\nstatic KERNING: [(u16, u16, i16); {}] = [",
            font.kerning.len()
        )?;
        for (left, right, adjustment) in &font.kerning {
            writeln!(to, "    ({left}, {right}, {adjustment}),")?;
        }
        writeln!(to, "];")?;
    }
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
