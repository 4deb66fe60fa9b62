//! The tables of `docs/algorithms.md`: a row for each algorithm of the registry, with the figures that were measured.

use anyhow::Context;
use zrow_methods::registry::{self, Algorithm};

use crate::{
    case::Figure,
    docs::page::{self, parts},
    report::grouped,
};

/// A table, by its name in the comment.
struct Table {
    name: &'static str,
    families: &'static [&'static [Algorithm]],
    /// Titles of the figures, and their names without that of the algorithm.
    figures: &'static [(&'static str, &'static str)],
}

const FLASH: (&str, &str) = ("flash", "flash.sibling");

const TABLES: &[Table] = &[
    Table {
        name: "lines",
        families: &[registry::LINES],
        figures: &[("instructions", "walk.on_screen"), FLASH],
    },
    Table {
        name: "circles",
        families: &[registry::CIRCLES],
        figures: &[("instructions", "round.circle"), FLASH],
    },
    Table {
        name: "ellipses",
        families: &[registry::ELLIPSES],
        figures: &[("instructions", "round.ellipse"), FLASH],
    },
    Table {
        name: "curves",
        families: &[registry::CURVES],
        figures: &[("instructions", "curve.cubic"), FLASH],
    },
    Table {
        name: "polygon_fills",
        families: &[registry::POLYGON_FILLS, registry::POINT_TESTS],
        figures: &[("instructions", "fill.polygon.large"), FLASH],
    },
    Table {
        name: "triangles",
        families: &[registry::POLYGON_FILLS.split_at(1).0, registry::TRIANGLES],
        figures: &[
            ("small", "fill.triangle.small.sub4"),
            ("large", "fill.triangle.large.sub4"),
            FLASH,
        ],
    },
    Table {
        name: "interpolations",
        families: &[registry::INTERPOLATIONS],
        figures: &[
            ("small", "interpolation.small"),
            ("large", "interpolation.large"),
            FLASH,
        ],
    },
    Table {
        name: "homogeneous_triangles",
        families: &[registry::HOMOGENEOUS_TRIANGLES],
        figures: &[("a triangle that is cut", "space.triangle"), FLASH],
    },
    Table {
        name: "coverage_methods",
        families: &[registry::COVERAGE_METHODS],
        figures: &[
            ("triangle", "coverage.triangle"),
            ("{7/3} star", "coverage.star"),
            FLASH,
        ],
    },
    Table {
        name: "segments",
        families: &[registry::SEGMENTS, registry::CONVEX_SEGMENTS],
        figures: &[
            ("inside", "segment.inside.sub4"),
            ("cut", "segment.crossing.sub4"),
            ("outside", "segment.outside.sub4"),
            ("mix", "segment.mixed.sub4"),
            FLASH,
        ],
    },
    Table {
        name: "space_segments",
        families: &[registry::SPACE_SEGMENTS, registry::VOLUME_SEGMENTS],
        figures: &[
            ("inside", "space.segment.inside"),
            ("cut", "space.segment.crossing"),
            ("outside", "space.segment.outside"),
            ("mix", "space.segment.mixed"),
            FLASH,
        ],
    },
    Table {
        name: "space_polygons",
        families: &[registry::SPACE_POLYGONS],
        figures: &[("cut", "space.face.crossing"), FLASH],
    },
    Table {
        name: "polygon_clipping",
        families: &[
            registry::CONVEX_POLYGONS,
            registry::BOOLEANS,
            registry::SHAPES_IN_WINDOW,
        ],
        figures: &[FLASH],
    },
];

const PAGE: &str = "docs/algorithms.md";

/// The names of all figures of the page.
pub fn names() -> Vec<String> {
    let names = TABLES.iter().flat_map(|table| {
        let algorithms = table.families.iter().copied().flatten();
        algorithms.flat_map(|algorithm| {
            table
                .figures
                .iter()
                .map(|(_, name)| format!("{name}.{}", algorithm.name))
        })
    });
    names.collect()
}

