//! Tables of `docs/algorithms.md`: what is drawn into the rows of a scene by the test of its depths, and solids that are combined.

use anyhow::Context;

use crate::{
    case::{Figure, V7M},
    depth_test::{CORES, Drawing, GROUPS, Group},
    docs::page::{figure, parts, read, write},
    report::grouped,
};

const PAGE: &str = "docs/algorithms.md";

/// The names of all counts of the tables.
pub fn names() -> Vec<String> {
    let counts = GROUPS
        .iter()
        .flat_map(|group| group.drawings.iter().map(move |drawing| drawing.count_name(group)));
    counts.collect()
}

/// Writes each table anew of which something was measured.
///
/// # Errors
/// Only some of a table's figures were measured, or they have no cycles; the page has no such table.
pub fn refill(figures: &[Figure]) -> anyhow::Result<()> {
    for group in &GROUPS {
        let counts = group.drawings.iter().map(|drawing| drawing.count_name(group));
        let counts: Vec<String> = counts.collect();
        if !figures.iter().any(|figure| counts.contains(&figure.case.name)) {
            continue;
        }
        let page = read(PAGE)?;
        let (before, _, after) = parts(&page, group.name).context(PAGE)?;
        let rows = group.drawings.iter().map(|drawing| row(group, drawing, figures));
        let rows: String = rows.collect::<anyhow::Result<_>>()?;
        write(PAGE, &format!("{before}{}{rows}{after}", head(group)))?;
    }
    Ok(())
}

/// The first line of a table, and the one below it.
fn head(group: &Group) -> String {
    format!(
        "| {} | Cortex-M4 | Cortex-M0+ | flash |\n|---|---:|---:|---:|\n",
        group.scene
    )
}

/// Instructions and cycles on both cores, and flash; a dash where no program was built for it.
fn row(group: &Group, drawing: &Drawing, figures: &[Figure]) -> anyhow::Result<String> {
    let mut row = format!("| {} |", drawing.title);
    for core in CORES {
        let name = drawing.count_name(group);
        let counted = figure(figures, &name, core)?;
        let cycles = counted.cycles;
        let cycles = cycles.with_context(|| format!("{name} has no cycles: leave out --no-cycles"))?;
        row += &format!(" {} / {} |", grouped(counted.zrow), grouped(cycles));
    }
    let flash = match drawing.flash_name(group) {
        Some(name) => grouped(figure(figures, &name, V7M)?.zrow),
        None => "–".to_owned(),
    };
    Ok(format!("{row} {flash} |\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whoever enters a drawing fills its row in: `cargo run --release -- measure --only depth_test --docs`.
    #[test]
    fn every_drawing_has_its_row() -> anyhow::Result<()> {
        let page = read(PAGE)?;
        for group in &GROUPS {
            let (_, found, _) = parts(&page, group.name)?;
            let rows = found.strip_prefix(&head(group)).context(group.name)?;
            assert_eq!(rows.lines().count(), group.drawings.len(), "{}", group.name);
            for (row, drawing) in rows.lines().zip(group.drawings) {
                let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
                let [title, counts @ .., flash] = &cells[..] else {
                    anyhow::bail!("no row of figures: {row}");
                };
                assert_eq!(*title, drawing.title);
                assert_eq!(*flash != "–", drawing.flash_name(group).is_some(), "{row}");
                assert_eq!(counts.len(), CORES.len());
                for count in counts {
                    let (instructions, cycles) = count.split_once(" / ").context("no instructions and cycles")?;
                    let [instructions, cycles] =
                        [instructions, cycles].map(|text| text.replace(',', "").parse::<u64>());
                    assert!(instructions? < cycles?, "{row}");
                }
            }
        }
        Ok(())
    }

    #[test]
    fn figures_that_are_missing_are_named() {
        assert!(refill(&[]).is_ok(), "nothing of them was asked for");
        let [group, ..] = &GROUPS;
        let missing = row(group, &group.drawings[0], &[]).expect_err("nothing was measured");
        assert!(missing.to_string().contains("depth_test.nothing was not measured"));
    }
}
