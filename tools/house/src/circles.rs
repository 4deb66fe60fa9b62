//! Circles of imports: files of a folder, or folders beside each other, that need each other.

use std::collections::{BTreeMap, BTreeSet};

use crate::{
    imports::{Imports, Names, imports},
    source::Module,
};

/// Which module needs which, by their numbers, once what is handed on is followed to where it is defined.
pub fn needs(modules: &[Module]) -> Vec<(usize, usize)> {
    let numbers: BTreeMap<Names, usize> = modules
        .iter()
        .enumerate()
        .map(|(number, module)| (module.path.clone(), number))
        .collect();
    let read: Vec<Imports> = modules.iter().map(|module| imports(module, &numbers)).collect();
    let crate_map = CrateMap {
        numbers: &numbers,
        read: &read,
    };
    let mut needs = BTreeSet::new();
    for (number, imports) in read.iter().enumerate() {
        for path in &imports.used {
            let definition = crate_map.definition(path, 0);
            if definition != number {
                needs.insert((number, definition));
            }
        }
    }
    needs.into_iter().collect()
}

struct CrateMap<'a> {
    numbers: &'a BTreeMap<Names, usize>,
    read: &'a [Imports],
}

impl CrateMap<'_> {
    /// The module that defines what a path from the root names.
    fn definition(&self, path: &[String], followed: usize) -> usize {
        assert!(followed < 9, "{path:?} is handed on again and again");
        let length = (0..=path.len())
            .rev()
            .find(|&length| self.numbers.contains_key(&path[..length]))
            .unwrap();
        let module = self.numbers[&path[..length]];
        let Some(name) = path.get(length) else { return module };
        let rest = &path[length + 1..];
        for (handed_on, source) in &self.read[module].handed_on {
            // What an inline module imports from the file around it is defined right there.
            if handed_on == name && source != &path[..=length] {
                return self.definition(&[source, rest].concat(), followed + 1);
            }
        }
        module
    }
}

/// The smallest circles: sets of siblings (files or folders of the same folder) that need each other, by name.
pub fn circles(modules: &[Module]) -> Vec<String> {
    // For each folder, which of its entries need which.
    let mut folders = BTreeMap::<Names, BTreeSet<(String, String)>>::new();
    for (from, to) in needs(modules) {
        let (from, to) = (&modules[from].path, &modules[to].path);
        let shared = from.iter().zip(to).take_while(|(one, other)| one == other).count();
        let entry = |path: &Names| path.get(shared).cloned().unwrap_or("mod".to_owned());
        let folder = folders.entry(from[..shared].to_vec()).or_default();
        folder.insert((entry(from), entry(to)));
    }
    let mut found = Vec::new();
    for (folder, needs) in folders {
        let entries: BTreeSet<&String> = needs.iter().flat_map(|(from, to)| [from, to]).collect();
        let reached: BTreeMap<&String, BTreeSet<&String>> = entries
            .iter()
            .map(|&entry| (entry, reached_from(entry, &needs)))
            .collect();
        let mut seen = BTreeSet::new();
        for &entry in &entries {
            let circle: Vec<&str> = entries
                .iter()
                .filter(|&&other| reached[entry].contains(other) && reached[other].contains(entry))
                .map(|other| other.as_str())
                .collect();
            if !circle.is_empty() && seen.insert(circle.clone()) {
                found.push(format!("{}: {}", folder.join("/"), circle.join(", ")));
            }
        }
    }
    found
}

fn reached_from<'a>(entry: &'a String, needs: &'a BTreeSet<(String, String)>) -> BTreeSet<&'a String> {
    let mut reached = BTreeSet::new();
    let mut open = vec![entry];
    while let Some(next) = open.pop() {
        for (_, to) in needs.iter().filter(|(from, _)| from == next) {
            if reached.insert(to) {
                open.push(to);
            }
        }
    }
    reached
}
