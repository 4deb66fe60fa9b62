//! The tables behind the charts, as CSV files.

use anyhow::anyhow;

use super::axis::{Chapter, Entry};

/// The coverage file's columns are fixed: other programs read them.
const COVERAGE_COLUMNS: [&str; 7] = [
    "class",
    "method",
    "rms255",
    "max255",
    "bytes_per_row",
    "ns",
    "instructions",
];

/// The files of a chapter: names and contents; what was not measured is empty.
pub fn csv(chapter: &Chapter) -> anyhow::Result<Vec<(String, Vec<u8>)>> {
    // A chapter without entries is tables and drawings alone. That of other rasterizers may have none for once.
    let whole = if chapter.figures.is_empty() {
        summaries(chapter)?
    } else {
        whole(chapter)?
    };
    if chapter.name != "coverage" {
        return Ok(vec![(format!("{}.csv", chapter.name), whole)]);
    }
    let rows = chapter.entries.iter().map(coverage_row);
    let coverage = rows_of(&COVERAGE_COLUMNS, rows)?;
    Ok(vec![
        ("coverage.csv".to_owned(), coverage),
        ("coverage-with-spread.csv".to_owned(), whole),
    ])
}

fn coverage_row(entry: &Entry) -> Vec<String> {
    let figure = |index: usize| entry.figures.get(index).map(|figure| format!("{figure:.4}"));
    vec![
        entry.group.clone(),
        entry.method.clone(),
        figure(0).unwrap_or_default(),
        figure(1).unwrap_or_default(),
        entry.memory_bytes.to_string(),
        number(entry.time.map(|time| time.median)),
        number(entry.chip.instructions),
    ]
}

fn whole(chapter: &Chapter) -> anyhow::Result<Vec<u8>> {
    let mut columns = vec!["group", "method"];
    columns.extend(&chapter.figures);
    columns.extend(chapter.memory);
    columns.extend([
        "ns",
        "ns lower quartile",
        "ns upper quartile",
        "rounds",
        "instructions",
        "cycles",
        "flash bytes",
    ]);
    let rows = chapter.entries.iter().map(|entry| {
        let mut row = vec![entry.group.clone(), entry.method.clone()];
        row.extend(entry.figures.iter().map(|figure| format!("{figure:.4}")));
        row.extend(chapter.memory.map(|_| entry.memory_bytes.to_string()));
        row.extend([
            number(entry.time.map(|time| time.median)),
            number(entry.time.map(|time| time.low)),
            number(entry.time.map(|time| time.high)),
            entry.time.map(|time| time.rounds.to_string()).unwrap_or_default(),
            number(entry.chip.instructions),
            number(entry.chip.cycles),
            number(entry.chip.flash_bytes),
        ]);
        row
    });
    rows_of(&columns, rows)
}

/// A line for each cell of the tables of a chapter that is nothing but tables and drawings.
fn summaries(chapter: &Chapter) -> anyhow::Result<Vec<u8>> {
    let mut lines = Vec::new();
    for summary in &chapter.summaries {
        for (method, cells) in summary.rows.iter().filter_map(|row| row.split_first()) {
            for (cell, column) in cells.iter().zip(summary.columns.iter().skip(1)) {
                lines.push(
                    [&summary.title, &method.text, column, &cell.text]
                        .map(String::clone)
                        .to_vec(),
                );
            }
        }
    }
    rows_of(&["table", "method", "column", "figure"], lines.into_iter())
}

fn number(number: Option<f64>) -> String {
    number.map(|number| format!("{number:.1}")).unwrap_or_default()
}

fn rows_of(columns: &[&str], rows: impl Iterator<Item = Vec<String>>) -> anyhow::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(columns)?;
    for row in rows {
        writer.write_record(row)?;
    }
    writer.into_inner().map_err(|error| anyhow!("{error}"))
}
