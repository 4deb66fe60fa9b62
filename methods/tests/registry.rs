//! Whatever lies in a folder `siblings/` of the library is in the registry.

use std::{fs, path::Path};

use syn::{ImplItem, Item, Type, UseTree, Visibility};
use zrow_methods::registry::FAMILIES;

/// What is public beside the algorithms, with the reason.
const OTHERS: &[(&str, &str)] = &[(
    "Polygons::brute_force",
    "fills by one of the point tests, which are entered each by itself",
)];

/// The algorithms of a file: the public functions that it adds to the type of its family, which another file defines, as
/// `Lines::dda`.
fn added_functions(source: &str) -> Vec<String> {
    let file = syn::parse_file(source).expect("Rust");
    let defines = |name: &str| {
        file.items
            .iter()
            .any(|item| matches!(item, Item::Struct(item) if item.ident == name))
    };
    let mut names = Vec::new();
    for item in &file.items {
        if let Item::Impl(block) = item
            && let (None, Type::Path(family)) = (&block.trait_, &*block.self_ty)
            && let Some(family) = family.path.segments.last().map(|name| name.ident.to_string())
            && !defines(&family)
        {
            let functions = block.items.iter().filter_map(|item| match item {
                ImplItem::Fn(function) if matches!(function.vis, Visibility::Public(_)) => Some(&function.sig.ident),
                _ => None,
            });
            names.extend(functions.map(|function| format!("{family}::{function}")));
        }
    }
    names
}

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
        if let Item::Use(item) = item
            && matches!(item.vis, Visibility::Public(_))
        {
            leaves(&item.tree, &mut names);
        }
    }
    names
}

fn is_entered(name: &str) -> bool {
    let algorithms = FAMILIES.iter().flat_map(|(_, family)| *family);
    let mut items = algorithms.map(|algorithm| algorithm.item.split('<').next().unwrap_or_default());
    items.any(|item| {
        let item: String = item.split_whitespace().collect();
        item.strip_suffix(name).is_some_and(|path| path.ends_with("::"))
    }) || OTHERS.iter().any(|(other, _)| *other == name)
}

/// The algorithms in the folders `siblings/` below a folder that nobody entered: the public names of their `mod.rs`, and the
/// functions that their files add to a family.
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
            let mut names = public_names(&source);
            for entry in fs::read_dir(&path).expect("a folder") {
                let file = entry.expect("an entry").path();
                if file.is_file() {
                    names.extend(added_functions(&fs::read_to_string(file).expect("a file")));
                }
            }
            names.retain(|name| !is_entered(name));
            missing.extend(names.iter().map(|name| format!("{name} in {}", path.display())));
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
    let functions = added_functions(
        "impl Lines { pub fn dda() {} fn own() {} pub fn planted() {} } struct S; impl S { pub fn f() {} }
        impl<const N: usize> Bezier<N> { pub fn halved() {} }",
    );
    assert_eq!(functions, ["Lines::dda", "Lines::planted", "Bezier::halved"]);
    assert!(is_entered("Lines::dda") && is_entered("Grid") && is_entered("Clipper::weiler_atherton"));
    assert!(!is_entered("Lines::planted") && !is_entered("planted") && !is_entered("Other"));
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
