//! `docs/visibility.md`: what each method of visibility costs over the number of faces and of layers, as tables and as a chart; and what
//! is recorded there, for the accuracy report.

use anyhow::Context;
use time::{Date, OffsetDateTime};
use zrow_methods::HIDDEN_SURFACES;

use crate::{
    case::{Figure, V7M},
    docs::{
        page::{figure, parts, read, write},
        visibility_plot::{self, Cost},
    },
    report::grouped,
    visibility::{AXES, Axis, CORES, Counts, count_name, flash_name, memory},
};

const PAGE: &str = "docs/visibility.md";
const PLOT: &str = "docs/visibility.svg";
/// The name of the table of flash and RAM.
const MEMORY: &str = "memory";
/// The name of the line that says when it was measured.
const MEASURED: &str = "measured";
/// What the two cores are called in the names of tables.
const CORE_NAMES: [&str; 2] = ["m4", "m0plus"];
/// What the two cores are called in titles.
const CORE_TITLES: [&str; 2] = ["Cortex-M4", "Cortex-M0+"];

/// What the page says, as it was measured then.
#[derive(Debug, Clone)]
pub struct RecordedVisibility {
    /// A sentence: when it was measured.
    pub measured: String,
    pub tables: Vec<RecordedTable>,
    pub charts: Vec<RecordedChart>,
}

/// A table of the page.
#[derive(Debug, Clone)]
pub struct RecordedTable {
    pub title: String,
    pub columns: Vec<String>,
    /// As many cells each as there are columns; the first one is the method.
    pub rows: Vec<Vec<String>>,
}

/// A chart drawn from the figures of the page.
#[derive(Debug, Clone)]
pub struct RecordedChart {
    /// In file names.
    pub name: String,
    pub title: String,
    pub svg: String,
}

/// Reads `docs/visibility.md`, and draws instructions and cycles on both cores. Nothing is measured.
///
/// # Errors
/// The page cannot be read, or has no such tables.
pub fn recorded_visibility() -> anyhow::Result<RecordedVisibility> {
    let page = read(PAGE)?;
    let (mut tables, mut charts) = (Vec::new(), Vec::new());
    for (core, title) in CORE_NAMES.into_iter().zip(CORE_TITLES) {
        let mut counts = Vec::new();
        for axis in &AXES {
            let (_, table, _) = parts(&page, &table_name(axis, core))?;
            counts.push(read_counts(table)?);
            tables.push(RecordedTable {
                title: format!(
                    "{title}: thousands of instructions / estimated cycles over {}",
                    axis.title
                ),
                ..read_table(table)
            });
        }
        for cost in [Cost::Cycles, Cost::Instructions] {
            charts.push(RecordedChart {
                name: format!("{core}-{}", cost.title().replace("estimated ", "")),
                title: format!("{title}: {}", cost.title()),
                svg: visibility_plot::svg(&counts, title, cost)?,
            });
        }
    }
    tables.push(RecordedTable {
        title: "Bytes of flash and RAM".to_owned(),
        ..read_table(parts(&page, MEMORY)?.1)
    });
    Ok(RecordedVisibility {
        measured: parts(&page, MEASURED)?.1.trim().to_owned(),
        tables,
        charts,
    })
}

/// The cells of a table of the page, without a title.
fn read_table(table: &str) -> RecordedTable {
    let cells = |line: &str| {
        let cells = line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned());
        cells.collect::<Vec<_>>()
    };
    RecordedTable {
        title: String::new(),
        columns: table.lines().take(1).flat_map(cells).collect(),
        rows: table.lines().skip(2).map(cells).collect(),
    }
}

/// The counts of a table of an axis.
fn read_counts(table: &str) -> anyhow::Result<Counts> {
    let count = |cell: &String| match cell.split_once('/') {
        Some((instructions, cycles)) => Ok(Some([number(instructions)?, number(cycles)?])),
        None => Ok(None),
    };
    let rows = read_table(table).rows;
    let rows = rows.iter().map(|cells| cells.iter().skip(1).map(count).collect());
    rows.collect()
}

/// A number whose digits are grouped.
fn number(cell: &str) -> anyhow::Result<u64> {
    let digits = cell.trim().replace(',', "");
    digits.parse().with_context(|| format!("no number: {cell}"))
}

/// The line that says when it was measured.
fn measured_on(day: Date) -> String {
    format!("Measured on {day}, zrow {}.\n", env!("CARGO_PKG_VERSION"))
}

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
    let page = replaced(&page, MEASURED, &measured_on(OffsetDateTime::now_utc().date()))?;
    write(PAGE, &page)?;
    write(PLOT, &visibility_plot::svg(&of_m4, CORE_TITLES[0], Cost::Cycles)?)
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

    #[test]
    fn the_tables_are_whole_and_the_chart_has_their_figures() -> anyhow::Result<()> {
        let page = read(PAGE)?;
        let mut of_m4: Vec<Counts> = Vec::new();
        for axis in &AXES {
            for core in CORE_NAMES {
                let (_, found, _) = parts(&page, &table_name(axis, core))?;
                let counts = read_counts(found)?;
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
            visibility_plot::svg(&of_m4, CORE_TITLES[0], Cost::Cycles)? == read(PLOT)?,
            "run `cargo run --release -- visibility`"
        );
        Ok(())
    }

    #[test]
    fn ram_is_that_of_the_types() -> anyhow::Result<()> {
        let page = read(PAGE)?;
        let (_, found, _) = parts(&page, MEMORY)?;
        let rows = read_table(found).rows;
        let flash = rows.iter().map(|cells| number(&cells[1]));
        let flash: Vec<u64> = flash.collect::<anyhow::Result<_>>()?;
        assert_eq!(found, memory_table(&flash)?, "run `cargo run --release -- visibility`");
        Ok(())
    }

    #[test]
    fn what_is_recorded_is_the_page() -> anyhow::Result<()> {
        let recorded = recorded_visibility()?;
        assert!(recorded.measured.starts_with("Measured on 20"), "{}", recorded.measured);
        assert_eq!(recorded.tables.len(), CORE_NAMES.len() * AXES.len() + 1);
        for table in &recorded.tables {
            assert_eq!(table.rows.len(), HIDDEN_SURFACES.len(), "{}", table.title);
            assert!(table.rows.iter().all(|row| row.len() == table.columns.len()));
        }
        let names = recorded.charts.iter().map(|chart| chart.name.as_str());
        assert!(names.eq(["m4-cycles", "m4-instructions", "m0plus-cycles", "m0plus-instructions"]));
        // The first one is that of the page.
        assert!(recorded.charts[0].svg == read(PLOT)?);
        Ok(())
    }

    #[test]
    fn the_day_is_written_with_two_digits_each() -> anyhow::Result<()> {
        let line = measured_on(Date::from_ordinal_date(2028, 60)?);
        assert!(line.starts_with("Measured on 2028-02-29, zrow "), "{line}");
        Ok(())
    }
}
