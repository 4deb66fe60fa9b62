//! The desktop board of zrow: draws the demo scenes, and starts the tools that emulate, measure, report and check.

mod gallery;
mod tool;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Draws zrow's demo scenes without a board or a window.
#[derive(Parser)]
#[command(version, about)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    gallery: gallery::Options,
}

/// The tools. Each lies in a folder of its name in `tools/`.
#[derive(Subcommand)]
enum Command {
    /// Reports what each step of accuracy costs in time and memory: a page, tables, plots
    Accuracy(tool::Options),
    /// Builds the firmware of every board, and prints how much flash and static RAM it takes
    Boards(tool::Options),
    /// Measures what each effect costs the teapot on the chips, and writes docs/effects.md
    Effects(tool::Options),
    /// Runs firmware of a board in an emulator and compares its panel with the simulator, pixel by pixel
    Emulate(tool::Options),
    /// Writes a font as a Rust module: coverage masks for antialiased text
    Font(tool::Options),
    /// Checks random inputs of every public module for as long as it is told to
    Fuzz(tool::Options),
    /// Counts instructions, flash and RAM on emulated Cortex-M boards
    Measure(tool::Options),
    /// Writes an OBJ or STL model as a Rust module: faces, colours, normals, a texture
    Mesh(tool::Options),
    /// Links firmware that calls the whole public API, and fails if a panic is in it
    Panics(tool::Options),
    /// Writes the playground: a page in which a scene is edited and drawn row by row
    Playground(tool::Options),
    /// Measures what each method of visibility costs over faces and layers, and writes docs/visibility.md
    Visibility(tool::Options),
}

fn main() -> anyhow::Result<ExitCode> {
    let arguments = Arguments::parse();
    let mut first: &[&str] = &[];
    let (name, options) = match &arguments.command {
        None => {
            gallery::run(&arguments.gallery)?;
            return Ok(ExitCode::SUCCESS);
        }
        Some(Command::Accuracy(options)) => ("accuracy", options),
        Some(Command::Boards(options)) => ("boards", options),
        Some(Command::Emulate(options)) => ("emulate", options),
        Some(Command::Effects(options)) => {
            first = &["--only", "effect.", "--docs"];
            ("measure", options)
        }
        Some(Command::Font(options)) => ("font", options),
        Some(Command::Fuzz(options)) => ("fuzz", options),
        Some(Command::Measure(options)) => ("measure", options),
        Some(Command::Mesh(options)) => ("mesh", options),
        Some(Command::Panics(options)) => ("panics", options),
        Some(Command::Playground(options)) => ("playground", options),
        Some(Command::Visibility(options)) => {
            first = &["--only", "visibility.", "--docs"];
            ("measure", options)
        }
    };
    let status = tool::run(name, first, options)?;
    Ok(if status.success() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}
