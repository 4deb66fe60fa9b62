//! Writes the playground, a page that opens from disk, and checks in a browser that it draws what the simulator draws.

mod browser;
mod counts;
mod native;
mod page;
mod program;

use std::{
    fs,
    path::{Path, PathBuf},
};

use anyhow::Context;
use clap::Parser;

/// Writes the playground: a page that opens from disk, in which a scene is edited and drawn row by row.
#[derive(clap::Parser)]
#[command(name = "playground", version)]
struct Options {
    /// Opens the page in a headless Chromium and compares its canvas with the simulator's picture, pixel by pixel
    #[arg(long)]
    check: bool,
    /// With --check, writes pictures of the page into this folder
    #[arg(long, value_name = "FOLDER", requires = "check")]
    screenshots: Option<PathBuf>,
    /// Counts the items of the page's scenes on an emulated Cortex-M4, and keeps the counts in tools/playground/recorded.json
    #[arg(long, conflicts_with = "check")]
    record: bool,
    /// Folder for the page
    #[arg(long, default_value = "target/playground")]
    output: PathBuf,
}

fn main() -> anyhow::Result<()> {
    let options = Options::parse();
    if options.record {
        return counts::record();
    }
    if options.check {
        browser::check_installed()?;
    }
    let page = write(&options.output)?;
    if options.check {
        browser::check(&page, options.screenshots.as_deref())?;
    }
    Ok(())
}

/// Writes the page into a folder.
fn write(folder: &Path) -> anyhow::Result<PathBuf> {
    let program = program::build()?;
    let compressed = program::compress(&program)?;
    let page = page::assemble(&compressed)?;
    fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    let path = folder.join("index.html");
    fs::write(&path, &page).with_context(|| format!("cannot write {}", path.display()))?;
    println!(
        "{}: {} bytes, with a program of {}, {} compressed; open it in a browser",
        path.display(),
        page.len(),
        program.len(),
        compressed.len()
    );
    Ok(path)
}
