//! Puts the page together: one file, with style, scripts, data and the program in it.

use anyhow::{Context, ensure};
use base64::{Engine as _, engine::general_purpose::STANDARD};
use serde_json::json;
use zrow_playground_scene::{COUNTED_ROWS, EMPTY_COUNT, POT_COUNT, PRESETS};

use crate::counts;

const PAGE: &str = include_str!("../web/index.html");
const STYLE: &str = include_str!("../web/style.css");
/// The modules of the script: each imports only from those before it, so that one after the other they are one script.
const MODULES: &[(&str, &str)] = &[
    ("state.js", include_str!("../web/state.js")),
    ("exact.js", include_str!("../web/exact.js")),
    ("engine.js", include_str!("../web/engine.js")),
    ("panel.js", include_str!("../web/panel.js")),
    ("loupe.js", include_str!("../web/loupe.js")),
    ("scan.js", include_str!("../web/scan.js")),
    ("report.js", include_str!("../web/report.js")),
    ("controls.js", include_str!("../web/controls.js")),
    ("main.js", include_str!("../web/main.js")),
];

/// The page around a compressed program.
///
/// # Errors
/// A part has no place in the page, or the counts cannot be read.
pub fn assemble(compressed: &[u8]) -> anyhow::Result<String> {
    let presets: Vec<_> = PRESETS
        .iter()
        .map(|preset| json!({ "title": preset.title, "address": preset.address, "counts": preset.counts }))
        .collect();
    let data = json!({
        "presets": presets,
        "counts": counts::read()?,
        "countedRows": COUNTED_ROWS,
        "emptyCount": EMPTY_COUNT,
        "potCount": POT_COUNT,
        "program": STANDARD.encode(compressed),
    });
    // `<` would end the element of the data too early where `/script` follows.
    let data = data.to_string().replace('<', "\\u003c");
    let mut page = PAGE.to_owned();
    for (place, part) in [
        ("/*STYLE*/", STYLE),
        ("/*DATA*/", &data),
        ("/*SCRIPT*/", &script(MODULES)?),
    ] {
        ensure!(page.matches(place).count() == 1, "the page has no single place {place}");
        page = page.replace(place, part);
    }
    Ok(page)
}

/// The modules as one script: without imports, and with names that are no longer exported.
fn script(modules: &[(&str, &str)]) -> anyhow::Result<String> {
    let mut script = String::new();
    for (index, (name, module)) in modules.iter().enumerate() {
        let mut lines = module.lines();
        while let Some(line) = lines.next() {
            if line.starts_with("import ") {
                let mut import = line.to_owned();
                while !import.contains(';') {
                    import += lines
                        .next()
                        .with_context(|| format!("an import of {name} has no end"))?;
                }
                let is_before = |(other, _): &(&str, &str)| import.contains(&format!("\"./{other}\""));
                ensure!(
                    modules[..index].iter().any(is_before),
                    "{name} imports what comes later: {import}"
                );
            } else {
                script += line.strip_prefix("export ").unwrap_or(line);
                script.push('\n');
            }
        }
    }
    Ok(script)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_become_one_script() {
        let modules = [
            ("a.js", "export const A = 1;\nconst B = 2;\n"),
            (
                "b.js",
                "import {\n  A,\n} from \"./a.js\";\nexport function b() { return A; }\n",
            ),
        ];
        let expected = "const A = 1;\nconst B = 2;\nfunction b() { return A; }\n";
        assert_eq!(script(&modules).ok().as_deref(), Some(expected));
    }

    #[test]
    fn an_import_of_a_later_module_is_an_error() {
        let modules = [
            ("a.js", "import { B } from \"./b.js\";\n"),
            ("b.js", "export const B = 2;\n"),
        ];
        assert!(script(&modules).is_err());
        assert!(script(&[("a.js", "import {\n")]).is_err());
    }

    #[test]
    fn the_page_needs_nothing_from_elsewhere() -> anyhow::Result<()> {
        let page = assemble(b"program")?;
        assert!(!page.contains("/*SCRIPT*/") && !page.contains("\nimport "));
        for elsewhere in ["http://", "https://", "src=", "@import", "url("] {
            assert!(!page.contains(elsewhere), "{elsewhere}");
        }
        Ok(())
    }
}
