//! The public functions of zrow and the implementations of its public types, read from the source.
//!
//! Items that macros generate are not found: only the source is read, without expanding it.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt::{self, Display},
    fs, iter,
    path::Path,
    slice,
};

use super::{
    syntax::{after_angles, is_word, last_of_path, outside_angles},
    tokens::{block_end, tokens, without_test_modules},
};

/// Something that has to be exercised.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Item {
    /// A free function, in the module of that name; elsewhere too where it is exported from another one.
    Function {
        module: String,
        name: String,
        is_reexported: bool,
    },
    /// A function of a type.
    Method { of: String, name: String },
    /// A function of a trait.
    TraitFunction { of: String, name: String },
    /// An implementation of a trait, derived or not.
    Implementation { of: String, by: String },
}

impl Display for Item {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Function { module: of, name, .. } | Self::Method { of, name } | Self::TraitFunction { of, name } => {
                write!(formatter, "{of}::{name}")
            }
            Self::Implementation { of, by } => write!(formatter, "impl {of} for {by}"),
        }
    }
}

/// Implementations that hold no code of their own, or code of the `defmt` feature.
const WITHOUT_CODE: [&str; 6] = ["Copy", "Eq", "Format", "Primitive", "Sealed", "StructuralPartialEq"];

/// `Debug` goes through functions of the core library that hold panics of their own.
const LEFT_OUT: [&str; 1] = ["Debug"];

/// A module: its path from the root of the crate, whether it is declared `pub`, and whether all modules of that path are public.
#[derive(Debug)]
pub struct Module {
    pub path: Vec<String>,
    is_declared_pub: bool,
    pub is_public: bool,
    pub tokens: Vec<String>,
}

/// All modules of the crate with that root file.
pub fn modules(root: &Path) -> Vec<Module> {
    let mut modules = Vec::new();
    read(root, root.parent().unwrap(), Vec::new(), (true, true), &mut modules);
    // A `pub` module that a public one exports from a private folder is public as well; where a private module has the name of
    // its function, only the function is exported.
    loop {
        let exported = reexports(&modules);
        let is_exported = |module: &Module| {
            let name = module.path.split_last();
            module.is_declared_pub
                && name.is_some_and(|(name, folder)| exported.contains(&(folder.to_vec(), name.clone())))
        };
        let newly: Vec<usize> = (0..modules.len())
            .filter(|&index| !modules[index].is_public && is_exported(&modules[index]))
            .collect();
        if newly.is_empty() {
            return modules;
        }
        for index in newly {
            modules[index].is_public = true;
        }
    }
}

/// Module and name of what public modules export from elsewhere, each followed through all modules that hand it on.
fn reexports(modules: &[Module]) -> BTreeSet<(Vec<String>, String)> {
    let mut uses = Vec::new();
    for module in modules {
        for index in outside_blocks(&module.tokens) {
            if module.tokens[index] == "use" && is_pub(&module.tokens, index) {
                for path in used_paths(&module.tokens[index + 1..]) {
                    let (name, path) = path.split_last().unwrap();
                    let path = match path.split_first() {
                        Some((root, path)) if root == "crate" => path.to_vec(),
                        _ => [&module.path, path].concat(),
                    };
                    if modules.iter().any(|module| module.path == path) {
                        uses.push((module, path, name.clone()));
                    }
                }
            }
        }
    }
    let mut exported = BTreeSet::new();
    loop {
        let before = exported.len();
        for (module, path, name) in &uses {
            if module.is_public || exported.contains(&(module.path.clone(), name.clone())) {
                exported.insert((path.clone(), name.clone()));
            }
        }
        if exported.len() == before {
            return exported;
        }
    }
}

fn read(
    file: &Path,
    folder: &Path,
    path: Vec<String>,
    (is_declared_pub, is_public): (bool, bool),
    modules: &mut Vec<Module>,
) {
    let source = fs::read_to_string(file).unwrap();
    let tokens = without_macros(without_test_modules(tokens(&source)));
    for index in 0..tokens.len().saturating_sub(2) {
        if tokens[index] == "mod" && tokens[index + 2] == ";" {
            let name = &tokens[index + 1];
            let (as_file, as_folder) = (folder.join(name).with_extension("rs"), folder.join(name));
            let file = if as_file.exists() {
                as_file
            } else {
                as_folder.join("mod.rs")
            };
            let is_declared_pub = index > 0 && tokens[index - 1] == "pub";
            read(
                &file,
                &as_folder,
                [&path[..], slice::from_ref(name)].concat(),
                (is_declared_pub, is_public && is_declared_pub),
                modules,
            );
        }
    }
    modules.push(Module {
        path,
        is_declared_pub,
        is_public,
        tokens,
    });
}

