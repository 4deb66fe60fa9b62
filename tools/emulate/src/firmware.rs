//! Builds the board's firmware through the script that firmware is built with by hand.

use anyhow::{Context, Result, bail, ensure};
use std::{
    path::{Path, PathBuf},
    process::Command,
    thread::sleep,
    time::{Duration, Instant},
};

/// Long enough to fetch and build everything, `core` included, on a slow machine.
const BUILD_TIMEOUT: Duration = Duration::from_secs(20 * 60);

/// Builds the firmware of the board whose folder has that name, and says where the program is. Cargo's own progress and the
/// script's advice what to install go to the terminal.
pub fn build(name: &str, target: &str) -> Result<PathBuf> {
    let boards = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../boards");
    let board = boards.join(name);
    let script = boards.join("build-firmware");
    let mut build = Command::new(&script)
        .arg(&board)
        .arg(target)
        // The folder in which all boards are built: from the board's own folder, where cargo runs.
        .args(["--target-dir", "../../target/boards"])
        // Set by `cargo run` for this program; the script may call another compiler, which has libraries of its own.
        .env_remove("LD_LIBRARY_PATH")
        .spawn()
        .with_context(|| format!("cannot run {}", script.display()))?;
    let deadline = Instant::now() + BUILD_TIMEOUT;
    let status = loop {
        match build.try_wait()? {
            Some(status) => break status,
            None if Instant::now() > deadline => {
                build.kill()?;
                build.wait()?;
                bail!(
                    "the firmware was not built within {} minutes",
                    BUILD_TIMEOUT.as_secs() / 60
                );
            }
            None => sleep(Duration::from_millis(50)),
        }
    };
    ensure!(status.success(), "the firmware of {name} was not built ({status})");
    let output = boards.join("../target/boards");
    Ok(output.join(target).join(format!("release/zrow-{name}")))
}
