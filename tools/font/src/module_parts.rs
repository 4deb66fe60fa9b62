//! What the modules of all fonts have: their head, and the tables of characters and of kerning.

use std::fmt::Write;

use crate::font::{Names, Pair};

/// Columns of the module's comments at most.
const COLUMNS: usize = 100;

/// Names that modules have for their own tables.
const RESERVED: [&str; 6] = ["RANGES", "GLYPHS", "KERNING", "COVERAGE", "POINTS", "FLAGS"];

/// What the head of each written module says.
pub const MARK: &str = "Written by zrow's converter";

/// Where a module comes from: what is written into its head.
#[derive(Debug, Copy, Clone)]
pub struct Origin<'a> {
    /// The name of the font's file, without folders.
    pub file: &'a str,
    /// The characters as they were typed.
    pub characters: &'a str,
    /// The name that was chosen with `--name`.
    pub name: Option<&'a str>,
}

/// The name of a `static`, of the letters and digits of a text, such as `DEJAVU_SANS_24`.
pub fn name_of(text: &str) -> String {
    let mut name = String::new();
    for character in text.chars() {
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

/// Whether a text can be the name of a module's `static`.
pub fn is_name(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_uppercase())
        && text
            .chars()
            .all(|character| character.is_ascii_uppercase() || character.is_ascii_digit() || character == '_')
        && !RESERVED.contains(&text)
}

/// Characters that follow each other: the first one, how many they are, and the index of the first one's glyph.
pub fn ranges(characters: impl Iterator<Item = char>) -> Vec<(char, u16, u16)> {
    let mut ranges: Vec<(char, u16, u16)> = Vec::new();
    for (index, character) in (0u16..).zip(characters) {
        match ranges.last_mut() {
            Some((first, count, _)) if u32::from(*first) + u32::from(*count) == u32::from(character) => *count += 1,
            _ => ranges.push((character, 1, index)),
        }
    }
    ranges
}

/// Family and style of a font, without characters that have a meaning in documentation.
pub fn title(names: &Names) -> String {
    let family = plain(&names.family);
    match names.style.as_str() {
        "" => family,
        style => format!("{family} {style}"),
    }
}

/// Adds the arguments of choices that all fonts have.
pub fn add_choices(arguments: &mut String, kerning: bool, replacement: Option<char>) {
    if !kerning {
        arguments.push_str(" --no-kerning");
    }
    if let Some(replacement) = replacement {
        arguments.push_str(" --replacement ");
        arguments.push_str(&quoted(&replacement.to_string()));
    }
}

/// What the module is, how it was made, and what the font says about its licence.
pub fn head(names: &Names, title: &str, origin: Origin<'_>, arguments: &str) -> String {
    let mut head = String::new();
    add_comment(&mut head, "//!", title);
    head.push_str("//!\n");
    add_comment(&mut head, "//!", &format!("{MARK}; do not edit it, but convert again:"));
    let file = quoted_if_needed(&plain(origin.file));
    let name = origin.name.map(|name| format!(" --name {name}")).unwrap_or_default();
    let _ = writeln!(
        head,
        "//! ```text\n//! cargo run --release -- font {file} {arguments}{name}\n//! ```\n"
    );
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

/// Writes the index of the replacement, and ends the font.
pub fn write_replacement(to: &mut String, replacement: Option<usize>) -> std::fmt::Result {
    match replacement {
        Some(index) => writeln!(to, "    replacement: Some({index}),")?,
        None => writeln!(to, "    replacement: None,")?,
    }
    writeln!(to, "}};")
}

/// Writes the table of characters.
pub fn write_ranges(to: &mut String, ranges: &[(char, u16, u16)]) -> std::fmt::Result {
    writeln!(to, "\n#[rustfmt::skip]")?;
    writeln!(to, "static RANGES: [(char, u16, u16); {}] = [", ranges.len())?;
    for (first, count, glyph) in ranges {
        writeln!(to, "    ({first:?}, {count}, {glyph}),")?;
    }
    writeln!(to, "];")
}

/// Writes the table of kerning, if it has pairs.
pub fn write_kerning(to: &mut String, kerning: &[Pair]) -> std::fmt::Result {
    if kerning.is_empty() {
        return Ok(());
    }
    writeln!(to, "\n#[rustfmt::skip]")?;
    writeln!(to, "static KERNING: [(u16, u16, i16); {}] = [", kerning.len())?;
    for (left, right, adjustment) in kerning {
        writeln!(to, "    ({left}, {right}, {adjustment}),")?;
    }
    writeln!(to, "];")
}

/// Text in which no character has a meaning in documentation.
pub fn plain(text: &str) -> String {
    let is_plain = |character: &char| character.is_alphanumeric() || " .,-_+&'()".contains(*character);
    text.chars().filter(is_plain).collect()
}

/// An argument as a shell takes it; line ends, which no comment holds, become spaces.
pub fn quoted(argument: &str) -> String {
    let shown: String = argument
        .chars()
        .map(|character| if character.is_control() { ' ' } else { character })
        .collect();
    format!("'{}'", shown.replace('\'', r"'\''"))
}

/// An argument as a shell takes it, without quotes where it takes it so.
fn quoted_if_needed(argument: &str) -> String {
    let is_word = |character: char| character.is_alphanumeric() || ".-_+".contains(character);
    if argument.chars().all(is_word) && !argument.is_empty() {
        return argument.to_owned();
    }
    quoted(argument)
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