fn without_macros(tokens: Vec<String>) -> Vec<String> {
    let mut kept = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        if tokens[at] == "macro_rules" {
            let open = (at..tokens.len()).find(|&index| tokens[index] == "{").unwrap_or(at);
            at = block_end(&tokens, open);
        } else {
            kept.push(tokens[at].clone());
            at += 1;
        }
    }
    kept
}

/// The public functions and trait implementations of these modules, each of which the firmware has to call.
pub fn items(modules: &[Module]) -> BTreeSet<Item> {
    let names = Names::of(modules);
    let mut items = BTreeSet::new();
    for module in modules {
        for at in outside_blocks(&module.tokens) {
            let tokens = &module.tokens[at..];
            match tokens[0].as_str() {
                "impl" if begins_item(&module.tokens, at) => names.add_implementation(module, tokens, &mut items),
                "fn" if is_pub(&module.tokens, at) => {
                    let name = &tokens[1];
                    let is_reexported = names.is_reexported(module, name);
                    if module.is_public || is_reexported {
                        let of = module.path.last().cloned().unwrap_or_default();
                        items.insert(Item::Function {
                            module: of,
                            name: name.clone(),
                            is_reexported,
                        });
                    }
                }
                "struct" | "enum" if is_pub(&module.tokens, at) && names.is_exported(module, &tokens[1]) => {
                    for derived in derives(&module.tokens[..at]) {
                        add_implementation_of(derived, &tokens[1], &mut items);
                    }
                }
                "trait" if is_pub(&module.tokens, at) && names.is_exported(module, &tokens[1]) => {
                    for name in trait_functions(tokens) {
                        items.insert(Item::TraitFunction {
                            of: tokens[1].clone(),
                            name,
                        });
                    }
                }
                _ => {}
            }
        }
    }
    items
}

/// The places of the tokens that are in no braces.
fn outside_blocks(tokens: &[String]) -> impl Iterator<Item = usize> + use<'_> {
    let next = |&at: &usize| match tokens.get(at)?.as_str() {
        "{" => Some(block_end(tokens, at)),
        _ => Some(at + 1),
    };
    iter::successors(Some(0), next).take_while(|&at| at < tokens.len())
}

fn add_implementation_of(of: &str, by: &str, items: &mut BTreeSet<Item>) {
    if !WITHOUT_CODE.contains(&of) && !LEFT_OUT.contains(&of) {
        items.insert(Item::Implementation {
            of: of.to_owned(),
            by: by.to_owned(),
        });
    }
}

/// Not the `impl` of a parameter's type.
fn begins_item(tokens: &[String], at: usize) -> bool {
    at == 0 || matches!(tokens[at - 1].as_str(), "}" | ";" | "]")
}

/// Whether the item at `at` is `pub`, as `pub const fn` is and `pub(crate) fn` is not.
fn is_pub(tokens: &[String], at: usize) -> bool {
    let before = tokens[..at]
        .iter()
        .rev()
        .find(|token| !matches!(token.as_str(), "const" | "async"));
    before.is_some_and(|token| token == "pub")
}

/// The traits that the attributes right before an item derive.
fn derives(before: &[String]) -> Vec<&str> {
    // Back over `pub` to the end of whatever comes before the attributes.
    let mut start = before.len().saturating_sub(1);
    while start > 0 && before[start - 1] == "]" {
        start = before[..start].iter().rposition(|token| token == "#").unwrap_or(0);
    }
    let mut derived = Vec::new();
    for index in start..before.len() {
        if before[index] == "derive" {
            let end = (index..before.len()).find(|&end| before[end] == ")").unwrap_or(index);
            let traits = before[index + 2..end].split(|token| token == ",");
            derived.extend(
                traits
                    .filter_map(|path| path.iter().rfind(|token| is_word(token)))
                    .map(String::as_str),
            );
        }
    }
    derived
}

/// The functions of a trait, but for those hidden in its documentation.
fn trait_functions(tokens: &[String]) -> Vec<String> {
    let open = (0..tokens.len()).find(|&index| tokens[index] == "{").unwrap_or(0);
    let mut names = Vec::new();
    let mut is_hidden = false;
    let mut at = open + 1;
    let end = block_end(tokens, open);
    while at < end {
        match tokens[at].as_str() {
            "hidden" => is_hidden = true,
            "fn" => {
                if !is_hidden {
                    names.push(tokens[at + 1].clone());
                }
                is_hidden = false;
            }
            "{" => {
                at = block_end(tokens, at);
                continue;
            }
            _ => {}
        }
        at += 1;
    }
    names
}

