//! The sources of the library as syntax trees, without what is compiled for tests only.

use std::{
    fs,
    path::{Path, PathBuf},
};

use syn::{Attribute, Item, Meta, Token, punctuated::Punctuated};

/// A file of a crate.
pub struct Module {
    /// Names from the root of the crate to the module: `scan`, `edge` for `src/scan/edge.rs`, none for `lib.rs` and for the
    /// `main.rs` of a crate without one.
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

/// The root of the repository.
pub fn project() -> &'static Path {
    let tools = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    tools.and_then(Path::parent).unwrap()
}

pub fn source_folder() -> PathBuf {
    project().join("src")
}

/// Every file of the library.
pub fn modules() -> Vec<Module> {
    modules_in(&source_folder())
}

/// The folders with the sources of the workspace's other programs and libraries, from the root of the repository on.
pub fn other_source_folders() -> Vec<String> {
    let tools = fs::read_dir(project().join("tools")).unwrap();
    let mut folders: Vec<String> = tools
        .map(|entry| entry.unwrap())
        .filter(|entry| entry.path().join("src").is_dir())
        .map(|entry| format!("tools/{}/src", entry.file_name().to_str().unwrap()))
        .collect();
    folders.sort();
    folders.extend(
        [
            "boards/async-st7789/src",
            "boards/simulator/src",
            "methods/src",
            "scenes/src",
        ]
        .map(String::from),
    );
    folders
}

/// Every file of the crate with its sources in that folder.
pub fn modules_in(folder: &Path) -> Vec<Module> {
    let mut files = Vec::new();
    files_below(folder, &mut files);
    files.sort();
    let has_library = folder.join("lib.rs").exists();
    let read = |file: PathBuf| {
        let relative = file.strip_prefix(folder).unwrap().with_extension("");
        let names: Vec<&str> = relative.iter().map(|name| name.to_str().unwrap()).collect();
        let path = match names.split_last() {
            Some((&"mod" | &"lib", folders)) => folders.to_vec(),
            // Beside a library, it is a crate of its own, whose only file this is.
            Some((&"main", [])) if !has_library => Vec::new(),
            _ => names,
        };
        Module {
            file: file.strip_prefix(folder).unwrap().to_owned(),
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
        if let Item::Mod(module) = item
            && let Some((_, items)) = &mut module.content
        {
            remove_tests(items);
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
