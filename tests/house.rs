//! The rules of the house, read from the source: imports run one way, and every public type has a `defmt::Format`.

#[path = "common/tokens.rs"]
mod tokens;

use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
};

use tokens::{tokens, without_test_modules};

/// The folders of `src/` in the order of the pipeline: each imports only from those before it, and from itself.
const FOLDERS: [&str; 12] = [
    "geometry", "surface", "view", "mesh", "clip", "scan", "coverage", "shade", "band", "draw", "visible", "scene",
];

/// The files beside the folders. They hold no pipeline stage, so their imports are free.
const ROOT_FILES: [&str; 2] = ["lib.rs", "trace.rs"];

/// The first name of every path from the root of the crate: after `crate::`, in groups too, and after enough
/// `super::` to reach the root from a module `depth` folders and files below it.
fn root_names(tokens: &[String], depth: usize) -> Vec<String> {
    let is = |index: usize, word: &str| tokens.get(index).is_some_and(|token| token == word);
    let path_follows = |index: usize| is(index + 1, ":") && is(index + 2, ":");
    let mut names = Vec::new();
    // Open braces; `true` for those of an inline module, which is one step further from the root.
    let mut braces: Vec<bool> = Vec::new();
    let mut supers = 0;
    for index in 0..tokens.len() {
        match tokens[index].as_str() {
            "{" => braces.push(index >= 2 && is(index - 2, "mod")),
            "}" => drop(braces.pop()),
            _ => {}
        }
        let module_depth = depth + braces.iter().filter(|&&is_module| is_module).count();
        if is(index, "super") && path_follows(index) {
            supers += 1;
            if supers == module_depth {
                first_names(tokens, index + 3, &mut names);
            }
        } else if !is(index, ":") {
            supers = 0;
        }
        if is(index, "crate") && path_follows(index) && !(index > 0 && is(index - 1, "$")) {
            first_names(tokens, index + 3, &mut names);
        }
    }
    names
}

/// The name at `at`, or the first names of a group that opens there.
fn first_names(tokens: &[String], at: usize, names: &mut Vec<String>) {
    if tokens[at] != "{" {
        names.push(tokens[at].clone());
        return;
    }
    let mut depth = 0;
    for (index, token) in tokens.iter().enumerate().skip(at) {
        let starts_item = depth == 1 && matches!(tokens[index - 1].as_str(), "{" | ",");
        match token.as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            _ if starts_item => names.push(token.clone()),
            _ => {}
        }
        if depth == 0 {
            return;
        }
    }
}

/// What a file of `folder` imports and may not.
fn forbidden_imports(folder: &str, depth: usize, source: &str) -> Vec<String> {
    let place = |name: &str| FOLDERS.iter().position(|&known| known == name);
    let own = place(folder);
    root_names(&without_test_modules(tokens(source)), depth)
        .into_iter()
        .filter(|name| match (place(name), own) {
            (Some(imported), Some(own)) => imported > own,
            // Not a folder: no way around the order through a re-export at the root.
            _ => true,
        })
        .collect()
}

/// Public structs and enums that have no `defmt::Format`, neither derived nor by hand in one of the sources.
fn types_without_format(sources: &[String]) -> Vec<String> {
    let sources: Vec<Vec<String>> = sources
        .iter()
        .map(|source| without_test_modules(tokens(source)))
        .collect();
    let by_hand: BTreeSet<&str> = sources.iter().flat_map(|tokens| formatted_by_hand(tokens)).collect();
    let mut missing = Vec::new();
    for tokens in &sources {
        for index in 1..tokens.len().saturating_sub(1) {
            let is_type = matches!(tokens[index].as_str(), "struct" | "enum" | "union") && tokens[index - 1] == "pub";
            let name = tokens[index + 1].as_str();
            if is_type && !by_hand.contains(name) && !derives_format(&tokens[..index - 1]) {
                missing.push(name.to_owned());
            }
        }
    }
    missing
}

/// Whether one of the attributes right before an item derives `defmt::Format`.
fn derives_format(before: &[String]) -> bool {
    let mut before = before;
    while before.last().is_some_and(|token| token == "]") {
        let Some(open) = before.iter().rposition(|token| token == "#") else {
            return false;
        };
        let attribute = before[open..].concat();
        if attribute.contains("derive(") && attribute.contains("defmt::Format") {
            return true;
        }
        before = &before[..open];
    }
    false
}