/// Writes all tables anew.
///
/// # Errors
///
/// A table is not in the page, or a figure was not measured.
pub fn refill(figures: &[Figure]) -> anyhow::Result<()> {
    let mut page = page::read(PAGE)?;
    for table in TABLES {
        let (before, _, after) = parts(&page, table.name)?;
        let rows = table.rows(|name| {
            let figure = figures.iter().find(|figure| figure.case.name == name);
            let figure = figure.with_context(|| format!("{name} was not measured: leave out --only and --target"))?;
            Ok(grouped(figure.zrow))
        })?;
        page = format!("{before}{rows}{after}");
    }
    page::write(PAGE, &page)
}

impl Table {
    /// The table with the figures of the given names.
    fn rows(&self, figure: impl Fn(&str) -> anyhow::Result<String>) -> anyhow::Result<String> {
        let titles: String = self.figures.iter().map(|(title, _)| format!(" {title} |")).collect();
        let mut text = format!("| algorithm | source | take it |{titles}\n|---|---|---|");
        text.push_str(&"---:|".repeat(self.figures.len()));
        text.push('\n');
        for (index, algorithm) in self.families.iter().copied().flatten().enumerate() {
            text.push_str(&format!(
                "| {} | {} | {} |",
                link(algorithm, index == 0),
                algorithm.source,
                algorithm.take_it
            ));
            for (_, name) in self.figures {
                text.push_str(&format!(" {} |", figure(&format!("{name}.{}", algorithm.name))?));
            }
            text.push('\n');
        }
        Ok(text)
    }
}

/// Where the pages of the documentation are on the web.
const DOCUMENTATION: &str = "https://docs.rs/zrow/latest/zrow";

/// Types of the registry's algorithms that are no structs.
const ENUMS: &[&str] = &["Classification"];

/// The name of an algorithm with a link to its page: bold for what the library draws with. The page is read on the web as well as
/// in the crate's documentation, so that the link is one to the web.
fn link(algorithm: &Algorithm, is_default: bool) -> String {
    let item = algorithm
        .item
        .replace(' ', "")
        .replace("zrow::coverage::", "")
        .replace(',', ", ");
    let shown = item.rsplit("::").next().unwrap_or_default();
    let bold = if is_default { "**" } else { "" };
    // A generic type's last segment would be that of its argument: the whole item has no `::` then. A function of a family
    // is shown with its type.
    let family = item.rsplit("::").nth(1).unwrap_or_default();
    let shown = if item.contains('<') {
        item.clone()
    } else if family.starts_with(char::is_uppercase) {
        format!("{family}::{shown}")
    } else {
        shown.to_owned()
    };
    format!("[{bold}`{shown}`{bold}]({DOCUMENTATION}/{})", page_of(algorithm))
}

/// The page of an algorithm's type, and the place of its function there, as rustdoc names them.
fn page_of(algorithm: &Algorithm) -> String {
    let path = algorithm.item.replace(' ', "");
    let path = path.split('<').next().unwrap_or_default();
    let mut modules = String::new();
    let mut names = path.split("::").skip(1).peekable();
    while let Some(module) = names.next_if(|name| name.starts_with(char::is_lowercase)) {
        modules.push_str(module);
        modules.push('/');
    }
    let type_name = names.next().unwrap_or_default();
    let kind = if ENUMS.contains(&type_name) { "enum" } else { "struct" };
    let place = names.next().map(|name| format!("#method.{name}")).unwrap_or_default();
    format!("{modules}{kind}.{type_name}.html{place}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whoever enters an algorithm fills its row in: `cargo run --release -- measure --docs`.
    #[test]
    fn every_algorithm_has_its_row_in_the_docs() -> anyhow::Result<()> {
        let page = page::read(PAGE)?;
        for table in TABLES {
            let (_, found, _) = parts(&page, table.name)?;
            // The figures change with every measurement.
            let words = |text: &str| -> Vec<String> {
                let row = |line: &str| line.split(" | ").take(3).collect::<Vec<_>>().join(" | ");
                text.lines().map(row).collect()
            };
            let expected = table.rows(|_| Ok(String::new()))?;
            assert_eq!(words(found), words(&expected), "{}", table.name);
        }
        Ok(())
    }

    #[test]
    fn every_family_has_a_table() {
        for (name, family) in registry::FAMILIES {
            let is_there = |table: &Table| table.families.iter().any(|other| std::ptr::eq(*other, *family));
            assert!(TABLES.iter().any(is_there), "{name}");
        }
    }
}
