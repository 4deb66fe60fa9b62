//! Commands that are programs of their own: each is built when it is first called, so that drawing the scenes does not wait
//! for what only a report needs.

use std::{
    env,
    ffi::OsString,
    process::{Command, ExitStatus},
};

use anyhow::Context;

/// The command-line arguments that a tool gets, as they were typed.
#[derive(clap::Args)]
#[command(disable_help_flag = true)]
pub struct Options {
    /// Options of the tool; `--help` lists them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    options: Vec<OsString>,
}

/// Builds the program `zrow-NAME` and runs it, with some first arguments and those that were typed; it says itself what went
/// wrong.
///
/// # Errors
/// Cargo cannot be started.
pub fn run(name: &str, first: &[&str], options: &Options) -> anyhow::Result<ExitStatus> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let package = format!("zrow-{name}");
    // Cargo's own progress is shown: the first build of a tool takes a minute or more.
    Command::new(cargo)
        .args(["run", "--release", "--package", &package, "--bin", &package, "--"])
        .args(first)
        .args(&options.options)
        .status()
        .with_context(|| format!("cannot start cargo, which builds {package}"))
}
