//! What the exercises call, read from their source.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    api::Item,
    syntax::{after_angles, angles_before, is_path_separator, is_word, last_of_path, outside_angles, snake_case},
    tokens::tokens,
};

/// Exercises that go through more than the trait of their name. Any other trait is exercised by the function of its name.
const EXERCISED_BY: [(&str, &[&str]); 8] = [
    ("Clone", &["clone", "eq", "hash"]),
    ("PartialEq", &["eq", "hash"]),
    ("Display", &["display", "error"]),
    ("ExactSizeIterator", &["iterator"]),
    ("Dimensions", &["dimensions", "draw_target", "target", "styled_shape"]),
    ("DrawTarget", &["draw_target", "target"]),
    ("StyledDrawable", &["styled_shape", "stroked_shape"]),
    ("StyledDimensions", &["styled_shape", "stroked_shape"]),
];

/// The names that exercises call and instantiate.
#[derive(Debug, Default)]
pub struct Mentions {
    /// `of::name`, whatever generic arguments stand between the two.
    paths: BTreeSet<(String, String)>,
    /// Names that are called by themselves.
    calls: BTreeSet<String>,
    /// For each generic function the names in its arguments.
    arguments: BTreeMap<String, BTreeSet<String>>,
}

impl Mentions {
    pub fn read(&mut self, source: &str) {
        let tokens = without_imports(&tokens(source));
        for index in 0..tokens.len() {
            if is_path_separator(&tokens, index) && tokens.get(index + 2).is_some_and(|name| is_word(name)) {
                let of = owner(&tokens, index).map(str::to_owned);
                self.paths.extend(of.map(|of| (of, tokens[index + 2].clone())));
            }
            if is_word(&tokens[index]) {
                self.add_call(&tokens, index);
            }
        }
    }

    fn add_call(&mut self, tokens: &[String], index: usize) {
        let name = &tokens[index];
        let is_generic =
            is_path_separator(tokens, index + 1) && tokens.get(index + 3).is_some_and(|token| token == "<");
        if is_generic {
            let arguments = &tokens[index + 3..after_angles(tokens, index + 3)];
            let words = arguments.iter().filter(|token| is_word(token)).cloned();
            self.arguments.entry(name.clone()).or_default().extend(words);
        }
        let is_call = is_generic || tokens.get(index + 1).is_some_and(|token| token == "(");
        if is_call && !(index > 0 && matches!(tokens[index - 1].as_str(), "fn" | "." | ":")) {
            self.calls.insert(name.clone());
        }
    }

    /// Whether the exercises go through something.
    pub fn include(&self, item: &Item) -> bool {
        let has_path = |of: &String, name: &String| self.paths.contains(&(of.clone(), name.clone()));
        match item {
            Item::Function {
                module,
                name,
                is_reexported,
            } => has_path(module, name) || *is_reexported && self.calls.contains(name),
            Item::Method { of, name } | Item::TraitFunction { of, name } => has_path(of, name),
            Item::Implementation { of, by } => {
                let own_name = snake_case(of);
                let exercises = EXERCISED_BY.iter().find(|(name, _)| name == of);
                let own = [own_name.as_str()];
                let exercises = exercises.map_or(&own[..], |(_, exercises)| exercises);
                exercises
                    .iter()
                    .any(|&exercise| self.arguments.get(exercise).is_some_and(|names| names.contains(by)))
            }
        }
    }
}

fn without_imports(tokens: &[String]) -> Vec<String> {
    let statements = tokens.split_inclusive(|token| token == ";");
    let kept = statements.filter(|statement| statement[0] != "use");
    kept.flatten().cloned().collect()
}

/// The word that stands before the `::` at `index`: a module, a type, or the trait of `<T as Trait>::`.
fn owner(tokens: &[String], index: usize) -> Option<&str> {
    let before = index.checked_sub(1)?;
    if tokens[before] != ">" {
        return is_word(&tokens[before]).then_some(tokens[before].as_str());
    }
    let open = angles_before(tokens, before);
    if open >= 3 && is_path_separator(tokens, open - 2) {
        return Some(&tokens[open - 3]);
    }
    let qualified = &tokens[open + 1..before];
    let cast = outside_angles(qualified, "as");
    last_of_path(qualified.get(cast + 1..).unwrap_or(qualified))
}
