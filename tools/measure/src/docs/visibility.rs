//! `docs/visibility.md`: what each method of visibility costs over the number of faces and of layers, as tables and as a chart.

use anyhow::Context;
use zrow_methods::HIDDEN_SURFACES;

use crate::{
    case::{Figure, V7M},
    docs::{
        page::{figure, parts, read, write},
        visibility_plot,
    },
    report::grouped,
    visibility::{AXES, Axis, CORES, Counts, count_name, flash_name, memory},
};

const PAGE: &str = "docs/visibility.md";
const PLOT: &str = "docs/visibility.svg";
/// The name of the table of flash and RAM.
const MEMORY: &str = "memory";
/// What the two cores are called in the names of tables.
const CORE_NAMES: [&str; 2] = ["m4", "m0plus"];

/// The names of all figures of the page.
pub fn names() -> Vec<String> {
    let counts = AXES.iter().flat_map(|axis| {
        let stages = axis.stages.iter().copied();
        stages.flat_map(|stage| HIDDEN_SURFACES.iter().map(move |method| count_name(stage, method)))
    });
    counts.chain(HIDDEN_SURFACES.iter().map(flash_name)).collect()
}

/// Writes the tables into the page, and draws the chart.
///
/// # Errors
/// A figure was not measured, or has no cycles; the page has no place for a table.
pub fn refill(figures: &[Figure]) -> anyhow::Result<()> {
    let mut page = read(PAGE)?;
    let mut of_m4 = Vec::new();
    for (core, core_name) in CORES.into_iter().zip(CORE_NAMES) {
        for axis in &AXES {
            let counts = measured(axis, core, figures)?;
            page = replaced(&page, &table_name(axis, core_name), &table(axis, &counts))?;
            if core == CORES[0] {
                of_m4.push(counts);
            }
        }
    }
    let flash = |method| Ok(figure(figures, &flash_name(method), V7M)?.zrow as u64);
    let flash: Vec<u64> = HIDDEN_SURFACES.iter().map(flash).collect::<anyhow::Result<_>>()?;
    let page = replaced(&page, MEMORY, &memory_table(&flash)?)?;
    write(PAGE, &page)?;
    write(PLOT, &visibility_plot::svg(&of_m4)?)
}

fn table_name(axis: &Axis, core_name: &str) -> String {
    format!("{} {core_name}", axis.name)
}

/// A page with another table of a name.
fn replaced(page: &str, name: &str, table: &str) -> anyhow::Result<String> {
    let (before, _, after) = parts(page, name).context(PAGE)?;
    Ok(format!("{before}{table}{after}"))
}

/// What all methods take in the scenes of an axis on a core.
fn measured(axis: &Axis, core: &str, figures: &[Figure]) -> anyhow::Result<Counts> {
    let of_method = |method| {
        let stages = axis.stages.iter();
        let counts = stages.map(|&stage| {
            if !axis.has(method, stage) {
                return Ok(None);
            }
            let name = count_name(stage, method);
            let figure = figure(figures, &name, core)?;
            let cycles = figure
                .cycles
                .with_context(|| format!("{name} has no cycles: leave out --no-cycles"))?;
            Ok(Some(
                [figure.zrow, cycles].map(|number| (number / 1000.0).round() as u64),
            ))
        });
        counts.collect::<anyhow::Result<_>>()
    };
    HIDDEN_SURFACES.iter().map(of_method).collect()
}

/// The first line of a table, and the one below it.
fn head(first: &str, columns: impl Iterator<Item = String>) -> String {
    let columns: Vec<String> = columns.collect();
    format!(
        "| {first} | {} |\n|---|{}\n",
        columns.join(" | "),
        "---:|".repeat(columns.len())
    )
}

/// Thousands of instructions and of cycles.
fn table(axis: &Axis, counts: &Counts) -> String {
    let number = |number: u64| grouped(number as f64);
    let mut table = head(axis.title, axis.stages.iter().map(|stage| grouped(stage.number as f64)));
    for (method, counts) in HIDDEN_SURFACES.iter().zip(counts) {
        let cells = counts.iter().map(|count| match count {
            Some([instructions, cycles]) => format!("{} / {}", number(*instructions), number(*cycles)),
            None => "–".to_owned(),
        });
        let cells: Vec<String> = cells.collect();
        table += &format!("| {} | {} |\n", method.title, cells.join(" | "));
    }
    table
}

/// Bytes of flash, and of RAM for each number of faces.
fn memory_table(flash: &[u64]) -> anyhow::Result<String> {
    let faces = AXES[0].stages.iter();
    let columns = faces.map(|stage| format!("RAM, {} faces", grouped(stage.number as f64)));
    let mut table = head("method", std::iter::once("flash".to_owned()).chain(columns));
    for ((method, flash), bytes) in HIDDEN_SURFACES.iter().zip(flash).zip(memory()?) {
        let cells: Vec<String> = bytes.iter().map(|&bytes| grouped(bytes as f64)).collect();
        table += &format!(
            "| {} | {} | {} |\n",
            method.title,
            grouped(*flash as f64),
            cells.join(" | ")
        );
    }
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is in the cells of a table without its head, line by line, without the first column.
    fn cells(table: &str) -> Vec<Vec<&str>> {
        let lines = table.lines().skip(2);
        lines
            .map(|line| {
                let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
                cells[1..].to_vec()
            })
            .collect()
    }

    fn number(cell: &str) -> anyhow::Result<u64> {
        Ok(cell.trim().replace(',', "").parse()?)
    }

    #[test]
    fn the_tables_are_whole_and_the_chart_has_their_figures() -> anyhow::Result<()> {
        let page = read(PAGE)?;
        let mut of_m4: Vec<Counts> = Vec::new();
        for axis in &AXES {
            for core in CORE_NAMES {
                let (_, found, _) = parts(&page, &table_name(axis, core))?;
                let of_page = cells(found).into_iter().map(|line| {
                    let counts = line.into_iter().map(|cell| {
                        let Some((instructions, cycles)) = cell.split_once('/') else {
                            return Ok(None);
                        };
                        Ok(Some([number(instructions)?, number(cycles)?]))
                    });
                    counts.collect::<anyhow::Result<_>>()
                });
                let counts: Counts = of_page.collect::<anyhow::Result<_>>()?;
                assert_eq!(found, table(axis, &counts), "run `cargo run --release -- visibility`");
                for (method, counts) in HIDDEN_SURFACES.iter().zip(&counts) {
                    for (&stage, count) in axis.stages.iter().zip(counts) {
                        assert_eq!(
                            axis.has(method, stage),
                            count.is_some(),
                            "{}",
                            count_name(stage, method)
                        );
                    }
                }
                if core == CORE_NAMES[0] {
                    of_m4.push(counts);
                }
            }
        }
        assert!(
            visibility_plot::svg(&of_m4)? == read(PLOT)?,
            "run `cargo run --release -- visibility`"
        );
        Ok(())
    }

    #[test]
    fn ram_is_that_of_the_types() -> anyhow::Result<()> {
        let page = read(PAGE)?;
        let (_, found, _) = parts(&page, MEMORY)?;
        let flash = cells(found).into_iter().map(|line| number(line[0]));
        let flash: Vec<u64> = flash.collect::<anyhow::Result<_>>()?;
        assert_eq!(found, memory_table(&flash)?, "run `cargo run --release -- visibility`");
        Ok(())
    }
}
