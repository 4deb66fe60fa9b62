//! `cargo run --release -- fuzz` at the root of the repository: the plain loop over all fuzz targets.

use anyhow::Context;
use clap::{Parser, Subcommand};
use zrow_fuzz::{
    registry,
    runner::{self, worker},
};

/// Fuzzes every public module of zrow: structured inputs from a seed, in a plain loop.
#[derive(Parser)]
#[command(version, about, args_conflicts_with_subcommands = true)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    options: runner::Options,
}

#[derive(Subcommand)]
enum Command {
    /// Checks inputs of one target: the loop starts such a process for each.
    #[command(hide = true)]
    Worker {
        /// The target.
        #[arg(long)]
        name: String,
        #[command(flatten)]
        task: worker::Task,
    },
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    match arguments.command {
        None => runner::run(&arguments.options),
        Some(Command::Worker { name, task }) => {
            let target = registry::named(&name).with_context(|| format!("no target is called {name}"))?;
            worker::run(&target, &task);
            Ok(())
        }
    }
}
