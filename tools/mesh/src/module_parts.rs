//! Names, numbers and lines of the written module.

use std::fmt::Write;

/// Columns of the lines of tables at most.
const COLUMNS: usize = 100;

/// Names that the module has for its own tables.
const RESERVED: [&str; 2] = ["VERTICES", "FACES"];

/// The name of a `static`, of the letters and digits of a text, such as `TEA_POT`; empty where there are none.
pub fn name_of(text: &str) -> String {
    let mut name = String::new();
    for character in text.chars() {
        if character.is_ascii_alphanumeric() {
            name.push(character.to_ascii_uppercase());
        } else if !name.ends_with('_') && !name.is_empty() {
            name.push('_');
        }
    }
    while name.ends_with('_') {
        name.pop();
    }
    if name.starts_with(|first: char| first.is_ascii_digit()) || RESERVED.contains(&name.as_str()) {
        name.insert_str(0, "MESH_");
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

/// Red, green and blue from 0 to 1, rounded to 5, 6 and 5 bits.
pub fn rgb565(color: [f64; 3]) -> [u8; 3] {
    let [red, green, blue] = color;
    [red * 31.0, green * 63.0, blue * 31.0].map(|component| component.round() as u8)
}

/// Text in which no character has a meaning in documentation.
pub fn plain(text: &str) -> String {
    let is_plain = |character: &char| character.is_alphanumeric() || " .,-_+&'()".contains(*character);
    text.chars().filter(is_plain).collect()
}

/// An argument as a shell takes it.
pub fn quoted(argument: &str) -> String {
    let is_word = |character: char| character.is_alphanumeric() || ".-_+".contains(character);
    if argument.chars().all(is_word) && !argument.is_empty() {
        return argument.to_owned();
    }
    format!("'{}'", argument.replace('\'', r"'\''"))
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

/// Writes entries in lines of up to 100 columns.
pub fn write_lines(to: &mut String, entries: impl Iterator<Item = String>) -> std::fmt::Result {
    let mut columns = 0;
    for entry in entries {
        if columns > 0 && columns + 1 + entry.len() <= COLUMNS {
            write!(to, " {entry}")?;
            columns += 1 + entry.len();
        } else {
            write!(to, "{}    {entry}", if columns > 0 { "\n" } else { "" })?;
            columns = 4 + entry.len();
        }
    }
    writeln!(to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_names_of_statics() {
        for (text, name) in [
            ("tea-pot (2)", "TEA_POT_2"),
            ("3d cube", "MESH_3D_CUBE"),
            ("vertices", "MESH_VERTICES"),
            ("_x_", "X"),
        ] {
            assert_eq!(name_of(text), name);
            assert!(is_name(name));
        }
        assert_eq!(name_of("\u{65e5}"), "");
        for text in ["", "_", "1X", "x", "FACES", "A B"] {
            assert!(!is_name(text), "{text}");
        }
    }
}
