//! What the wrappers of looks and shadings hand on.

use std::collections::BTreeSet;

use syn::{ImplItem, Item, ItemImpl, TraitItem, Type};

use crate::source::Module;

/// The items of a trait that implementations in the modules leave to its defaults, for the types whose names are asked for.
pub fn left_to_defaults(modules: &[Module], name: &str, is_wrapper: impl Fn(&str) -> bool) -> Vec<String> {
    let items = || modules.iter().flat_map(|module| &module.syntax.items);
    let of_trait: BTreeSet<String> = items()
        .filter_map(|item| match item {
            Item::Trait(item) if item.ident == name => Some(&item.items),
            _ => None,
        })
        .flatten()
        .filter_map(|item| match item {
            TraitItem::Const(item) => Some(item.ident.to_string()),
            TraitItem::Fn(item) => Some(item.sig.ident.to_string()),
            TraitItem::Type(item) => Some(item.ident.to_string()),
            _ => None,
        })
        .collect();
    assert!(!of_trait.is_empty(), "there is a trait {name}");
    let implementations = items().filter_map(|item| match item {
        Item::Impl(item) => Some((type_of(item, name)?, item)),
        _ => None,
    });
    implementations
        .filter(|(wrapper, _)| is_wrapper(wrapper))
        .flat_map(|(wrapper, item)| {
            let handed_on: BTreeSet<String> = item.items.iter().filter_map(name_of).collect();
            let missing: Vec<_> = of_trait.difference(&handed_on).cloned().collect();
            missing.into_iter().map(move |missing| format!("{wrapper}: {missing}"))
        })
        .collect()
}

/// The name of the type that a trait is implemented for here.
fn type_of(item: &ItemImpl, name: &str) -> Option<String> {
    let (path, _) = item.trait_.as_ref()?;
    let Type::Path(of) = &*item.self_ty else { return None };
    (path.segments.last()?.ident == name).then_some(())?;
    Some(of.path.segments.last()?.ident.to_string())
}

fn name_of(item: &ImplItem) -> Option<String> {
    match item {
        ImplItem::Const(item) => Some(item.ident.to_string()),
        ImplItem::Fn(item) => Some(item.sig.ident.to_string()),
        ImplItem::Type(item) => Some(item.ident.to_string()),
        _ => None,
    }
}
