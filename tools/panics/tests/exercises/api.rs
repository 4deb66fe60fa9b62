//! The public functions of zrow and the implementations of its public types, read from the source.
//!
//! Items that macros generate are not found: only the source is read, without expanding it.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt::{self, Display},
    fs,
    path::Path,
    slice,
};

use syn::{
    Attribute, GenericParam, ImplItem, ItemImpl, ItemTrait, Meta, Token, TraitItem, Type, TypeParamBound, UseTree,
    Visibility, punctuated::Punctuated,
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

/// The last name of `use a::*`.
const ALL: &str = "*";

/// A module: its path from the root of the crate, whether it is declared `pub`, whether all modules of that path are public, and
/// its items.
pub struct Module {
    pub path: Vec<String>,
    is_declared_pub: bool,
    pub is_public: bool,
    pub items: Vec<syn::Item>,
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

fn read(
    file: &Path,
    folder: &Path,
    path: Vec<String>,
    (is_declared_pub, is_public): (bool, bool),
    modules: &mut Vec<Module>,
) {
    let mut items = syn::parse_file(&fs::read_to_string(file).unwrap()).unwrap().items;
    items.retain(|item| !matches!(item, syn::Item::Mod(module) if module.attrs.iter().any(is_for_tests)));
    for item in &items {
        let syn::Item::Mod(module) = item else { continue };
        if module.content.is_some() {
            continue;
        }
        let name = module.ident.to_string();
        let (as_file, as_folder) = (folder.join(&name).with_extension("rs"), folder.join(&name));
        let file = if as_file.exists() {
            as_file
        } else {
            as_folder.join("mod.rs")
        };
        let path = [&path[..], slice::from_ref(&name)].concat();
        let is_declared_pub = is_pub(&module.vis);
        read(
            &file,
            &as_folder,
            path,
            (is_declared_pub, is_public && is_declared_pub),
            modules,
        );
    }
    modules.push(Module {
        path,
        is_declared_pub,
        is_public,
        items,
    });
}

/// `#[cfg(test)]`.
fn is_for_tests(attribute: &Attribute) -> bool {
    let condition = attribute.parse_args::<Meta>();
    attribute.path().is_ident("cfg") && condition.is_ok_and(|condition| condition.path().is_ident("test"))
}

/// Whether an item is `pub`, which `pub(crate)` is not.
fn is_pub(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// Module and name of what public modules export from elsewhere, each followed through all modules that hand it on.
fn reexports(modules: &[Module]) -> BTreeSet<(Vec<String>, String)> {
    let mut uses = Vec::new();
    for module in modules {
        for item in &module.items {
            let syn::Item::Use(item) = item else { continue };
            if !is_pub(&item.vis) {
                continue;
            }
            for path in used_paths(&item.tree) {
                let Some((name, path)) = path.split_last() else {
                    continue;
                };
                let path = match path.split_first() {
                    Some((root, path)) if root == "crate" => path.to_vec(),
                    _ => [&module.path, path].concat(),
                };
                let Some(of) = modules.iter().find(|module| module.path == path) else {
                    continue;
                };
                let names = if name == ALL {
                    exported_names(of)
                } else {
                    vec![name.clone()]
                };
                uses.extend(names.into_iter().map(|name| (module, path.clone(), name)));
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

/// The names that `pub use` in a module exports.
fn exported_names(module: &Module) -> Vec<String> {
    let mut names = Vec::new();
    for item in &module.items {
        if let syn::Item::Use(item) = item
            && is_pub(&item.vis)
        {
            names.extend(used_paths(&item.tree).into_iter().filter_map(|mut path| path.pop()));
        }
    }
    names
}

/// The paths that a `use` names; what is renamed has its name within the crate, and `a::{self}` is `a`.
fn used_paths(tree: &UseTree) -> Vec<Vec<String>> {
    let mut paths = Vec::new();
    add_used_paths(tree, &[], &mut paths);
    paths
}

fn add_used_paths(tree: &UseTree, prefix: &[String], paths: &mut Vec<Vec<String>>) {
    let with = |name: &dyn ToString| match name.to_string() {
        name if name == "self" => prefix.to_vec(),
        name => [prefix, &[name]].concat(),
    };
    match tree {
        UseTree::Path(path) => add_used_paths(&path.tree, &with(&path.ident), paths),
        UseTree::Group(group) => group.items.iter().for_each(|tree| add_used_paths(tree, prefix, paths)),
        UseTree::Name(name) => paths.push(with(&name.ident)),
        // Without a name there is none to call it by; its methods are.
        UseTree::Rename(rename) if rename.rename == "_" => {}
        UseTree::Rename(rename) => paths.push(with(&rename.ident)),
        UseTree::Glob(_) => paths.push(with(&ALL)),
    }
}

/// The public functions and trait implementations of these modules, each of which the firmware has to call.
pub fn items(modules: &[Module]) -> BTreeSet<Item> {
    let names = Names::of(modules);
    let mut items = BTreeSet::new();
    for module in modules {
        for item in &module.items {
            match item {
                syn::Item::Impl(item) => names.add_implementation(module, item, &mut items),
                syn::Item::Fn(item) if is_pub(&item.vis) => {
                    let name = item.sig.ident.to_string();
                    let is_reexported = names.is_reexported(module, &name);
                    if module.is_public || is_reexported {
                        let of = module.path.last().cloned().unwrap_or_default();
                        items.insert(Item::Function {
                            module: of,
                            name,
                            is_reexported,
                        });
                    }
                }
                syn::Item::Struct(syn::ItemStruct { vis, ident, attrs, .. })
                | syn::Item::Enum(syn::ItemEnum { vis, ident, attrs, .. }) => {
                    let name = ident.to_string();
                    if is_pub(vis) && names.is_exported(module, &name) {
                        for derived in attrs.iter().flat_map(|attribute| derives(&attribute.meta)) {
                            add_implementation_of(&derived, &name, &mut items);
                        }
                    }
                }
                syn::Item::Trait(item) => {
                    let of = item.ident.to_string();
                    if is_pub(&item.vis) && names.is_exported(module, &of) {
                        for name in trait_functions(item) {
                            items.insert(Item::TraitFunction { of: of.clone(), name });
                        }
                    }
                }
                _ => {}
            }
        }
    }
    items
}

fn add_implementation_of(of: &str, by: &str, items: &mut BTreeSet<Item>) {
    if !WITHOUT_CODE.contains(&of) && !LEFT_OUT.contains(&of) {
        items.insert(Item::Implementation {
            of: of.to_owned(),
            by: by.to_owned(),
        });
    }
}

/// The traits that an attribute derives, on a condition or not.
fn derives(attribute: &Meta) -> Vec<String> {
    let Meta::List(list) = attribute else { return Vec::new() };
    let arguments = || {
        list.parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated)
            .unwrap()
    };
    if attribute.path().is_ident("derive") {
        let traits = arguments().into_iter().map(|derived| last_name(derived.path()));
        return traits.collect();
    }
    if attribute.path().is_ident("cfg_attr") {
        return arguments().iter().flat_map(derives).collect();
    }
    Vec::new()
}

/// The functions of a trait, but for those hidden in its documentation.
fn trait_functions(item: &ItemTrait) -> Vec<String> {
    let is_hidden = |attribute: &Attribute| {
        let hides = |argument: Meta| argument.path().is_ident("hidden");
        attribute.path().is_ident("doc") && attribute.parse_args::<Meta>().is_ok_and(hides)
    };
    let mut names = Vec::new();
    for function in &item.items {
        if let TraitItem::Fn(function) = function
            && !function.attrs.iter().any(is_hidden)
        {
            names.push(function.sig.ident.to_string());
        }
    }
    names
}

/// The last name of a path: `Band` of `band::Band<'b, C>`.
pub fn last_name(path: &syn::Path) -> String {
    path.segments
        .last()
        .map(|segment| segment.ident.to_string())
        .unwrap_or_default()
}

/// The name of the type that a type begins with: `Band` of `&'a mut band::Band<'b, C>`, and of `[Band; 2]` too.
pub fn type_name(of: &Type) -> Option<String> {
    match of {
        Type::Path(path) => Some(last_name(&path.path)),
        Type::Reference(reference) => type_name(&reference.elem),
        Type::Array(array) => type_name(&array.elem),
        Type::Slice(slice) => type_name(&slice.elem),
        Type::Tuple(tuple) => tuple.elems.first().and_then(type_name),
        Type::Paren(inner) => type_name(&inner.elem),
        Type::TraitObject(object) => object.bounds.iter().find_map(|bound| match bound {
            TypeParamBound::Trait(bound) => Some(last_name(&bound.path)),
            _ => None,
        }),
        _ => None,
    }
}

/// Where types and traits are defined.
struct Names<'m> {
    /// For each name the modules that define it, and whether it is `pub` there.
    definitions: BTreeMap<String, Vec<(&'m Module, bool)>>,
    /// Module and name of what a public module exports from elsewhere.
    reexports: BTreeSet<(Vec<String>, String)>,
    /// Traits in which there is nothing to call.
    without_functions: BTreeSet<String>,
}

impl<'m> Names<'m> {
    fn of(modules: &'m [Module]) -> Self {
        let mut names = Self {
            definitions: BTreeMap::new(),
            reexports: reexports(modules),
            without_functions: BTreeSet::new(),
        };
        for module in modules {
            for item in &module.items {
                let (name, visibility) = match item {
                    syn::Item::Struct(item) => (&item.ident, &item.vis),
                    syn::Item::Enum(item) => (&item.ident, &item.vis),
                    syn::Item::Union(item) => (&item.ident, &item.vis),
                    syn::Item::Type(item) => (&item.ident, &item.vis),
                    syn::Item::Trait(item) => (&item.ident, &item.vis),
                    _ => continue,
                };
                let definition = (module, is_pub(visibility));
                names.definitions.entry(name.to_string()).or_default().push(definition);
                if matches!(item, syn::Item::Trait(item) if trait_functions(item).is_empty()) {
                    names.without_functions.insert(name.to_string());
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
    fn add_implementation(&self, module: &Module, item: &ItemImpl, items: &mut BTreeSet<Item>) {
        let Some(by) = type_name(&item.self_ty) else { return };
        if let Some((path, _)) = &item.trait_ {
            let of = last_name(path);
            // For any type there is nothing to instantiate.
            let is_any = |parameter: &GenericParam| matches!(parameter, GenericParam::Type(any) if any.ident == by);
            let is_generic = item.generics.params.iter().any(is_any);
            let has_functions = !self.without_functions.contains(&of);
            if !is_generic && has_functions && self.is_public(module, &of) && self.is_public(module, &by) {
                add_implementation_of(&of, &by, items);
            }
        } else if self.is_public(module, &by) {
            for function in &item.items {
                if let ImplItem::Fn(function) = function
                    && is_pub(&function.vis)
                {
                    items.insert(Item::Method {
                        of: by.clone(),
                        name: function.sig.ident.to_string(),
                    });
                }
            }
        }
    }
}
