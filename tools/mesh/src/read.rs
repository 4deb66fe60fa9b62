//! Reads a model by the ending of its name, and the files beside it.

use std::{fs::File, io::Read, path::Path};

use anyhow::{Context, bail, ensure};

use crate::{model::Model, obj, stl};

/// Bytes of a file at most: a model of 65,535 faces takes a few million.
const MOST_BYTES: u64 = 256 << 20;

/// Reads a whole file, which must not be endless.
///
/// # Errors
/// What the system says, and files that are too large.
pub fn bytes(path: &Path) -> anyhow::Result<Vec<u8>> {
    let cannot = || format!("cannot read {}", path.display());
    let file = File::open(path).with_context(cannot)?;
    ensure!(
        file.metadata().with_context(cannot)?.is_file(),
        "{} is no file: pass the path of one",
        path.display()
    );
    let mut bytes = Vec::new();
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).with_context(cannot)?;
    ensure!(
        bytes.len() as u64 <= MOST_BYTES,
        "{} has more than {MOST_BYTES} bytes: simplify the model",
        path.display()
    );
    Ok(bytes)
}

/// Reads a model; `files` reads what it names.
///
/// # Errors
/// Each bad line, by its number, and names that end in neither `.obj` nor `.stl`.
pub fn model(bytes: &[u8], file: &str, files: obj::Files<'_>) -> anyhow::Result<Model> {
    let ending = file.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
    match ending.as_deref() {
        Some("obj") => obj::parse(bytes, file, files),
        Some("stl") => stl::parse(bytes, file),
        _ => bail!("{file} is neither .obj nor .stl: export the model as one of them"),
    }
}
