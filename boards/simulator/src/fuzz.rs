//! `fuzz`: starts the fuzzer, which is built when it is first asked for.

use std::{env, ffi::OsString, process::Command};

use anyhow::{Context, ensure};

/// Options of this command: those of the fuzzer, which explains them.
#[derive(clap::Args)]
#[command(disable_help_flag = true)]
pub struct Options {
    /// Options of the fuzzer; `fuzz --help` lists them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    options: Vec<OsString>,
}

/// Builds the fuzzer and runs it.
///
/// # Errors
///
/// Cargo cannot be started, or the fuzzer found something.
pub fn run(options: &Options) -> anyhow::Result<()> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["run", "--release", "--quiet", "--package", "zrow-fuzz", "--"])
        .args(&options.options)
        .status()
        .context("cannot start cargo, which builds the fuzzer")?;
    ensure!(
        status.success(),
        "the fuzzer found something: its report says how to see it again"
    );
    Ok(())
}
