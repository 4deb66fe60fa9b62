//! What each 3D scene of the gallery calls for: its look, as its type names it.

use core::any::type_name;

use zrow_scenes::{Scene, Visitor, visit};

/// What the type of a prepared scene begins with, before its look.
const PREPARED: &str = "zrow::scene::prepared::Prepared<";

/// A table of the scenes that are prepared in a look and nothing else.
pub fn table() -> String {
    let mut rows = Rows(String::new());
    visit(None, &mut rows);
    format!("| scene | what it is | its look |\n|---|---|---|\n{}", rows.0)
}

/// The rows of the table.
struct Rows(String);

impl Visitor for Rows {
    fn visit<S: Scene>(&mut self) {
        let prepared = type_name::<S::Prepared<'_>>();
        if let Some(look) = prepared.strip_prefix(PREPARED).and_then(|look| look.strip_suffix('>')) {
            self.0 += &format!("| `{}` | {} | `{}` |\n", S::NAME, S::TITLE, without_paths(look));
        }
    }
}

/// The name of a type without the modules of each of its parts, and without lifetimes, which some compilers name.
fn without_paths(name: &str) -> String {
    let mut short = String::new();
    for part in name.replace("'_, ", "").split_inclusive(['<', '>', ',', ' ']) {
        short += part.rsplit("::").next().unwrap_or(part);
    }
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_named_without_modules() {
        let name = "'_, '_, a::Whole<a::b::Textured<c::Texels<rgb::Rgb565, 64, 8>>>";
        assert_eq!(without_paths(name), "Whole<Textured<Texels<Rgb565, 64, 8>>>");
    }

    #[test]
    fn scenes_have_their_looks() {
        let table = table();
        for (scene, look) in [
            ("flight", "Foggy<Textured<CutOut<"),
            ("panes", "Whole<Translucent<Gouraud<Rgb565"),
        ] {
            let found = table.lines().find(|line| line.starts_with(&format!("| `{scene}` |")));
            assert!(found.is_some_and(|line| line.contains(look)), "{scene}: {found:?}");
        }
        // Scenes without depths are none of it.
        assert!(!table.contains("shapes"));
    }
}
