//! `measure`: counts instructions, flash and RAM of firmware that runs in QEMU, and holds them against the budgets.

mod accuracy;
mod case;
mod cases;
mod counts;
mod depth_test;
mod docs;
mod effects;
mod firmware;
mod playground;
mod report;
mod selection;
mod siblings;
mod visibility;

use std::{
    collections::HashMap,
    fs,
    path::{Path, PathBuf},
};

use anyhow::{Context, bail, ensure};
use indicatif::{ProgressBar, ProgressStyle};

use case::{Case, Figure};
use counts::Counts;
use firmware::{Build, Level};

pub use docs::{RecordedChart, RecordedTable, RecordedVisibility, recorded_visibility};
pub use selection::NothingSelected;

/// Counts instructions, flash and RAM on emulated Cortex-M boards.
#[derive(clap::Parser)]
#[command(name = "measure", version)]
pub struct Options {
    /// Measures only what has this text in its name
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Measures only on targets with this text in their name, such as thumbv7em
    #[arg(long, value_name = "TEXT")]
    target: Option<String>,
    /// Writes the figures as an array of JSON objects
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Writes the figures into the tables of docs/algorithms.md and docs/band-height.md, and draws the plot of the latter; with
    /// --only into the page that has what was measured
    #[arg(long)]
    docs: bool,
    /// Counts instructions alone: the plugin that estimates cycles is one for QEMU 4.2 to 8.1
    #[arg(long)]
    no_cycles: bool,
    /// Fails when a budget is missed, too
    #[arg(long)]
    strict: bool,
}

/// Builds what is needed, runs it, prints the tables.
///
/// # Errors
///
/// [`NothingSelected`] where the options leave nothing to measure; a tool is missing, a firmware does not build or run, or a
/// count is void.
pub fn run(options: &Options) -> anyhow::Result<()> {
    let mut cases = cases::all();
    // Reports of their own, which take minutes: counted where they are asked for.
    let is_only = |report| options.only.as_ref().is_some_and(|only| only.starts_with(report));
    if is_only("effect") {
        cases.extend(effects::cases());
    }
    if is_only("visibility") {
        cases.extend(visibility::cases());
    }
    if is_only("playground") {
        cases.extend(playground::cases());
    }
    // A program for each sibling, which has no budget: for the page that shows them.
    if is_only("flash.sibling") || options.docs {
        cases.extend(siblings::flash());
    }
    if is_only("depth_test") || is_only("combined_solids") || options.docs {
        cases.extend(depth_test::flash());
    }
    let cases = selection::select(cases, options.only.as_deref(), options.target.as_deref())?;
    let plugin = if options.no_cycles {
        None
    } else {
        Some(firmware::plugin()?)
    };
    let counts = measure(&cases, plugin.as_deref())?;
    let figures: Vec<Figure> = cases
        .iter()
        .map(|case| case.figure(&counts))
        .collect::<anyhow::Result<_>>()?;
    report::print(&figures, &counts);
    if let Some(path) = &options.json {
        let text = serde_json::to_string_pretty(&report::json(&figures))?;
        fs::write(path, text + "\n").with_context(|| format!("cannot write {}", path.display()))?;
    }
    if options.docs {
        docs::refill(&figures)?;
    }
    let void: Vec<_> = figures.iter().filter_map(Figure::void_reason).collect();
    ensure!(void.is_empty(), "void counts:\n  {}", void.join("\n  "));
    let missed = figures.iter().filter(|figure| figure.pass() == Some(false)).count();
    ensure!(!options.strict || missed == 0, "budgets missed: {missed}");
    Ok(())
}

/// What the accuracy report takes over of a figure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Instructions of an operation on the emulated Cortex-M4, or bytes of a program.
    pub figure: f64,
    /// Estimated cycles of an operation; none where QEMU takes no plugin.
    pub cycles: Option<f64>,
}

/// Figures by the names that this command prints: instructions and cycles of operations on the emulated Cortex-M4, and bytes of
/// programs. What has no such name is not there.
///
/// # Errors
///
/// A tool is missing, a firmware does not build or run, or a count is void.
pub fn figures(names: &[String]) -> anyhow::Result<HashMap<String, Measured>> {
    let cases: Vec<_> = report_cases().filter(|case| names.contains(&case.name)).collect();
    let counts = match firmware::plugin().and_then(|plugin| measure(&cases, Some(&plugin))) {
        Ok(counts) => counts,
        // A newer QEMU takes no such plugin: instructions alone.
        Err(_) => measure(&cases, None)?,
    };
    let figures = cases.iter().map(|case| {
        let figure = case.figure(&counts)?;
        let (zrow, cycles) = (figure.zrow, figure.cycles);
        match figure.void_reason() {
            Some(why) => bail!("void: {why}"),
            None => Ok((case.name.clone(), Measured { figure: zrow, cycles })),
        }
    });
    figures.collect()
}

/// Whether there is such a figure.
pub fn has_figure(name: &str) -> bool {
    report_cases().any(|case| case.name == name)
}

/// What the accuracy report can ask for.
fn report_cases() -> impl Iterator<Item = Case> {
    let cases = cases::all()
        .into_iter()
        .chain(siblings::flash())
        .chain(accuracy::report_cases())
        .chain(effects::cases());
    cases.filter(|case| case.is_count_on_m4() || case.is_memory())
}

/// Builds and runs every firmware that some case needs, once, with the plugin that estimates cycles if there is one.
fn measure(cases: &[Case], plugin: Option<&Path>) -> anyhow::Result<Counts> {
    let mut builds: Vec<Build> = cases.iter().flat_map(Case::builds).collect();
    builds.sort();
    builds.dedup();
    let progress = ProgressBar::new(2 * builds.len() as u64)
        .with_style(ProgressStyle::with_template("{bar:24} {pos}/{len} {wide_msg}")?);
    let mut counts = Counts::default();
    // One build at a time, so that a firmware's libraries are compiled once; a program is run before the next one takes
    // its place.
    for group in builds.chunk_by(|a, b| a.shares_compilation(b)) {
        let names: Vec<_> = group.iter().map(Build::name).collect();
        let level = match group[0].level {
            Level::Speed => "3",
            Level::Size => "s",
        };
        progress.set_message(format!(
            "building {} for {}, opt-level {level}",
            names.join(", "),
            group[0].target
        ));
        firmware::build(group)?;
        progress.inc(group.len() as u64);
        for build in group {
            progress.set_message(format!("running {} on {}", build.name(), build.machine()));
            let mut wanted: Vec<_> = cases.iter().filter_map(|case| case.count_name(build)).collect();
            // A count once for all of its variants.
            wanted.dedup();
            counts.read(build, &firmware::run(build, &wanted, plugin)?)?;
            progress.inc(1);
        }
    }
    progress.finish_and_clear();
    Ok(counts)
}
