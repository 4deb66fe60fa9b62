//! Runs the firmware of the boards in emulators and compares their panels with the simulator, frame by frame and pixel by pixel.

mod child;
mod firmware;
mod oled;
mod pico;

use anyhow::{Context, Result, ensure};
use clap::Parser;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// Runs the firmware of a board in an emulator and compares its panel with the simulator, pixel by pixel.
#[derive(clap::Parser)]
#[command(name = "emulate", version)]
pub struct Options {
    /// The board.
    #[arg(long, value_enum, default_value = "oled")]
    board: Board,
    /// All boards, one after the other.
    #[arg(long, conflicts_with = "board")]
    all: bool,
    /// Frames of each scene to compare, from the first one on; all 64 of the OLED and 3 of the Pico where nothing is said.
    #[arg(long, value_parser = clap::value_parser!(u32).range(3..=64))]
    frames: Option<u32>,
    /// Folder for the pictures of both sides.
    #[arg(long, default_value = "target/gallery/emulated")]
    output: PathBuf,
}

/// A board that an emulator runs.
#[derive(Clone, Copy, clap::ValueEnum)]
enum Board {
    /// LM3S6965EVB in QEMU: Cortex-M3, 128 x 64 OLED in 16 greys
    Oled,
    /// Raspberry Pi Pico in rp2040js: Cortex-M0+, ST7789 of 240 x 320 pixels, rows sent by DMA
    Pico,
}

impl Board {
    fn compare_scenes(self, frames: Option<u32>, output: &Path) -> Result<usize> {
        match self {
            Self::Oled => oled::compare_scenes(frames, output),
            Self::Pico => pico::compare_scenes(frames, output),
        }
    }
}

fn main() -> anyhow::Result<()> {
    run(&Options::parse())
}

/// Runs the command; fails unless every pixel of every frame is the same.
pub fn run(options: &Options) -> Result<()> {
    fs::create_dir_all(&options.output).with_context(|| format!("cannot create {}", options.output.display()))?;
    let boards = if options.all {
        &[Board::Oled, Board::Pico][..]
    } else {
        &[options.board]
    };
    let mut differing = 0;
    for board in boards {
        differing += board.compare_scenes(options.frames, &options.output)?;
    }
    println!("pictures in {}", options.output.display());
    ensure!(differing == 0, "an emulated panel differs from the simulator");
    Ok(())
}
