//! Rust source as tokens, for tests that read the source.

/// Identifiers, and single characters of anything else; comments, strings and characters are left out.
pub fn tokens(source: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    let mut rest = source;
    while let Some(first) = rest.chars().next() {
        let taken = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            block_comment(rest)
        } else if let Some(length) = raw_string(rest) {
            length
        } else if first == '"' {
            quoted(rest, '"')
        } else if first == '\'' {
            character_or_lifetime(rest)
        } else if first == '_' || first.is_alphanumeric() {
            let end = rest
                .find(|character: char| character != '_' && !character.is_alphanumeric())
                .unwrap_or(rest.len());
            tokens.push(rest[..end].to_owned());
            end
        } else {
            if !first.is_whitespace() {
                tokens.push(first.to_string());
            }
            first.len_utf8()
        };
        rest = &rest[taken..];
    }
    tokens
}

fn block_comment(source: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while at < source.len() {
        if source[at..].starts_with("/*") {
            depth += 1;
            at += 2;
        } else if source[at..].starts_with("*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                return at;
            }
        } else {
            at += source[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    source.len()
}

/// `r"..."`, `r#"..."#`, with or without a `b` before.
fn raw_string(source: &str) -> Option<usize> {
    let prefix = if source.starts_with("br") {
        2
    } else {
        usize::from(source.starts_with('r'))
    };
    let hashes = source[prefix..]
        .chars()
        .take_while(|&character| character == '#')
        .count();
    let opened = prefix + hashes + 1;
    if prefix == 0 || !source[prefix + hashes..].starts_with('"') {
        return None;
    }
    let close = format!("\"{}", "#".repeat(hashes));
    Some(
        source[opened..]
            .find(&close)
            .map_or(source.len(), |end| opened + end + close.len()),
    )
}

fn quoted(source: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, character) in source.char_indices().skip(1) {
        match character {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            _ if character == quote => return at + 1,
            _ => {}
        }
    }
    source.len()
}

/// `'a'` and `'\n'` are characters; `'a` alone is a lifetime.
fn character_or_lifetime(source: &str) -> usize {
    let mut characters = source.chars().skip(1);
    let (second, third) = (characters.next(), characters.next());
    if second == Some('\\') || third == Some('\'') {
        quoted(source, '\'')
    } else {
        1
    }
}

/// The tokens without the modules that only tests compile.
pub fn without_test_modules(tokens: Vec<String>) -> Vec<String> {
    let attribute = ["#", "[", "cfg", "(", "test", ")", "]"];
    let mut kept = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let follows = |expected: &[&str], from: usize| {
            expected
                .iter()
                .enumerate()
                .all(|(offset, word)| tokens.get(from + offset).is_some_and(|token| token == word))
        };
        if follows(&attribute, at) && follows(&["mod"], at + attribute.len()) {
            let open = (at..tokens.len())
                .find(|&index| tokens[index] == "{" || tokens[index] == ";")
                .unwrap_or(tokens.len());
            at = block_end(&tokens, open);
        } else {
            kept.push(tokens[at].clone());
            at += 1;
        }
    }
    kept
}

/// The token after the block that opens at `open`; the next token where none opens.
pub fn block_end(tokens: &[String], open: usize) -> usize {
    let mut depth = 0usize;
    for (index, token) in tokens.iter().enumerate().skip(open) {
        match token.as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return index + 1;
        }
    }
    tokens.len()
}