/// Where types and traits are defined.
struct Names<'m> {
    /// For each name the modules that define it, and whether it is `pub` there.
    definitions: BTreeMap<&'m str, Vec<(&'m Module, bool)>>,
    /// Module and name of what a public module exports from elsewhere.
    reexports: BTreeSet<(Vec<String>, String)>,
    /// Traits in which there is nothing to call.
    without_functions: BTreeSet<&'m str>,
}

impl<'m> Names<'m> {
    fn of(modules: &'m [Module]) -> Self {
        let mut names = Self {
            definitions: BTreeMap::new(),
            reexports: reexports(modules),
            without_functions: BTreeSet::new(),
        };
        for module in modules {
            for index in outside_blocks(&module.tokens) {
                let tokens = &module.tokens[index..];
                if let kind @ ("struct" | "enum" | "union" | "type" | "trait") = tokens[0].as_str() {
                    let name = tokens[1].as_str();
                    let definition = (module, is_pub(&module.tokens, index));
                    names.definitions.entry(name).or_default().push(definition);
                    if kind == "trait" && trait_functions(tokens).is_empty() {
                        names.without_functions.insert(name);
                    }
                }
            }
        }
        names
    }

    fn is_reexported(&self, module: &Module, name: &str) -> bool {
        self.reexports.contains(&(module.path.clone(), name.to_owned()))
    }

    fn is_exported(&self, module: &Module, name: &str) -> bool {
        module.is_public || self.is_reexported(module, name)
    }

    /// Whether a type or a trait is public, seen from a module; what this crate does not define is.
    fn is_public(&self, seen_from: &Module, name: &str) -> bool {
        let Some(definitions) = self.definitions.get(name) else {
            return true;
        };
        // Where several have the name, the nearest one is meant.
        let shared = |module: &Module| {
            module
                .path
                .iter()
                .zip(&seen_from.path)
                .take_while(|(a, b)| a == b)
                .count()
        };
        let nearest = definitions.iter().map(|(module, _)| shared(module)).max();
        let mut meant = definitions.iter().filter(|(module, _)| Some(shared(module)) == nearest);
        meant.any(|&(module, is_pub)| is_pub && self.is_exported(module, name))
    }

    /// The functions of a type, or the implementation of a trait.
    fn add_implementation(&self, module: &Module, tokens: &[String], items: &mut BTreeSet<Item>) {
        let generics = match tokens.get(1).map(String::as_str) {
            Some("<") => 1..after_angles(tokens, 1),
            _ => 1..1,
        };
        let open = generics.end + outside_angles(&tokens[generics.end..], "{");
        let header = &tokens[generics.end..open];
        let header = &header[..outside_angles(header, "where")];
        let split = outside_angles(header, "for");
        if split < header.len() {
            let (Some(of), Some(by)) = (last_of_path(&header[..split]), last_of_path(&header[split + 1..])) else {
                return;
            };
            // For any type there is nothing to instantiate.
            let is_generic = tokens[generics].iter().any(|token| token == by);
            let has_functions = !self.without_functions.contains(of);
            if !is_generic && has_functions && self.is_public(module, of) && self.is_public(module, by) {
                add_implementation_of(of, by, items);
            }
        } else if let Some(of) = last_of_path(header).filter(|of| self.is_public(module, of)) {
            let end = block_end(tokens, open);
            let mut at = open + 1;
            while at < end {
                if tokens[at] == "fn" && is_pub(tokens, at) {
                    items.insert(Item::Method {
                        of: of.to_owned(),
                        name: tokens[at + 1].clone(),
                    });
                }
                at = if tokens[at] == "{" {
                    block_end(tokens, at)
                } else {
                    at + 1
                };
            }
        }
    }
}

/// The paths that a `use` names, from the word after it on; what is renamed has its name within the crate.
fn used_paths(tokens: &[String]) -> Vec<Vec<String>> {
    let mut paths = Vec::new();
    add_used_paths(tokens, &mut 0, &[], &mut paths);
    paths
}

fn add_used_paths(tokens: &[String], at: &mut usize, prefix: &[String], paths: &mut Vec<Vec<String>>) {
    let mut path = prefix.to_vec();
    loop {
        match tokens[*at].as_str() {
            "," | "}" | ";" => {
                paths.push(path);
                return;
            }
            "{" => {
                while tokens[*at] != "}" {
                    *at += 1;
                    if tokens[*at] != "}" {
                        add_used_paths(tokens, at, &path, paths);
                    }
                }
                *at += 1;
                return;
            }
            "as" => *at += 2,
            word => {
                path.extend(is_word(word).then(|| word.to_owned()));
                *at += 1;
            }
        }
    }
}
