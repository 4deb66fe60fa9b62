//! Every public module of zrow and every family of algorithms is fuzzed: what the sources declare, against the registry.

use std::{collections::BTreeSet, fs, path::Path};

use zrow_fuzz::registry::TARGETS;

/// The public modules that a file declares, and those in them.
fn public_modules(folder: &Path, file: &Path, prefix: &str) -> Vec<String> {
    let source = fs::read_to_string(file).unwrap();
    let declared = source
        .lines()
        .filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'));
    let mut modules = Vec::new();
    for name in declared {
        let path = format!("{prefix}{name}");
        let (inner, whole) = (folder.join(name), format!("{path}::"));
        let as_folder = inner.join("mod.rs");
        let file = if as_folder.exists() {
            as_folder
        } else {
            folder.join(format!("{name}.rs"))
        };
        modules.push(path);
        modules.extend(public_modules(&inner, &file, &whole));
    }
    modules
}

/// The families below a folder: types without fields, whose functions are algorithms.
fn families(folder: &Path, stage: &str) -> Vec<String> {
    let mut families = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            families.extend(self::families(&path, stage));
        } else {
            let source = fs::read_to_string(path).unwrap();
            let types = source
                .lines()
                .filter_map(|line| line.strip_prefix("pub struct ")?.strip_suffix(';'))
                .filter(|name| name.chars().all(char::is_alphanumeric));
            families.extend(types.map(|name| format!("{stage}::{name}")));
        }
    }
    families
}

fn modules_and_families_of_zrow() -> BTreeSet<String> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../src");
    let mut names = public_modules(&source, &source.join("lib.rs"), "");
    for stage in ["clip", "scan"] {
        names.extend(families(&source.join(stage), stage));
    }
    // These are pages of text.
    let has_items = |name: &String| !["algorithms", "guide"].contains(&name.as_str());
    names.into_iter().filter(has_items).collect()
}

#[test]
fn every_public_module_and_family_has_a_target() {
    let modules = modules_and_families_of_zrow();
    assert!(
        modules.contains("scan") && modules.contains("scan::Lines"),
        "{modules:?}"
    );
    let reached: BTreeSet<_> = TARGETS
        .iter()
        .flat_map(|target| target.modules)
        .map(|module| (*module).to_owned())
        .collect();
    let missing: Vec<_> = modules.difference(&reached).collect();
    assert!(
        missing.is_empty(),
        "no target for {missing:?}: enter one in src/registry.rs"
    );
    let unknown: Vec<_> = reached.difference(&modules).collect();
    assert!(unknown.is_empty(), "zrow has no public {unknown:?}");
}

#[test]
fn targets_have_names_of_their_own() {
    let names: BTreeSet<_> = TARGETS.iter().map(|target| target.name).collect();
    assert_eq!(names.len(), TARGETS.len());
}
