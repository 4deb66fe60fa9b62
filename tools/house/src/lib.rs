//! The rules of the house, read from the source: imports run one way and in no circles, every public type has a
//! `defmt::Format`, every shape has pictures beside its code, the oldest compiler that is promised reads everything, and the
//! public face does not grow unnoticed.

#![cfg(test)]

mod circles;
mod face;
mod formats;
mod imports;
mod patterns;
mod source;
mod web_links;
mod wrappers;

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
};

use base64::{Engine, engine::general_purpose::STANDARD};
use syn::{BinOp, Expr, ExprBinary, visit::Visit};

use circles::{circles, needs};
use face::public_face;
use formats::types_without_format;
use imports::imports;
use patterns::{shapes, without_pictures};
use source::{Module, modules, modules_in, other_source_folders, project, source_folder};
use web_links::{linked_names, web_links};
use wrappers::left_to_defaults;

/// The folders of `src/` in the order of the pipeline: each imports only from those before it, and from itself.
const FOLDERS: [&str; 12] = [
    "geometry", "surface", "view", "mesh", "clip", "scan", "coverage", "shade", "band", "draw", "visible", "scene",
];

/// The folders in a folder of `src/`, in the order in which they build on each other: each imports only from those before it.
/// A folder named `siblings` holds what is kept to compare: nothing but the folder around it imports from there.
const FAMILIES: [(&str, &[&str]); 8] = [
    ("clip", &["segment", "convex", "boolean", "shape", "space"]),
    ("scan", &["line", "curve", "polygon", "round", "stroke", "triangle"]),
    ("coverage", &["edges", "area", "samples", "line"]),
    ("shade", &["paint", "samples", "blend", "texture", "shading"]),
    ("band", &["fill", "picture_loop"]),
    (
        "draw",
        &[
            "style",
            "eg",
            "shapes",
            "antialiased",
            "outline",
            "chains",
            "text",
            "picture",
        ],
    ),
    ("visible", &["hidden_surfaces", "hidden_lines", "depth_test"]),
    ("scene", &["look"]),
];

/// The files beside the folders. They hold no pipeline stage, so their imports are free.
const ROOT_FILES: [&str; 5] = ["algorithms.rs", "guide.rs", "lib.rs", "prelude.rs", "trace.rs"];

/// What a module imports from folders behind its own, or past a folder: no way around the order through the root.
fn forbidden_imports(module: &Module) -> Vec<String> {
    let position = |name: &String| FOLDERS.iter().position(|known| known == name);
    let Some(own) = module.path.first().and_then(position) else {
        return Vec::new();
    };
    let imports = imports(module, &BTreeMap::new());
    let handed_on = imports.handed_on.into_iter().map(|(_, path)| path);
    let names: BTreeSet<String> = handed_on
        .chain(imports.used)
        .filter_map(|path| path.first().cloned())
        .collect();
    names
        .into_iter()
        .filter(|name| position(name).is_none_or(|imported| imported > own))
        .collect()
}

fn families(folder: &str) -> &'static [&'static str] {
    let known = FAMILIES.iter().find(|(name, _)| *name == folder);
    known.map_or(&[], |(_, families)| families)
}

/// The imports from a family into one that is behind it in the same folder, and into another family's siblings.
fn forbidden_between_families(modules: &[Module]) -> Vec<String> {
    let mut broken = Vec::new();
    for (from, to) in needs(modules) {
        let (from, to) = (&modules[from], &modules[to]);
        let position = |path: &[String]| {
            let families = families(path.first()?);
            families
                .iter()
                .position(|family| path.get(1).is_some_and(|name| name == family))
        };
        let is_in_one_folder = from.path.first() == to.path.first();
        let is_backwards = matches!((position(&from.path), position(&to.path)), (Some(from), Some(to)) if from < to);
        let siblings = to.path.iter().position(|name| name == "siblings");
        let is_foreign = siblings.is_some_and(|siblings| !from.path.starts_with(&to.path[..siblings]));
        if is_in_one_folder && is_backwards || is_foreign {
            broken.push(format!("{} imports {}", from.name(), to.name()));
        }
    }
    broken
}

/// Counts how often a condition goes on with `&& let`.
#[derive(Default)]
struct LetChains(usize);

