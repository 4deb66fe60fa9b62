//! What tokens of Rust mean: paths, generic arguments, blocks.

/// The token after the `>` that belongs to the `<` at `open`.
pub fn after_angles(tokens: &[String], open: usize) -> usize {
    let mut depth = 0usize;
    for index in open..tokens.len() {
        match tokens[index].as_str() {
            "<" => depth += 1,
            ">" if !is_arrow(tokens, index) => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return index + 1;
        }
    }
    tokens.len()
}

/// The `<` that belongs to the `>` at `close`.
pub fn angles_before(tokens: &[String], close: usize) -> usize {
    let mut depth = 0usize;
    for index in (0..=close).rev() {
        match tokens[index].as_str() {
            ">" if !is_arrow(tokens, index) => depth += 1,
            "<" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return index;
        }
    }
    0
}

/// The first of some tokens that is this word and in no generic arguments; their number where there is none.
pub fn outside_angles(tokens: &[String], word: &str) -> usize {
    let mut index = 0;
    while index < tokens.len() && tokens[index] != word {
        index = match tokens[index].as_str() {
            "<" => after_angles(tokens, index),
            _ => index + 1,
        };
    }
    index
}

/// The `>` of `->` or `=>`.
fn is_arrow(tokens: &[String], index: usize) -> bool {
    index > 0 && matches!(tokens[index - 1].as_str(), "-" | "=")
}

pub fn is_path_separator(tokens: &[String], index: usize) -> bool {
    tokens.get(index..index + 2).is_some_and(|pair| pair == [":", ":"])
}

pub fn is_word(token: &str) -> bool {
    token.starts_with(|first: char| first == '_' || first.is_alphabetic())
}

/// The last word of the path that a type or a trait begins with: `Band` of `&'a mut band::Band<'b, C>`.
pub fn last_of_path(tokens: &[String]) -> Option<&str> {
    let mut index = 0;
    loop {
        match tokens.get(index)?.as_str() {
            "'" => index += 2,
            "mut" | "dyn" => index += 1,
            word if is_word(word) => break,
            "$" => return None,
            _ => index += 1,
        }
    }
    while is_path_separator(tokens, index + 1) && tokens.get(index + 3).is_some_and(|word| is_word(word)) {
        index += 3;
    }
    Some(&tokens[index])
}

/// `FillSpan` as a function is called: `fill_span`.
pub fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    for (index, character) in name.chars().enumerate() {
        if character.is_uppercase() && index > 0 {
            snake.push('_');
        }
        snake.extend(character.to_lowercase());
    }
    snake
}
