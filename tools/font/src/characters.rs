//! The characters of a font, as they are typed on the command line.

use anyhow::{bail, ensure};

/// The most characters that a font takes: indices of glyphs have 16 bits.
pub const MOST: usize = u16::MAX as usize;

/// The characters of a list such as `0-9.:°C`, sorted, each once. A minus between two characters is a range; at either end
/// of the list or behind a backslash it is a minus, and two backslashes are one.
///
/// # Errors
/// A list without characters, a range that runs backwards, a backslash before anything else, too many characters.
pub fn parse(list: &str) -> anyhow::Result<Vec<char>> {
    let symbols = symbols(list)?;
    let mut characters = Vec::new();
    let mut rest = &symbols[..];
    loop {
        match *rest {
            [Symbol::Character(first), Symbol::Minus, Symbol::Character(last), ..] => {
                ensure!(
                    first <= last,
                    "the range {first}-{last} in --chars runs backwards: write {last}-{first}, or \\- for a minus"
                );
                characters.extend(first..=last);
                rest = &rest[3..];
            }
            [Symbol::Character(character), ..] => {
                characters.push(character);
                rest = &rest[1..];
            }
            [Symbol::Minus, ..] => {
                characters.push('-');
                rest = &rest[1..];
            }
            [] => break,
        }
        ensure!(
            characters.len() <= 2 * MOST,
            "--chars has too many characters: a font takes {MOST}"
        );
    }
    characters.sort_unstable();
    characters.dedup();
    ensure!(
        !characters.is_empty(),
        "--chars is empty: write the characters that the font is to have, such as --chars '0-9.:'"
    );
    ensure!(
        characters.len() <= MOST,
        "--chars has {} characters, and a font takes {MOST}: leave some out",
        characters.len()
    );
    Ok(characters)
}

#[derive(Clone, Copy)]
enum Symbol {
    Character(char),
    Minus,
}

fn symbols(list: &str) -> anyhow::Result<Vec<Symbol>> {
    let mut symbols = Vec::new();
    let mut characters = list.chars();
    while let Some(character) = characters.next() {
        symbols.push(match character {
            '-' => Symbol::Minus,
            '\\' => match characters.next() {
                Some(escaped @ ('-' | '\\')) => Symbol::Character(escaped),
                _ => bail!("a backslash in --chars stands before a minus or a backslash: write \\\\ for one"),
            },
            other => Symbol::Character(other),
        });
    }
    Ok(symbols)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(list: &str) -> String {
        parse(list).unwrap().into_iter().collect()
    }

    #[test]
    fn ranges_and_lists() {
        assert_eq!(text("0-9.:°C"), ".0123456789:C°");
        assert_eq!(text("ba"), "ab");
        assert_eq!(text("-a-c-"), "-abc");
        assert_eq!(text(r"a\-c\\"), r"-\ac");
        assert_eq!(text(" -~").len(), 95);
        assert_eq!(text("aaa-a"), "a");
    }

    #[test]
    fn what_cannot_be_meant_says_what_to_write() {
        for (list, part) in [
            ("", "--chars '0-9.:'"),
            ("9-0", "write 0-9"),
            (r"\n", r"write \\"),
            ("\u{0}-\u{10ffff}", "too many"),
        ] {
            let error = parse(list).unwrap_err().to_string();
            assert!(error.contains(part), "{error}");
        }
    }
}
