//! What a module names of the crate it is in: imports, and paths from the root in code and macros.

use std::collections::BTreeMap;

use proc_macro2::{TokenStream, TokenTree};
use syn::{ItemMod, ItemUse, Macro, UseTree, Visibility, visit::Visit};

use crate::source::Module;

/// Names from the root of the crate.
pub type Names = Vec<String>;

/// What a module names.
#[derive(Default)]
pub struct Imports {
    /// What its own code needs: everything but what it only hands on.
    pub used: Vec<Names>,
    /// What others may find in it that is defined elsewhere, by the name it has there; `*` for everything.
    pub handed_on: Vec<(String, Names)>,
}

/// Reads them. `modules` are the names of all modules.
pub fn imports(module: &Module, modules: &BTreeMap<Names, usize>) -> Imports {
    let mut reader = Reader {
        modules,
        here: module.path.clone(),
        imports: Imports::default(),
    };
    reader.visit_file(&module.syntax);
    reader.imports
}

struct Reader<'a> {
    modules: &'a BTreeMap<Names, usize>,
    here: Names,
    imports: Imports,
}

impl Reader<'_> {
    /// The names from the root, of a path that begins there; `None` for other crates and what is in scope.
    fn resolve(&self, path: &[String]) -> Option<Names> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => Some(rest.to_vec()),
            "self" => Some([&self.here, rest].concat()),
            "super" => {
                let supers = path.iter().take_while(|name| *name == "super").count();
                let kept = self.here.len().checked_sub(supers)?;
                Some([&self.here[..kept], &path[supers..]].concat())
            }
            _ => {
                let child = [&self.here, std::slice::from_ref(first)].concat();
                self.modules.contains_key(&child).then(|| [&self.here, path].concat())
            }
        }
    }

    fn flatten(&self, tree: &UseTree, before: &[String], found: &mut Vec<(String, Names)>) {
        let with = |name: &dyn ToString| [before, &[name.to_string()]].concat();
        match tree {
            UseTree::Path(path) => self.flatten(&path.tree, &with(&path.ident), found),
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.flatten(tree, before, found);
                }
            }
            UseTree::Name(name) if name.ident == "self" => {
                found.push((before.last().cloned().unwrap_or_default(), before.to_vec()));
            }
            UseTree::Name(name) => found.push((name.ident.to_string(), with(&name.ident))),
            UseTree::Rename(rename) => found.push((rename.rename.to_string(), with(&rename.ident))),
            UseTree::Glob(_) => found.push(("*".to_owned(), before.to_vec())),
        }
    }

    fn tokens(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let is_colon =
            |index: usize| matches!(tokens.get(index), Some(TokenTree::Punct(mark)) if mark.as_char() == ':');
        let name = |index: usize| match tokens.get(index) {
            Some(TokenTree::Ident(name)) => Some(name.to_string()),
            _ => None,
        };
        for (index, token) in tokens.iter().enumerate() {
            if let TokenTree::Group(group) = token {
                self.tokens(group.stream());
            }
            let is_path_end = index > 0 && is_colon(index - 1);
            let is_variable =
                index > 0 && matches!(&tokens[index - 1], TokenTree::Punct(mark) if mark.as_char() == '$');
            let Some(first) = name(index).filter(|_| !is_path_end && !is_variable) else {
                continue;
            };
            let (mut path, mut next) = (vec![first], index + 1);
            while let (true, true, Some(name)) = (is_colon(next), is_colon(next + 1), name(next + 2)) {
                path.push(name);
                next += 3;
            }
            if matches!(path[0].as_str(), "crate" | "super") {
                self.imports.used.extend(self.resolve(&path));
            }
        }
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item_mod(&mut self, module: &'ast ItemMod) {
        if module.content.is_some() {
            self.here.push(module.ident.to_string());
            syn::visit::visit_item_mod(self, module);
            self.here.pop();
        }
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        let mut found = Vec::new();
        self.flatten(&item.tree, &[], &mut found);
        for (name, path) in found {
            let Some(path) = self.resolve(&path) else { continue };
            if matches!(item.vis, Visibility::Inherited) {
                self.imports.used.push(path.clone());
            }
            self.imports.handed_on.push((name, path));
        }
    }

    /// Where something may be seen is no import.
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let names: Names = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        let is_longer = names.len() > 1 && path.leading_colon.is_none();
        if is_longer {
            self.imports.used.extend(self.resolve(&names));
        }
        syn::visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        self.tokens(call.tokens.clone());
        syn::visit::visit_macro(self, call);
    }
}
