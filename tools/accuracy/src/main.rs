//! `accuracy`: what every step of accuracy costs in time and memory, from real runs, as a page, tables and plots.
//!
//! A question is an [`Axis`](axis::Axis): one file, and one entry in [`AXES`]. A method of antialiasing is one entry in
//! [`zrow_methods::METHODS`], which the emulated chip counts as well; the same is true of ways to walk a line, to draw a
//! circle and to flatten a curve, of looks on small scenes in 3D and of ways to a sine. Another rasterizer is one entry in
//! `tools/bench`.

mod axis;
mod chart;
mod circles;
mod clipping;
mod counted;
mod coverage;
mod curves;
mod depth_width;
mod digits;
mod errors;
mod exact_line;
mod exact_space;
mod figures;
mod hard_cases;
mod host;
mod lead;
mod lines;
mod matrix_format;
mod names;
mod page;
mod pareto;
mod perspective;
mod picture;
mod positions;
mod rasterizers;
mod reference;
mod space;
mod sub_pixel;
mod tables;
mod timing;
mod trigonometry;
mod visibility;

use std::{
    fs,
    path::{Path, PathBuf},
    time::Duration,
};

use anyhow::Context as _;
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};

use axis::{Axis, Chapter, Context};
use counted::Counted;
use timing::Plan;

/// Every question, in the order of the page.
const AXES: &[&dyn Axis] = &[
    &coverage::Coverage,
    &hard_cases::HardCases,
    &sub_pixel::SubPixels,
    &clipping::Clipping,
    &lines::Lines,
    &circles::Circles,
    &curves::Curves,
    &depth_width::DepthWidth,
    &positions::Positions,
    &matrix_format::MatrixFormat,
    &perspective::Perspective,
    &trigonometry::Trigonometry,
    &rasterizers::Rasterizers,
    &visibility::Visibility,
];

/// Reports what each step of accuracy costs in time and memory: a page, tables, plots.
#[derive(clap::Parser)]
#[command(name = "accuracy", version)]
pub struct Options {
    /// Fewer inputs, short rounds, recorded counts instead of QEMU: within a minute, and coarse
    #[arg(long)]
    quick: bool,
    /// Folder for the report; it is made where it is missing [default: target/accuracy of the workspace]
    #[arg(long, value_name = "FOLDER")]
    output: Option<PathBuf>,
    /// Counts on the emulated chip and records that for quick runs, without a report
    #[arg(long)]
    record: bool,
    /// Runs only the axes with this text in their name
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

fn main() -> anyhow::Result<()> {
    run(&Options::parse())
}

/// Runs every method and writes the report.
///
/// # Errors
/// A file cannot be written, or a method refused its input.
pub fn run(options: &Options) -> anyhow::Result<()> {
    if options.record {
        let names: Vec<_> = AXES.iter().flat_map(|axis| axis.counts()).collect();
        return Counted::record(&names);
    }
    let folder = options.output.clone().unwrap_or_else(default_folder);
    fs::create_dir_all(&folder).with_context(|| format!("cannot make the folder {}", folder.display()))?;
    chart::load_font()?;
    let only = options.only.as_deref().unwrap_or_default();
    let axes: Vec<_> = AXES.iter().filter(|axis| axis.name().contains(only)).collect();
    anyhow::ensure!(!axes.is_empty(), "no axis has such a name");

    let plan = Plan::new(options.quick);
    let counted = if options.quick {
        Counted::from_record()?
    } else {
        let names: Vec<_> = axes.iter().flat_map(|axis| axis.counts()).collect();
        Counted::count(&names)
    };
    let style = ProgressStyle::with_template("{spinner} {bar:24} {pos}/{len} {wide_msg}")?;
    let progress = ProgressBar::new(axes.len() as u64 + 1).with_style(style);
    // A chapter may say nothing for a while.
    progress.enable_steady_tick(Duration::from_millis(200));
    let context = Context {
        plan: &plan,
        counted: &counted,
        progress: &|text| progress.set_message(text.to_owned()),
    };
    let mut chapters = Vec::new();
    for axis in axes {
        progress.set_message(axis.name());
        chapters.push(axis.run(&context).with_context(|| axis.name())?);
        progress.inc(1);
    }
    progress.set_message("writing");
    let written = write(&chapters, &context, &folder)?;
    progress.finish_and_clear();

    if plan.quick {
        println!("a quick run: its figures are coarse");
    }
    if let Some(when) = counted.recorded() {
        println!("instructions and cycles were counted {when}");
    }
    if let Some(why) = counted.missing() {
        println!("no instructions: {why}");
    }
    println!("{written} files in {}; open index.html", folder.display());
    Ok(())
}

fn default_folder() -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    workspace.canonicalize().unwrap_or(workspace).join("target/accuracy")
}

/// Writes the page, the tables and the plots; returns how many files.
fn write(chapters: &[Chapter], context: &Context<'_>, folder: &Path) -> anyhow::Result<usize> {
    let mut written = 0;
    let mut save = |name: String, bytes: &[u8]| {
        let path = folder.join(name);
        written += 1;
        fs::write(&path, bytes).with_context(|| format!("cannot write {}", path.display()))
    };
    save("index.html".to_owned(), page::html(chapters, context)?.as_bytes())?;
    for chapter in chapters {
        for (name, text) in tables::csv(chapter)? {
            save(name, &text)?;
        }
        for diagram in &chapter.diagrams {
            let name = format!("{}-{}.svg", chapter.name, diagram.name);
            save(name, diagram.svg.as_bytes())?;
        }
        for group in chapter.groups() {
            for (cost, chart) in figures::charts(chapter, group) {
                let name = format!("{}-{}", chapter.group_name(group), cost.name());
                save(format!("{name}.svg"), chart.svg()?.as_bytes())?;
                save(format!("{name}.png"), &chart.png()?)?;
            }
        }
    }
    Ok(written)
}

#[cfg(test)]
mod tests {
    use super::{AXES, Counted};

    /// Whoever adds a count records it: `cargo run --release -- accuracy --record`.
    #[test]
    fn every_count_is_recorded() -> anyhow::Result<()> {
        let recorded = Counted::from_record()?;
        for axis in AXES {
            for name in axis.counts() {
                assert!(recorded.get(&name).instructions.is_some(), "{name} is not recorded");
            }
        }
        Ok(())
    }

    #[test]
    fn every_axis_asks_for_counts_that_there_are() {
        for axis in AXES {
            let counts = axis.counts();
            let is_recorded = ["hard_cases", "visibility"].contains(&axis.name());
            assert_eq!(counts.is_empty(), is_recorded, "{}", axis.name());
            for name in counts {
                assert!(zrow_measure::has_figure(&name), "{}: {name}", axis.name());
            }
        }
    }
}
