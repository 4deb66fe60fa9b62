//! `panics`: links firmware that calls the whole public API with values unknown to the compiler, and names every panic in it;
//! and shows that preparing a scene with parallel rays links no division.

mod firmware;
mod names;
mod program;
mod report;

use std::{collections::BTreeSet, fs, path::Path};

use anyhow::{Context, ensure};
use clap::Parser;

use firmware::Level;
use program::Program;

/// Links firmware that calls the whole public API, and fails if a panic is in it.
#[derive(clap::Parser)]
#[command(name = "panics", version)]
pub struct Options {
    /// Builds only for targets with this text in their name, such as thumbv7em
    #[arg(long, value_name = "TEXT")]
    target: Option<String>,
    /// The optimization level of the firmware
    #[arg(long, value_name = "LEVEL", default_value = "3")]
    opt_level: Level,
}

fn main() -> anyhow::Result<()> {
    run(&Options::parse())
}

/// Builds the firmware for each target, reads it, and prints every panic with its callers.
///
/// # Errors
///
/// There is a panic; or the firmware does not build; or the panics planted in a program of their own were not all found.
pub fn run(options: &Options) -> anyhow::Result<()> {
    let wanted = options.target.as_deref().unwrap_or_default();
    let targets: Vec<_> = firmware::TARGETS
        .into_iter()
        .filter(|target| target.contains(wanted))
        .collect();
    ensure!(
        !targets.is_empty(),
        "no such target; there are: {}",
        firmware::TARGETS.join(", ")
    );
    let root = fs::canonicalize(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))?;
    let folder = firmware::build(&targets, options.opt_level)?;
    let mut calls = 0;
    for target in targets {
        println!("{target}, opt-level {}:", options.opt_level.name());
        let programs = folder.join(target).join("release");
        println!("  planted panics found: {}", find_planted(&programs.join("planted"))?);
        let bytes = read(&programs.join("exercises"))?;
        let program = Program::parse(&bytes)?;
        println!(
            "  {} functions of zrow in {} exercises, {} bytes of machine code",
            program.functions_of_zrow,
            program.exercises().count(),
            program.text
        );
        let panics: BTreeSet<_> = program.panics().collect();
        println!("  panic functions linked: {}", panics.len());
        let findings = program.findings();
        print!("{}", report::report(&findings, &root));
        // A panic that only data refers to has no caller.
        calls += findings.len().max(panics.len());
        if target == firmware::WITHOUT_DIVIDER {
            check_divisions(&programs)?;
        }
    }
    ensure!(calls == 0, "panics are linked, calls of them: {calls}");
    Ok(())
}

/// Prints where divisions come from in a scene with parallel rays.
///
/// # Errors
///
/// One is reached from preparing such a scene; or none is found where a scene in perspective is prepared, or where either is
/// drawn, which sets the edges and planes of faces up.
fn check_divisions(programs: &Path) -> anyhow::Result<()> {
    for name in ["orthographic", "perspective"] {
        let bytes = read(&programs.join(name))?;
        let program = Program::parse(&bytes)?;
        for exercise in program.exercises() {
            let way = program.way_from(exercise, names::is_division)?;
            let shown = way.as_ref().map_or("none".to_owned(), |way| way.join(" -> "));
            println!("  divisions of {exercise}: {}", names::shortened(&shown));
            let has_none = name == "orthographic" && !exercise.ends_with("::draw");
            ensure!(way.is_none() == has_none, "divisions of {exercise}: {shown}");
        }
    }
    Ok(())
}

/// The number of panics found in a program where each function of the firmware holds one.
fn find_planted(path: &Path) -> anyhow::Result<usize> {
    let bytes = read(path)?;
    let program = Program::parse(&bytes)?;
    let planted: BTreeSet<_> = program.exercises().map(str::to_owned).collect();
    let findings = program.findings();
    let found: BTreeSet<_> = findings
        .iter()
        .flat_map(|finding| &finding.callers)
        .map(|frame| frame.function.clone())
        .collect();
    let missed: Vec<_> = planted.difference(&found).map(String::as_str).collect();
    ensure!(
        missed.is_empty(),
        "planted panics were not found: {}",
        missed.join(", ")
    );
    ensure!(planted.len() >= 2, "no panics are planted");
    Ok(planted.len())
}

fn read(path: &Path) -> anyhow::Result<Vec<u8>> {
    fs::read(path).with_context(|| format!("cannot read {}", path.display()))
}
