//! Links of the Markdown pages to the documentation on the web: which page they name, and which place in it.

use std::collections::BTreeSet;

use syn::{ImplItem, Item, TraitItem, Type};

use crate::source::Module;

/// Where the documentation is on the web.
const DOCUMENTATION: &str = "https://docs.rs/zrow/latest/zrow/";

/// The pages of a text's links, from the crate's root on, with their place: `scan/struct.Lines.html#method.bresenham`.
pub fn web_links(text: &str) -> Vec<&str> {
    let links = text.split(DOCUMENTATION).skip(1);
    links.filter_map(|rest| rest.split([')', ' ', '\n']).next()).collect()
}

/// What links may name, as rustdoc names it: types and traits without their module, and with each of their functions and constants.
pub fn linked_names(modules: &[Module]) -> BTreeSet<String> {
    modules
        .iter()
        .flat_map(|module| &module.syntax.items)
        .flat_map(names_of)
        .collect()
}

fn names_of(item: &Item) -> Vec<String> {
    match item {
        Item::Struct(item) => vec![format!("struct.{}.html", item.ident)],
        Item::Enum(item) => vec![format!("enum.{}.html", item.ident)],
        Item::Trait(item) => {
            let page = format!("trait.{}.html", item.ident);
            let places = item.items.iter().filter_map(|item| match item {
                TraitItem::Fn(item) if item.default.is_some() => Some(format!("method.{}", item.sig.ident)),
                TraitItem::Fn(item) => Some(format!("tymethod.{}", item.sig.ident)),
                TraitItem::Const(item) => Some(format!("associatedconstant.{}", item.ident)),
                _ => None,
            });
            with_places(&[page], places)
        }
        Item::Impl(item) if item.trait_.is_none() => {
            let Type::Path(path) = &*item.self_ty else {
                return Vec::new();
            };
            let Some(name) = path.path.segments.last() else {
                return Vec::new();
            };
            let pages = ["struct", "enum"].map(|kind| format!("{kind}.{}.html", name.ident));
            let places = item.items.iter().filter_map(|item| match item {
                ImplItem::Fn(item) => Some(format!("method.{}", item.sig.ident)),
                ImplItem::Const(item) => Some(format!("associatedconstant.{}", item.ident)),
                _ => None,
            });
            // The page itself is named where the type is defined.
            with_places(&pages, places)
                .into_iter()
                .filter(|name| name.contains('#'))
                .collect()
        }
        _ => Vec::new(),
    }
}

/// Pages, and each of their places.
fn with_places(pages: &[String], places: impl Iterator<Item = String>) -> Vec<String> {
    let places = places.flat_map(|place| pages.iter().map(move |page| format!("{page}#{place}")));
    let places: Vec<String> = places.collect();
    [pages, &places].concat()
}
