//! Which public types print themselves through `defmt`.

use std::collections::BTreeSet;

use syn::{Attribute, Ident, ItemEnum, ItemImpl, ItemStruct, ItemUnion, Type, Visibility, visit::Visit};

use crate::source::Module;

/// Public structs and enums that have no `defmt::Format`, neither derived nor by hand in one of the modules.
pub fn types_without_format(modules: &[Module]) -> Vec<String> {
    let mut types = Types::default();
    for module in modules {
        types.visit_file(&module.syntax);
    }
    let Types { bare, by_hand } = types;
    bare.into_iter().filter(|name| !by_hand.contains(name)).collect()
}

#[derive(Default)]
struct Types {
    /// Public types that derive no format.
    bare: Vec<String>,
    by_hand: BTreeSet<String>,
}

impl Types {
    fn add(&mut self, name: &Ident, visibility: &Visibility, attributes: &[Attribute]) {
        if matches!(visibility, Visibility::Public(_)) && !attributes.iter().any(derives_format) {
            self.bare.push(name.to_string());
        }
    }
}

/// `derive(defmt::Format)`, on a condition or not.
fn derives_format(attribute: &Attribute) -> bool {
    let text = match attribute.meta.require_list() {
        Ok(list) => list.tokens.to_string().replace(' ', ""),
        Err(_) => return false,
    };
    let is_derive = attribute.path().is_ident("derive");
    let is_conditional = attribute.path().is_ident("cfg_attr") && text.contains("derive(");
    (is_derive || is_conditional) && text.contains("defmt::Format")
}

impl<'ast> Visit<'ast> for Types {
    fn visit_item_struct(&mut self, item: &'ast ItemStruct) {
        self.add(&item.ident, &item.vis, &item.attrs);
    }

    fn visit_item_enum(&mut self, item: &'ast ItemEnum) {
        self.add(&item.ident, &item.vis, &item.attrs);
    }

    fn visit_item_union(&mut self, item: &'ast ItemUnion) {
        self.add(&item.ident, &item.vis, &item.attrs);
    }

    fn visit_item_impl(&mut self, item: &'ast ItemImpl) {
        let Some((path, _)) = &item.trait_ else { return };
        let names: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if let (["defmt", "Format"], Type::Path(path)) = (
            &names.iter().map(String::as_str).collect::<Vec<_>>()[..],
            &*item.self_ty,
        ) {
            self.by_hand
                .extend(path.path.segments.last().map(|segment| segment.ident.to_string()));
        }
    }
}
