//! `docs/band-height.md`: what a frame of the dashboard costs in bands of some heights, prepared and replayed, as a table and as a plot.
//! The README has the same table.

use anyhow::Context;

use crate::{
    case::Figure,
    docs::{
        bands::{Bands, Cost, HEIGHTS},
        page::{parts, read, write},
        plot,
    },
    report::grouped,
};

/// The pages with the table.
const PAGES: [&str; 2] = ["docs/band-height.md", "README.md"];
/// The name of the table in the comment before it.
const TABLE: &str = "band_height";
const PLOT: &str = "docs/band-height.svg";

/// The names of all figures of the page.
pub fn names() -> Vec<String> {
    HEIGHTS.into_iter().flat_map(Bands::names).collect()
}

/// Writes the table into its pages, and draws the plot.
///
/// # Errors
///
/// A figure was not measured, or has no cycles; a page has no place for the table.
pub fn refill(figures: &[Figure]) -> anyhow::Result<()> {
    let measured = HEIGHTS.map(|rows| Bands::measured(rows, figures));
    let bands: Vec<Bands> = measured.into_iter().collect::<anyhow::Result<_>>()?;
    let table = table(&bands);
    for file in PAGES {
        let page = read(file)?;
        let (before, _, after) = parts(&page, TABLE).context(file)?;
        write(file, &format!("{before}{table}{after}"))?;
    }
    write(PLOT, &plot::svg(&bands)?)
}

fn table(bands: &[Bands]) -> String {
    let lines: String = bands.iter().map(line).collect();
    format!("| rows of a band | bytes | prepared | replayed |\n|---:|---:|---:|---:|\n{lines}")
}

/// The row of the table.
fn line(bands: &Bands) -> String {
    let cost = |(instructions, cycles): Cost| format!("{} / {}", grouped(instructions as f64), grouped(cycles as f64));
    let (bytes, prepared, replayed) = (grouped(bands.bytes.into()), cost(bands.prepared), cost(bands.replayed));
    format!("| {} | {bytes} | {prepared} | {replayed} |\n", bands.rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{case::V7EM, cases, docs::bands::ROW_BYTES};

    /// The bands of a table, as they were measured.
    fn read_table(table: &str) -> Option<Vec<Bands>> {
        let number = |text: &str| text.trim().replace(',', "").parse::<u64>().ok();
        let cost = |cell: &str| {
            let (instructions, cycles) = cell.split_once('/')?;
            Some((number(instructions)?, number(cycles)?))
        };
        let line = |line: &str| {
            let cells: Vec<_> = line.split('|').collect();
            let [_, rows, bytes, prepared, replayed, _] = cells[..] else {
                return None;
            };
            Some(Bands {
                rows: number(rows)?.try_into().ok()?,
                bytes: number(bytes)?.try_into().ok()?,
                prepared: cost(prepared)?,
                replayed: cost(replayed)?,
            })
        };
        table.lines().skip(2).map(line).collect()
    }

    #[test]
    fn both_pages_and_the_plot_have_the_same_figures() -> anyhow::Result<()> {
        let [page, readme] = PAGES.map(read);
        let (page, readme) = (page?, readme?);
        let (_, found, _) = parts(&page, TABLE)?;
        let bands = read_table(found).context("a row is no row of figures")?;
        assert_eq!(found, table(&bands));
        assert_eq!(bands.iter().map(|bands| bands.rows).collect::<Vec<_>>(), HEIGHTS);
        assert!(bands.iter().all(|bands| bands.bytes == bands.rows * ROW_BYTES));
        assert_eq!(parts(&readme, TABLE)?.1, found);
        let plot = plot::svg(&bands)?;
        assert!(
            plot == read(PLOT)?,
            "run `cargo run --release -- measure --only picture.dashboard --docs`"
        );
        Ok(())
    }

    #[test]
    fn every_figure_is_measured() {
        let cases = cases::all();
        for name in names() {
            assert!(
                cases.iter().any(|case| case.name == name && case.target == V7EM),
                "{name}"
            );
        }
    }

    #[test]
    fn figures_that_are_missing_are_named() {
        let error = refill(&[]).expect_err("nothing was measured").to_string();
        assert!(error.contains("picture.dashboard was not measured"), "{error}");
    }
}
