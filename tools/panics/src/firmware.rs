//! Builds the firmware whose programs are read.

use std::{
    path::{Path, PathBuf},
    process::Command,
};

use anyhow::{Context, ensure};

/// The targets without and with a divider, which take different ways through divisions.
pub const TARGETS: [&str; 2] = ["thumbv7em-none-eabi", "thumbv6m-none-eabi"];

/// The target on which every division is a call.
pub const WITHOUT_DIVIDER: &str = "thumbv6m-none-eabi";

/// The optimization level of a build.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Level {
    /// For speed.
    #[value(name = "3")]
    Speed,
    /// For size.
    #[value(name = "s")]
    Size,
}

impl Level {
    /// The name that Cargo has for an optimization level, in `CARGO_PROFILE_RELEASE_OPT_LEVEL`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Speed => "3",
            Self::Size => "s",
        }
    }
}

/// Builds the programs of `tools/panics/firmware` for some targets and returns the folder where each target has one of its
/// own.
///
/// The targets are built at the same time and share what runs on this machine, such as macros.
///
/// # Errors
///
/// There is no compiler for a target, or the firmware does not compile.
pub fn build(targets: &[&str], level: Level) -> anyhow::Result<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = root.join("tools/panics/firmware");
    let output = Command::new(root.join("boards/build-firmware"))
        .arg(&folder)
        .args([&targets.join(","), "--locked", "--target-dir", "target"])
        .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", level.name())
        // Set by `cargo run` for this program; the script may call another compiler, which has libraries of its own.
        .env_remove("LD_LIBRARY_PATH")
        .output()
        .context("cannot start boards/build-firmware, a bash script")?;
    ensure!(
        output.status.success(),
        "building the firmware:\n{}",
        String::from_utf8_lossy(&output.stderr).trim_end()
    );
    Ok(folder.join("target"))
}
