//! What of the library is public: the modules and items that have a page of their own in its documentation.

use std::collections::{BTreeMap, BTreeSet};

use syn::{Attribute, Item, UseTree, Visibility};

use crate::{
    imports::{Names, imports},
    source::Module,
};

/// The public modules, the root among them, and the public items that they define or hand on, each by the path of its definition.
pub fn public_face(modules: &[Module]) -> BTreeSet<String> {
    let crate_map = CrateMap::of(modules);
    let mut face = BTreeSet::new();
    let mut open = vec![Names::new()];
    while let Some(path) = open.pop() {
        let module = &modules[crate_map.numbers[&path]];
        for item in &module.syntax.items {
            match item {
                Item::Mod(child) if is_public(&child.vis) => {
                    open.push([&path[..], &[child.ident.to_string()]].concat());
                }
                Item::Use(item) if is_public(&item.vis) && !is_not_inlined(&item.attrs) => {
                    let mut found = Vec::new();
                    flatten(&item.tree, &[], &mut found);
                    face.extend(found.iter().filter_map(|name| crate_map.definition(&path, name)));
                }
                _ => face.extend(defined_name(item).map(|name| [&path[..], &[name]].concat().join("::"))),
            }
        }
        face.insert(
            ["crate"]
                .into_iter()
                .chain(path.iter().map(String::as_str))
                .collect::<Vec<_>>()
                .join("::"),
        );
    }
    face
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// `#[doc(no_inline)]`: a re-export of what has its page elsewhere.
fn is_not_inlined(attributes: &[Attribute]) -> bool {
    let is = |attribute: &Attribute| {
        let list = attribute.meta.require_list();
        attribute.path().is_ident("doc") && list.is_ok_and(|list| list.tokens.to_string() == "no_inline")
    };
    attributes.iter().any(is)
}

/// The name of a public item that has a page. `doc(hidden)` does not count: what others can name is public.
fn defined_name(item: &Item) -> Option<String> {
    let (visibility, name) = match item {
        Item::Const(item) => (&item.vis, &item.ident),
        Item::Enum(item) => (&item.vis, &item.ident),
        Item::Fn(item) => (&item.vis, &item.sig.ident),
        Item::Static(item) => (&item.vis, &item.ident),
        Item::Struct(item) => (&item.vis, &item.ident),
        Item::Trait(item) => (&item.vis, &item.ident),
        Item::Type(item) => (&item.vis, &item.ident),
        Item::Union(item) => (&item.vis, &item.ident),
        _ => return None,
    };
    is_public(visibility).then(|| name.to_string())
}

/// The paths that a `use` names, but for those that get no name: `pub use path::Trait as _` has no page.
fn flatten(tree: &UseTree, before: &[String], found: &mut Vec<Names>) {
    let with = |name: &dyn ToString| [before, &[name.to_string()]].concat();
    match tree {
        UseTree::Path(path) => flatten(&path.tree, &with(&path.ident), found),
        UseTree::Group(group) => group.items.iter().for_each(|tree| flatten(tree, before, found)),
        UseTree::Name(name) => found.push(with(&name.ident)),
        UseTree::Rename(rename) if rename.rename == "_" => {}
        UseTree::Rename(rename) => found.push(with(&rename.ident)),
        UseTree::Glob(_) => panic!("a re-export of everything in {before:?} hides what is public"),
    }
}

struct CrateMap<'m> {
    modules: &'m [Module],
    numbers: BTreeMap<Names, usize>,
}

impl<'m> CrateMap<'m> {
    fn of(modules: &'m [Module]) -> Self {
        let numbers = modules.iter().enumerate();
        Self {
            modules,
            numbers: numbers.map(|(number, module)| (module.path.clone(), number)).collect(),
        }
    }

    /// Where the item is defined that a module names by a path; `None` where another crate defines it.
    fn definition(&self, module: &[String], path: &[String]) -> Option<String> {
        let (first, rest) = path.split_first()?;
        let whole = match first.as_str() {
            "crate" => rest.to_vec(),
            "self" => [module, rest].concat(),
            _ => {
                let child = [module, std::slice::from_ref(first)].concat();
                self.numbers.contains_key(&child).then(|| [module, path].concat())?
            }
        };
        let (name, folder) = whole.split_last()?;
        let number = *self.numbers.get(folder)?;
        if self.modules[number]
            .syntax
            .items
            .iter()
            .any(|item| defined_name(item).as_ref() == Some(name))
        {
            return Some(whole.join("::"));
        }
        let imports = imports(&self.modules[number], &self.numbers);
        let (_, source) = imports.handed_on.into_iter().find(|(handed_on, _)| handed_on == name)?;
        self.definition(&[], &[&["crate".to_owned()], &source[..]].concat())
    }
}
