//! Whatever lies in a folder `siblings/` of the library is in the registry.

use std::{fs, path::Path};

use syn::UseTree;
use zrow_methods::registry::FAMILIES;

/// What is public beside the algorithms, with the reason.
const OTHERS: &[(&str, &str)] = &[(
    "brute_force_fill",
    "fills by one of the point tests, which are entered each by itself",
)];

/// The names that a `mod.rs` hands on: those of its public `use` items.
fn public_names(source: &str) -> Vec<String> {
    fn leaves(tree: &UseTree, names: &mut Vec<String>) {
        match tree {
            UseTree::Path(path) => leaves(&path.tree, names),
            UseTree::Name(name) => names.push(name.ident.to_string()),
            UseTree::Rename(rename) => names.push(rename.rename.to_string()),
            UseTree::Group(group) => group.items.iter().for_each(|tree| leaves(tree, names)),
            UseTree::Glob(_) => names.push("*".to_owned()),
        }
    }
    let mut names = Vec::new();
    for item in syn::parse_file(source).expect("Rust").items {
        if let syn::Item::Use(item) = item
            && matches!(item.vis, syn::Visibility::Public(_))
        {
            leaves(&item.tree, &mut names);
        }
    }
    names
}

fn is_entered(name: &str) -> bool {
    let algorithms = FAMILIES.iter().flat_map(|(_, family)| *family);
    let mut items = algorithms.map(|algorithm| algorithm.item.split('<').next().unwrap_or_default());
    items.any(|item| item.rsplit("::").next().is_some_and(|last| last.trim() == name))
        || OTHERS.iter().any(|(other, _)| *other == name)
}

/// The public names in the `siblings/mod.rs` below a folder that nobody entered.
fn missing(folder: &Path) -> Vec<String> {
    let mut missing = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if !path.is_dir() {
            continue;
        }
        if path.ends_with("siblings") {
            let module = path.join("mod.rs");
            let source = fs::read_to_string(&module).expect("a module");
            let names = public_names(&source).into_iter().filter(|name| !is_entered(name));
            missing.extend(names.map(|name| format!("{name} in {}", module.display())));
        }
        missing.extend(self::missing(&path));
    }
    missing
}

#[test]
fn every_sibling_is_in_the_registry() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src");
    assert_eq!(missing(&source), Vec::<String>::new());
}

#[test]
fn a_name_that_nobody_entered_is_found() {
    let names = public_names("mod dda;\npub use {dda::dda, planted::{planted, Other}};\nuse private::hidden;");
    assert_eq!(names, ["dda", "planted", "Other"]);
    assert!(is_entered("dda") && is_entered("Grid") && is_entered("WeilerAtherton"));
    assert!(!is_entered("planted") && !is_entered("Other"));
}

#[test]
fn every_name_is_entered_once() {
    let mut names: Vec<&str> = FAMILIES
        .iter()
        .flat_map(|(_, family)| family.iter().map(|algorithm| algorithm.name))
        .collect();
    names.sort_unstable();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{names:?}");
}
