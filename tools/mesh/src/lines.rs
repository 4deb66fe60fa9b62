//! Lines of a text file with their numbers, and the numbers in them.

use std::borrow::Cow;

use anyhow::{Context, ensure};

/// Numbers that are greater are refused: no model needs them, and their products stay finite.
const GREATEST: f64 = 1e9;

/// Bytes of a path at most: a whole line of garbage is none.
const MOST_BYTES_OF_A_PATH: usize = 200;

/// The text of a file: what is no UTF-8, which only names and comments hold, is replaced; all line ends become one character.
pub fn text(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    text.replace("\r\n", "\n").replace('\r', "\n")
}

/// The statements of a text with the numbers of their first lines: lines that end in `\` go on in the next one, and comments
/// and empty lines are left out.
pub fn statements(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = (1..).zip(text.split('\n'));
    std::iter::from_fn(move || {
        let (number, line) = lines.next()?;
        let mut statement = Cow::Borrowed(without_comment(line));
        while let Some(begin) = statement.trim_end().strip_suffix('\\') {
            let mut joined = format!("{begin} ");
            match lines.next() {
                Some((_, line)) => joined.push_str(without_comment(line)),
                None => return Some((number, Cow::Owned(joined))),
            }
            statement = Cow::Owned(joined);
        }
        Some((number, statement))
    })
    .filter(|(_, statement)| !statement.trim().is_empty())
}

/// A comment begins with `#` at the start of a line or behind a space; names may have one within.
fn without_comment(line: &str) -> &str {
    let mut before = ' ';
    for (index, character) in line.char_indices() {
        if character == '#' && before.is_whitespace() {
            return &line[..index];
        }
        before = character;
    }
    line
}

/// The first word of a statement, and what follows it.
pub fn keyword(statement: &str) -> (&str, &str) {
    let statement = statement.trim();
    let (keyword, rest) = statement.split_once(char::is_whitespace).unwrap_or((statement, ""));
    (keyword, rest.trim())
}

/// A number that is finite and not huge.
pub fn number(word: &str) -> anyhow::Result<f64> {
    let number: f64 = word
        .parse()
        .ok()
        .with_context(|| format!("{} is no number: write one such as -1.25", shown(word)))?;
    ensure!(
        number.abs() <= GREATEST,
        "{} is no number from -1e9 to 1e9: export the model again, in larger units",
        shown(word)
    );
    Ok(number)
}

/// The numbers of a statement, of which there may be so many.
pub fn numbers(words: &str, counts: &[usize], like: &str) -> anyhow::Result<Vec<f64>> {
    let words: Vec<&str> = words.split_whitespace().collect();
    ensure!(
        counts.contains(&words.len()),
        "there are {} values: write {like}",
        words.len()
    );
    words.into_iter().map(number).collect()
}

/// The path of a file, with slashes.
pub fn path(name: &str) -> anyhow::Result<String> {
    ensure!(
        name.len() <= MOST_BYTES_OF_A_PATH,
        "{} is too long for the path of a file: rename it",
        shown(name)
    );
    Ok(name.replace('\\', "/"))
}

/// A word of a file in an error message: not too long, and without control characters.
pub fn shown(word: &str) -> String {
    let begin: String = word.chars().take(40).collect();
    let dots = if begin.len() < word.len() { "..." } else { "" };
    format!("{begin:?}{dots}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statements_have_the_number_of_their_first_line() {
        let text =
            text(b"\xef\xbb\xbfv 1\r\n# C:\\folder\\\r\n\r\nf 1 \\\r\n 2 \\\r\n 3 # end\nusemtl a#1\rg\t\xe9 \\");
        let found: Vec<(usize, String)> = statements(&text)
            .map(|(line, statement)| (line, statement.split_whitespace().collect::<Vec<_>>().join(" ")))
            .collect();
        let expected = [(1, "v 1"), (4, "f 1 2 3"), (7, "usemtl a#1"), (8, "g \u{fffd}")];
        assert_eq!(found, expected.map(|(line, statement)| (line, statement.to_owned())));
    }

    #[test]
    fn numbers_are_finite_and_not_huge() {
        assert_eq!(number("-1.5e3").unwrap(), -1500.0);
        for word in ["nan", "inf", "-Infinity", "1e10", "1e999", "1,5", "", "0x10"] {
            assert!(number(word).is_err(), "{word}");
        }
    }
}
