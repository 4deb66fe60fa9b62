//! What each 3D scene of the gallery calls for: its look, as its type names it.

use core::any::type_name;

use zrow_scenes::{Scene, Visitor, visit};

/// What the type of a prepared scene has before its look.
const PREPARED: &str = "zrow::scene::prepared::Prepared<";

/// A table of the scenes that are prepared in a look, and of those with something behind or in front of such a scene.
pub fn table() -> String {
    let mut rows = Rows(String::new());
    visit(None, &mut rows);
    format!("| scene | what it is | its look |\n|---|---|---|\n{}", rows.0)
}

/// The rows of the table.
struct Rows(String);

impl Visitor for Rows {
    fn visit<S: Scene>(&mut self) {
        if let Some(look) = look_of(type_name::<S::Prepared<'_>>()) {
            self.0 += &format!("| `{}` | {} | `{}` |\n", S::NAME, S::TITLE, without_paths(look));
        }
    }
}

/// The look in the name of a type that a prepared scene is, or holds as its last parameter.
fn look_of(name: &str) -> Option<&str> {
    let (around, look) = name.split_once(PREPARED)?;
    let brackets = 1 + around.matches('<').count();
    look.strip_suffix(&">".repeat(brackets))
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
    fn looks_are_found_in_other_types() {
        assert_eq!(look_of("zrow::scene::prepared::Prepared<Rgb565>"), Some("Rgb565"));
        let name = "a::Before<a::B<zrow::scene::prepared::Prepared<Whole<Rgb565>>>>";
        assert_eq!(look_of(name), Some("Whole<Rgb565>"));
        assert_eq!(look_of("a::Before<zrow::scene::Scene<Rgb565>>"), None);
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
