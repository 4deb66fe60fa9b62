//! The program of the page: Rust, built as WebAssembly by the script that firmware is built with, and compressed.

use std::{fs, io::Write as _, path::Path, process::Command};

use anyhow::{Context, ensure};
use flate2::{Compression, write::GzEncoder};

const TARGET: &str = "wasm32-unknown-unknown";

/// Builds the program. Cargo's own progress, and what to install where the target is missing, go to the terminal.
///
/// # Errors
/// It cannot be built.
pub fn build() -> anyhow::Result<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let script = folder.join("../../boards/build-firmware");
    let crate_folder = folder.join("wasm");
    let status = Command::new(&script)
        .arg(&crate_folder)
        .arg(TARGET)
        .args(["--target-dir", "target"])
        // Set by `cargo run` for this program; the script may call another compiler, which has libraries of its own.
        .env_remove("LD_LIBRARY_PATH")
        .status()
        .with_context(|| format!("cannot run {}", script.display()))?;
    ensure!(status.success(), "the program of the page was not built ({status})");
    let path = crate_folder.join(format!("target/{TARGET}/release/zrow_playground_wasm.wasm"));
    fs::read(&path).with_context(|| format!("cannot read {}", path.display()))
}

/// The program as the page carries it: compressed by gzip, which browsers undo.
pub fn compress(program: &[u8]) -> anyhow::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(program)?;
    Ok(encoder.finish()?)
}
