//! The sources of the library as syntax trees, without what is compiled for tests only.

use std::{
    fs,
    path::{Path, PathBuf},
};

use syn::{Attribute, Item, Meta, Token, punctuated::Punctuated};

/// A file of `src/`.
pub struct Module {
    /// Names from the root of the crate to the module: `scan`, `edge` for `src/scan/edge.rs`, none for `lib.rs`.
    pub path: Vec<String>,
    pub file: PathBuf,
    pub syntax: syn::File,
}

impl Module {
    /// A module as its source has it.
    pub fn parse(path: &[&str], source: &str) -> Self {
        let mut syntax = syn::parse_file(source).unwrap();
        remove_tests(&mut syntax.items);
        Self {
            path: path.iter().map(|&name| name.to_owned()).collect(),
            file: PathBuf::from(format!("{}.rs", path.join("/"))),
            syntax,
        }
    }

    /// The name that error messages have for it.
    pub fn name(&self) -> String {
        self.file.display().to_string()
    }
}

pub fn source_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// Every file of the library.
pub fn modules() -> Vec<Module> {
    let mut files = Vec::new();
    files_below(&source_folder(), &mut files);
    files.sort();
    let read = |file: PathBuf| {
        let relative = file.strip_prefix(source_folder()).unwrap().with_extension("");
        let names: Vec<&str> = relative.iter().map(|name| name.to_str().unwrap()).collect();
        let path = match names.split_last() {
            Some((&"mod" | &"lib", folders)) => folders.to_vec(),
            _ => names,
        };
        Module {
            file: file.strip_prefix(source_folder()).unwrap().to_owned(),
            ..Module::parse(&path, &fs::read_to_string(&file).unwrap())
        }
    };
    files.into_iter().map(read).collect()
}

fn files_below(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files_below(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

fn remove_tests(items: &mut Vec<Item>) {
    items.retain(|item| !attributes(item).iter().any(is_for_tests));
    for item in items {
        if let Item::Mod(module) = item {
            if let Some((_, items)) = &mut module.content {
                remove_tests(items);
            }
        }
    }
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

fn is_for_tests(attribute: &Attribute) -> bool {
    let conditions = Punctuated::<Meta, Token![,]>::parse_terminated;
    attribute.path().is_ident("cfg")
        && attribute
            .parse_args_with(conditions)
            .is_ok_and(|conditions| conditions.iter().any(|condition| condition.path().is_ident("test")))
}
