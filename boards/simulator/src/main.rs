//! The desktop board of zrow: draws the demo scenes, runs the emulated boards, measures, reports and checks.

mod accuracy;
mod emulate;
mod fuzz;
mod gallery;
mod measure;
mod panics;

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

#[derive(Subcommand)]
enum Command {
    /// Reports what each step of accuracy costs in time and memory: a page, tables, plots.
    Accuracy(accuracy::Options),
    /// Runs the OLED firmware in QEMU and compares its panel with the simulator, pixel by pixel.
    Emulate(emulate::Options),
    /// Checks random inputs of every public module for as long as it is told to.
    Fuzz(fuzz::Options),
    /// Counts instructions, flash and RAM on emulated Cortex-M boards.
    Measure(measure::Options),
    /// Links firmware that calls the whole public API, and fails if a panic is in it.
    Panics(panics::Options),
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    match arguments.command {
        None => gallery::run(&arguments.gallery),
        Some(Command::Accuracy(options)) => accuracy::run(&options),
        Some(Command::Emulate(options)) => emulate::run(&options),
        Some(Command::Fuzz(options)) => fuzz::run(&options),
        Some(Command::Measure(options)) => measure::run(&options),
        Some(Command::Panics(options)) => panics::run(&options),
    }
}