impl<'ast> Visit<'ast> for LetChains {
    fn visit_expr_binary(&mut self, binary: &'ast ExprBinary) {
        let is_let = |side: &Expr| matches!(side, Expr::Let(_));
        if matches!(binary.op, BinOp::And(_)) && (is_let(&binary.left) || is_let(&binary.right)) {
            self.0 += 1;
        }
        syn::visit::visit_expr_binary(self, binary);
    }
}

fn let_chains(syntax: &syn::File) -> usize {
    let mut chains = LetChains::default();
    chains.visit_file(syntax);
    chains.0
}

#[test]
fn the_folders_are_those_of_the_pipeline() {
    let mut folders = BTreeSet::new();
    let mut files = BTreeSet::new();
    for entry in fs::read_dir(source_folder()).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        if entry.path().is_dir() {
            folders.insert(name)
        } else {
            files.insert(name)
        };
    }
    assert_eq!(folders, FOLDERS.map(String::from).into());
    assert_eq!(files, ROOT_FILES.map(String::from).into());
}

#[test]
fn imports_run_one_way() {
    let mut broken = Vec::new();
    for module in modules() {
        for name in forbidden_imports(&module) {
            broken.push(format!("{} imports crate::{name}", module.name()));
        }
    }
    assert!(
        broken.is_empty(),
        "against the order of the pipeline:\n{}",
        broken.join("\n")
    );
}

#[test]
fn the_families_are_those_of_the_order() {
    for folder in FOLDERS {
        let inside = fs::read_dir(source_folder().join(folder)).unwrap();
        let folders: BTreeSet<String> = inside
            .map(|entry| entry.unwrap())
            .filter(|entry| entry.path().is_dir())
            .map(|entry| entry.file_name().into_string().unwrap())
            .collect();
        assert_eq!(
            folders,
            families(folder).iter().map(|name| name.to_string()).collect(),
            "{folder}"
        );
    }
}

#[test]
fn imports_run_one_way_between_families() {
    let broken = forbidden_between_families(&modules());
    assert!(
        broken.is_empty(),
        "against the order of the families:\n{}",
        broken.join("\n")
    );
}

/// Two files that need each other are one algorithm in two files; what both need belongs into a third.
#[test]
fn imports_run_in_no_circles() {
    let found = circles(&modules());
    assert!(found.is_empty(), "each needs the others:\n{}", found.join("\n"));
}

/// The files of tools, boards, scenes and methods, each crate for itself.
#[test]
fn imports_run_in_no_circles_beside_the_library() {
    let mut found = Vec::new();
    for folder in other_source_folders() {
        let modules = modules_in(&project().join(&folder));
        found.extend(circles(&modules).iter().map(|circle| format!("{folder}/{circle}")));
    }
    assert!(found.is_empty(), "each needs the others:\n{}", found.join("\n"));
}

#[test]
fn every_shape_has_pictures_beside_its_code() {
    let missing = without_pictures(&shapes());
    assert!(
        missing.is_empty(),
        "fewer than three patterns in\n{}",
        missing.join("\n")
    );
}

#[test]
fn every_public_type_has_a_format() {
    let missing = types_without_format(&modules());
    assert!(missing.is_empty(), "no defmt::Format for {}", missing.join(", "));
}

/// A wrapper that leaves an item to the trait's default undoes what is said for it inside.
#[test]
fn wrappers_hand_everything_on() {
    let modules = modules();
    let left = [
        left_to_defaults(&modules, "Look", |name| name != "H"),
        left_to_defaults(&modules, "Shading", |name| {
            ["Bounded", "Translucent", "WithPlanes"].contains(&name)
        }),
    ];
    assert_eq!(left.concat(), [""; 0], "left to the default");
    let source =
        "trait Look { type A; const B: u8 = 1; fn c() {} } impl<L: Look> Look for Fine<L> { type A = L::A; fn c() {} }";
    let module = Module::parse(&["test"], source);
    assert_eq!(left_to_defaults(&[module], "Look", |_| true), ["Fine: B"]);
}

/// The public modules and items that have a page in the documentation, the root among them. One page more, `all.html`,
/// lists them. Public is what a user names: a bound whose methods nobody calls stays `pub` in a private module.
#[test]
fn the_public_face_is_small() {
    const MOST: usize = 204;
    let face = public_face(&modules());
    let names: Vec<&str> = face.iter().map(String::as_str).collect();
    assert!(face.len() <= MOST, "{} of {MOST}:\n{}", face.len(), names.join("\n"));
}