/// The types after `defmt::Format for`.
fn formatted_by_hand(tokens: &[String]) -> impl Iterator<Item = &str> {
    let words = ["defmt", ":", ":", "Format", "for"];
    tokens.windows(words.len() + 1).filter_map(move |window| {
        let (head, name) = window.split_at(words.len());
        (head == words).then(|| name[0].as_str())
    })
}

fn source_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// Every file below a folder with its path.
fn files_below(folder: &Path) -> Vec<(PathBuf, String)> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(files_below(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let source = fs::read_to_string(&path).unwrap();
            files.push((path, source));
        }
    }
    files
}

#[test]
fn the_folders_are_those_of_the_pipeline() {
    let mut folders = BTreeSet::new();
    let mut files = BTreeSet::new();
    for entry in fs::read_dir(source_folder()).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        if entry.path().is_dir() {
            folders.insert(name)
        } else {
            files.insert(name)
        };
    }
    assert_eq!(folders, FOLDERS.map(String::from).into());
    assert_eq!(files, ROOT_FILES.map(String::from).into());
}

#[test]
fn imports_run_one_way() {
    let mut broken = Vec::new();
    for folder in FOLDERS {
        let files = files_below(&source_folder().join(folder));
        assert!(!files.is_empty(), "{folder} holds no source");
        for (path, source) in files {
            let path = path.strip_prefix(source_folder()).unwrap();
            let is_folder_module = path.ends_with("mod.rs");
            let depth = path.components().count() - usize::from(is_folder_module);
            for name in forbidden_imports(folder, depth, &source) {
                broken.push(format!("{} imports crate::{name}", path.display()));
            }
        }
    }
    assert!(
        broken.is_empty(),
        "against the order of the pipeline:\n{}",
        broken.join("\n")
    );
}

#[test]
fn every_public_type_has_a_format() {
    let sources: Vec<String> = files_below(&source_folder())
        .into_iter()
        .map(|(_, source)| source)
        .collect();
    let missing = types_without_format(&sources);
    assert!(missing.is_empty(), "no defmt::Format for {}", missing.join(", "));
}

/// Places where a condition goes on with `&& let`.
fn let_chains(source: &str) -> usize {
    let tokens = tokens(source);
    let chained = |window: &&[String]| window.iter().map(String::as_str).eq(["&", "&", "let"]);
    tokens.windows(3).filter(chained).count()
}

/// The compiler that `rust-version` names has no `&& let`; the lint that holds the library to it looks at functions only.
#[test]
fn the_library_has_no_let_chains() {
    for (path, source) in files_below(&source_folder()) {
        assert_eq!(let_chains(&source), 0, "{}", path.display());
    }
    assert_eq!(let_chains("if let Some(one) = one && let Some(two) = two {}"), 1);
    assert_eq!(let_chains("if one && two { let three = four; } // && let"), 0);
}

#[test]
fn the_checker_finds_what_is_forbidden() {
    let bad = r#"
        //! [`Band`](crate::band::Band) in a comment is no import. /* crate::scene */
        use crate::{
            geometry::{Window, band},
            draw::{style::{A, B}, line},
            surface::{self, Span},
            scene,
        };
        use crate::Band;
        pub(crate) fn one(text: &'static str) -> crate::band::Band { print("crate::scene::X", '{', '\'', r"\") }
        mod inner {
            use super::super::super::visible::Row;
            use super::super::window;
        }
        use super::super::shade::Flat;
        use super::points;
        #[cfg(test)]
        mod tests {
            use crate::scene::Scene;
            fn two() { if true { crate::visible::three() } }
        }
        use crate::view::Camera;
    "#;
    // A file `src/clip/x.rs`: two steps below the root.
    assert_eq!(
        forbidden_imports("clip", 2, bad),
        ["draw", "scene", "Band", "band", "visible", "shade"]
    );
    assert!(forbidden_imports("scene", 2, "use crate::{band::Band, scene::Other};").is_empty());
    assert_eq!(
        forbidden_imports("geometry", 1, "use super::surface::Span;"),
        ["surface"]
    );
}

#[test]
fn the_checker_finds_types_without_a_format() {
    let sources = [
        r#"
        /// One.
        #[derive(Debug)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub struct Derived(u8);
        #[derive(Debug)]
        pub struct Bare;
        pub enum Late { One }
        struct Private;
        pub(crate) struct Internal;
        pub struct ByHand<T>(T);
        #[cfg(test)]
        mod tests { pub struct OfTests; }
        "#
        .to_owned(),
        "impl<T> defmt::Format for ByHand<T> {}".to_owned(),
    ];
    assert_eq!(types_without_format(&sources), ["Bare", "Late"]);
}
