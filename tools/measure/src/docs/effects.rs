//! `docs/effects.md`: what each effect costs a frame of the teapot, as a table and as a chart.

use anyhow::Context;

use crate::{
    case::Figure,
    docs::{
        effect_cost::{Cost, measured},
        effect_plot,
        page::{parts, read, write},
        scene_looks,
    },
    effects::EFFECTS,
    report::grouped,
};

const PAGE: &str = "docs/effects.md";
/// The name of the table in the comment before it.
const TABLE: &str = "effects";
/// The name of the table of scenes.
const LOOKS: &str = "looks";
const PLOT: &str = "docs/effects.svg";

/// The names of all figures of the page.
pub fn names() -> Vec<String> {
    EFFECTS.iter().map(|effect| effect.name.to_owned()).collect()
}

/// Writes the table into the page, and draws the chart.
///
/// # Errors
///
/// A figure was not measured, or has no cycles; the page has no place for the table.
pub fn refill(figures: &[Figure]) -> anyhow::Result<()> {
    let costs = EFFECTS.iter().map(|effect| measured(effect, figures));
    let costs: Vec<Cost> = costs.collect::<anyhow::Result<_>>()?;
    let page = read(PAGE)?;
    let (before, _, after) = parts(&page, TABLE).context(PAGE)?;
    let page = format!("{before}{}{after}", table(&costs));
    let (before, _, after) = parts(&page, LOOKS).context(PAGE)?;
    write(PAGE, &format!("{before}{}{after}", scene_looks::table()))?;
    write(PLOT, &effect_plot::svg(&costs)?)
}

fn table(costs: &[Cost]) -> String {
    let lines: String = costs.iter().map(line).collect();
    let head = "| the teapot with | Cortex-M4 | Cortex-M0+ | flash | RAM |";
    format!("{head}\n|---|---:|---:|---:|---:|\n{lines}")
}

/// The row of the table.
fn line(cost: &Cost) -> String {
    let count =
        |[instructions, cycles]: [u64; 2]| format!("{} / {}", grouped(instructions as f64), grouped(cycles as f64));
    let [flash, ram] = [cost.flash, cost.ram].map(|bytes| grouped(bytes as f64));
    let (m4, m0plus) = (count(cost.m4), count(cost.m0plus));
    format!("| {} | {m4} | {m0plus} | {flash} | {ram} |\n", cost.what)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The costs of a table, as they were measured.
    fn read_table(table: &str) -> Option<Vec<Cost>> {
        let number = |text: &str| text.trim().replace(',', "").parse::<u64>().ok();
        let count = |cell: &str| {
            let (instructions, cycles) = cell.split_once('/')?;
            Some([number(instructions)?, number(cycles)?])
        };
        let line = |line: &str| {
            let cells: Vec<_> = line.split('|').collect();
            let [_, what, m4, m0plus, flash, ram, _] = cells[..] else {
                return None;
            };
            Some(Cost {
                what: what.trim().to_owned(),
                m4: count(m4)?,
                m0plus: count(m0plus)?,
                flash: number(flash)?,
                ram: number(ram)?,
            })
        };
        table.lines().skip(2).map(line).collect()
    }

    #[test]
    fn the_table_and_the_chart_have_the_same_figures() -> anyhow::Result<()> {
        let page = read(PAGE)?;
        let (_, found, _) = parts(&page, TABLE)?;
        let costs = read_table(found).context("a row is no row of figures")?;
        assert_eq!(found, table(&costs));
        let effects = EFFECTS.iter().map(|effect| effect.what);
        assert!(effects.eq(costs.iter().map(|cost| cost.what.as_str())));
        assert!(
            effect_plot::svg(&costs)? == read(PLOT)?,
            "run `cargo run --release -- effects`"
        );
        Ok(())
    }

    /// The scenes of a table, and what they are: not the names of types, which are the compiler's.
    fn scenes(table: &str) -> Vec<Vec<&str>> {
        table.lines().map(|line| line.split('|').take(3).collect()).collect()
    }

    #[test]
    fn the_table_of_scenes_is_complete() -> anyhow::Result<()> {
        let page = read(PAGE)?;
        let (_, found, _) = parts(&page, LOOKS)?;
        assert_eq!(
            scenes(found),
            scenes(&scene_looks::table()),
            "run `cargo run --release -- effects`"
        );
        Ok(())
    }

    #[test]
    fn figures_that_are_missing_are_named() {
        let error = refill(&[]).expect_err("nothing was measured").to_string();
        assert!(error.contains("effect.nothing was not measured"), "{error}");
    }
}
