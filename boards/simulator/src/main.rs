//! The desktop board of zrow: draws the demo scenes, runs the emulated boards, measures.

mod emulate;
mod gallery;
mod measure;

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
    /// Runs the OLED firmware in QEMU and compares its panel with the simulator, pixel by pixel.
    Emulate(emulate::Options),
    /// Counts instructions, flash and RAM on emulated Cortex-M boards.
    Measure(measure::Options),
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    match arguments.command {
        None => gallery::run(&arguments.gallery),
        Some(Command::Emulate(options)) => emulate::run(&options),
        Some(Command::Measure(options)) => measure::run(&options),
    }
}