/// Pages on docs.rs have no files beside them: their pictures lie in the text, as base64.
#[test]
fn embedded_pictures_are_those_of_the_documentation() {
    let docs = project().join("docs");
    for entry in fs::read_dir(docs.join("embedded")).unwrap() {
        let path = entry.unwrap().path();
        let embedded = fs::read_to_string(&path).unwrap();
        let picture = fs::read(docs.join(path.file_stem().unwrap())).unwrap();
        let is_same = STANDARD.encode(picture) == embedded;
        assert!(is_same, "`docs/refresh embedded` writes {} anew", path.display());
    }
}

/// The pages of `docs/` are read on the web, too, where no compiler follows a link to an item.
#[test]
fn links_to_the_documentation_on_the_web_name_what_there_is() {
    let names = linked_names(&modules());
    let face = public_face(&modules());
    let folder = project().join("docs");
    let mut links = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "md") {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        assert!(
            !text.contains("](crate::"),
            "{}: a link for the compiler alone",
            path.display()
        );
        for link in web_links(&text) {
            let (module, page) = link.rsplit_once('/').unwrap();
            let is_module = page == "index.html" && face.contains(&format!("crate::{}", module.replace('/', "::")));
            assert!(is_module || names.contains(page), "{}: {link}", path.display());
            links += 1;
        }
    }
    assert!(links > 100, "{links}");
    assert!(!names.contains("struct.Lines.html#method.bresenhams") && !names.contains("enum.Lines.html"));
}

/// The compiler that `rust-version` names has no `&& let`; the lint that holds the library to it looks at functions only.
#[test]
fn the_library_has_no_let_chains() {
    for module in modules() {
        assert_eq!(let_chains(&module.syntax), 0, "{}", module.name());
    }
    let count = |condition: &str| {
        let source = format!("fn test() {{ if {condition} {{}} }}");
        let_chains(&Module::parse(&["test"], &source).syntax)
    };
    assert_eq!(count("let Some(one) = one && let Some(two) = two"), 1);
    assert_eq!(count("one && { let three = four; three }"), 0);
}

