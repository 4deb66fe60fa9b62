//! What the items of the page's scenes take on the chip: counted by `measure`, and kept, because no browser can count it.

use std::{collections::BTreeMap, env, fs, path::Path, process::Command};

use anyhow::{Context, ensure};
use serde::{Deserialize, Serialize};
use time::OffsetDateTime;

/// Counts, as the repository keeps them.
#[derive(Debug, Serialize, Deserialize)]
pub struct Record {
    /// The day, as year, month and day.
    counted: String,
    /// What was counted on.
    chip: String,
    /// Instructions and estimated cycles of a frame, by the names of `measure`.
    figures: BTreeMap<String, (f64, f64)>,
}

/// A figure as `measure` writes it.
#[derive(Debug, Deserialize)]
struct Figure {
    name: String,
    zrow: f64,
    cycles: Option<f64>,
}

/// The counts of the repository.
pub fn read() -> anyhow::Result<Record> {
    serde_json::from_str(include_str!("../recorded.json")).context("recorded.json")
}

/// Counts anew.
///
/// # Errors
/// A tool is missing, the firmware does not build or run, a count is void, or the counts cannot be written.
pub fn record() -> anyhow::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let json = env::temp_dir().join(format!("zrow-playground-{}.json", std::process::id()));
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args([
            "run",
            "--release",
            "--package",
            "zrow-measure",
            "--bin",
            "zrow-measure",
            "--",
            "--only",
            "playground",
        ])
        .arg("--json")
        .arg(&json)
        .current_dir(folder)
        .status()
        .context("cannot start cargo, which builds zrow-measure")?;
    ensure!(status.success(), "the counts are missing or void");
    let text = fs::read_to_string(&json).with_context(|| format!("cannot read {}", json.display()))?;
    // Read; what stays behind is not worth failing.
    let _ = fs::remove_file(&json);
    let figures: Vec<Figure> = serde_json::from_str(&text)?;
    let figures = figures
        .into_iter()
        .filter_map(|figure| Some((figure.name, (figure.zrow, figure.cycles?))));
    let record = Record {
        counted: OffsetDateTime::now_utc().date().to_string(),
        chip: "an emulated Cortex-M4".to_owned(),
        figures: figures.collect(),
    };
    let path = folder.join("recorded.json");
    let text = serde_json::to_string_pretty(&record)? + "\n";
    fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    println!("{}: {} figures", path.display(), record.figures.len());
    Ok(())
}
