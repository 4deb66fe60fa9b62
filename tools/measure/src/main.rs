//! The command `measure`.

use clap::Parser;

fn main() -> anyhow::Result<()> {
    zrow_measure::run(&zrow_measure::Options::parse())
}