#[test]
fn the_checker_finds_what_is_forbidden() {
    let bad = r#"
        //! [`Band`](crate::band::Band) in a comment is no import. /* crate::scene */
        use crate::{draw::{eg::line, style::style::{A, B}}, geometry::{Window, band}, scene, surface::{self, Span}};
        use crate::Band;
        pub(crate) fn one(text: &'static str) -> crate::band::Band { print("crate::scene::X", '{', '\'', r"\") }
        mod inner {
            use super::super::super::visible::Row;
            use super::super::window;
        }
        use super::super::shade::Flat;
        use super::points;
        #[cfg(test)]
        mod tests {
            use crate::scene::Scene;
            fn two() { if true { crate::visible::three() } }
        }
        use crate::view::Camera;
    "#;
    let forbidden = |path: &[&str], source: &str| forbidden_imports(&Module::parse(path, source));
    assert_eq!(
        forbidden(&["clip", "x"], bad),
        ["Band", "band", "draw", "scene", "shade", "visible"]
    );
    assert!(forbidden(&["scene", "x"], "use crate::{band::Band, scene::Other};").is_empty());
    assert_eq!(forbidden(&["geometry"], "use super::surface::Span;"), ["surface"]);
    let in_macros =
        "macro_rules! call { () => { crate::scene::x($crate::draw::y) } } fn f() { assert!(crate::band::z()); }";
    assert_eq!(forbidden(&["scan", "x"], in_macros), ["band", "scene"]);
}

#[test]
fn the_checker_finds_families_against_their_order() {
    let sources = [
        (&[][..], "mod clip;"),
        (&["clip", "segment"][..], "mod siblings; pub use siblings::slow;"),
        (&["clip", "shape"], "mod box_test;"),
        (
            &["clip", "segment", "siblings", "slow"],
            "use crate::clip::segment::fast::A; pub struct Slow;",
        ),
        (
            &["clip", "segment", "fast"],
            "use crate::clip::shape::box_test::C; pub struct A;",
        ),
        (
            &["clip", "shape", "box_test"],
            "use crate::clip::segment::{fast::A, siblings::slow::Slow}; pub struct C;",
        ),
    ];
    let modules = sources.map(|(path, source)| Module::parse(path, source));
    assert_eq!(
        forbidden_between_families(&modules),
        [
            "clip/segment/fast.rs imports clip/shape/box_test.rs",
            "clip/shape/box_test.rs imports clip/segment/siblings/slow.rs",
        ]
    );
}

#[test]
fn the_checker_finds_circles() {
    let sources = [
        (
            &["clip"][..],
            "mod one; mod two; mod deep; pub use one::One; pub use deep::Inner;",
        ),
        (&["clip", "one"], "use crate::clip::two::Two; pub struct One;"),
        (&["clip", "two"], "fn f() { let one = super::One; }"),
        (&["clip", "deep"], "mod inner; mod other; pub use inner::Inner;"),
        (&["clip", "deep", "inner"], "pub struct Inner;"),
        (&["clip", "deep", "other"], "use crate::clip::deep::Inner;"),
    ];
    let modules = sources.map(|(path, source)| Module::parse(path, source));
    assert_eq!(circles(&modules), ["clip: one, two"]);
}

/// Others may name what a program's `main.rs` defines, so it can be part of a circle.
#[test]
fn the_checker_finds_circles_of_a_program() {
    let sources = [
        (
            &[][..],
            "mod counts; mod figures; mod report; pub struct Options; fn main() { figures::read(); }",
        ),
        (&["counts"][..], "use super::report::write; pub struct Counts;"),
        (&["figures"], "pub fn read() -> crate::Options { loop {} }"),
        (&["report"], "use crate::counts::Counts; pub fn write() {}"),
    ];
    let modules = sources.map(|(path, source)| Module::parse(path, source));
    assert_eq!(circles(&modules), [": counts, report", ": figures, mod"]);
}

#[test]
fn the_checker_finds_shapes_without_pictures() {
    let documented =
        "/// display.assert_pattern(&[]); display.assert_pattern(&[]); display.assert_pattern(&[]);\nstruct Shape;";
    let drawn = |patterns: usize| {
        let calls = "drawn(&shape).assert_pattern(&[]);".repeat(patterns);
        format!("struct Shape; #[cfg(test)] mod tests {{ #[test] fn a_shape() {{ {calls} }} }}")
    };
    let files = [
        ("none.rs", documented.to_owned()),
        ("two.rs", drawn(2)),
        ("three.rs", drawn(3)),
    ];
    let files = files.map(|(name, source)| (name.to_owned(), source));
    assert_eq!(without_pictures(&files), ["none.rs: 0", "two.rs: 2"]);
    assert!(
        shapes().len() >= 17,
        "{:?}",
        shapes().iter().map(|(name, _)| name).collect::<Vec<_>>()
    );
}

#[test]
fn the_checker_finds_what_is_public() {
    let sources = [
        (
            &[][..],
            "pub mod clip; mod view; pub use fixed; pub use crate::view::Camera; #[doc(no_inline)] pub use view::Pose;",
        ),
        (
            &["clip"][..],
            "mod fast; pub(crate) mod slow; pub use fast::{Fast, helper as _}; pub(crate) use slow::Slow; pub const ONE: u8 = 1;",
        ),
        (
            &["clip", "fast"],
            "pub use inner::Fast; pub trait helper {} pub struct Unseen; mod inner;",
        ),
        (
            &["clip", "fast", "inner"],
            "#[doc(hidden)] pub struct Fast; pub fn unseen() {}",
        ),
        (&["clip", "slow"], "pub struct Slow;"),
        (&["view"], "pub struct Camera; pub struct Pose; struct Private;"),
    ];
    let modules = sources.map(|(path, source)| Module::parse(path, source));
    let face: Vec<String> = public_face(&modules).into_iter().collect();
    assert_eq!(
        face,
        [
            "clip::ONE",
            "clip::fast::inner::Fast",
            "crate",
            "crate::clip",
            "view::Camera"
        ]
    );
}

#[test]
fn the_checker_finds_types_without_a_format() {
    let sources = [
        r#"
        /// One.
        #[derive(Debug)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub struct Derived(u8);
        #[derive(Debug)]
        pub struct Bare;
        pub enum Late { One }
        struct Private;
        pub(crate) struct Internal;
        pub struct ByHand<T>(T);
        #[cfg(test)]
        mod tests { pub struct OfTests; }
        "#,
        "impl<T> defmt::Format for ByHand<T> {}",
    ];
    let modules = sources.map(|source| Module::parse(&["x"], source));
    assert_eq!(types_without_format(&modules), ["Bare", "Late"]);
}
