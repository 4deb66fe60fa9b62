//! Opens the page in a headless Chromium, which a script drives, and compares its canvas with the simulator's pictures.

use std::{
    fs,
    io::{ErrorKind, Write as _},
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use anyhow::{Context, bail, ensure};
use serde_json::json;
use zrow_playground_scene::{Depth, ITEMS, Method, POINTS, PRESETS, Playground, Pot, Precision};

use crate::native;

/// Where Debian's package has it.
const CHROMIUM: &str = "/usr/bin/chromium";

/// Says what is missing.
///
/// # Errors
/// Node.js, the library that drives the browser, or the browser is not installed.
pub fn check_installed() -> anyhow::Result<()> {
    match Command::new("node").arg("--version").stdout(Stdio::null()).status() {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            bail!("Node.js is not installed; on Debian: apt-get install nodejs npm")
        }
        other => ensure!(other.context("cannot start node")?.success(), "node --version failed"),
    }
    ensure!(
        folder().join("node_modules/playwright-core").is_dir(),
        "playwright-core is not installed: npm ci --prefix tools/playground/browser"
    );
    ensure!(
        Path::new(CHROMIUM).exists(),
        "{CHROMIUM} is not installed; on Debian: apt-get install --no-install-recommends chromium"
    );
    Ok(())
}

/// Checks a page; pictures of it go into the folder, if there is one.
///
/// # Errors
/// A canvas differs from the simulator's picture, or the page does not do what it should.
pub fn check(page: &Path, screenshots: Option<&Path>) -> anyhow::Result<()> {
    let mut playground = Box::new(Playground::new());
    let mut states = Vec::new();
    for address in addresses() {
        let pixels = native::pixels(&mut playground, &address).context(address.clone())?;
        states.push(json!({ "address": address, "checksum": native::checksum(&pixels) }));
    }
    let screenshots = screenshots.map(absolute).transpose()?;
    let task = json!({
        "page": fs::canonicalize(page)?,
        "chromium": CHROMIUM,
        "states": states,
        "screenshots": screenshots,
    });
    let mut node = Command::new("node")
        .arg(folder().join("check.mjs"))
        .stdin(Stdio::piped())
        .spawn()
        .context("cannot start node")?;
    let mut input = node.stdin.take().context("the input of node")?;
    input.write_all(task.to_string().as_bytes())?;
    // Its end is the end of the task.
    drop(input);
    ensure!(node.wait()?.success(), "the page does not do what it should");
    Ok(())
}

/// The folder, which is created, from the root on.
fn absolute(folder: &Path) -> anyhow::Result<PathBuf> {
    fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    Ok(fs::canonicalize(folder)?)
}

/// States that together have each choice of the page at least once.
fn addresses() -> Vec<String> {
    let mut addresses: Vec<String> = PRESETS.iter().map(|preset| picture(preset.address)).collect();
    let shapes = picture(PRESETS[0].address);
    let with = |key: &str, value: &str| replaced(&shapes, key, value);
    addresses.extend(Method::ALL.iter().map(|method| with("method", method.name())));
    addresses.extend(
        Precision::ALL
            .iter()
            .map(|precision| with("precision", precision.name())),
    );
    addresses.extend(Depth::ALL.iter().map(|depth| with("depth", depth.name())));
    addresses.extend(Pot::ALL.iter().map(|pot| with("pot", pot.name())));
    addresses.extend([2, 7, 16, 0].map(|rows| with("rows", &rows.to_string())));
    let textured = with("pot", Pot::Textured.name());
    addresses.extend(
        Depth::ALL
            .iter()
            .map(|depth| replaced(&textured, "depth", depth.name())),
    );
    addresses.push(full(&shapes));
    addresses
}

/// A state with as many items of as many points as there may be, all of them between whole pixels.
fn full(address: &str) -> String {
    let pairs = address.split('&').filter(|pair| !pair.starts_with("item="));
    let mut text = pairs.collect::<Vec<_>>().join("&");
    for item in 0..ITEMS {
        let (left, top) = (5 + 80 * (item % 3), 5 + 80 * (item / 3));
        let points = (0..POINTS).map(|point| {
            let (x, y) = (left + 29 * point % 71, top + 43 * point % 71);
            format!("{x}.00390625:{y}.00390625")
        });
        let points = points.collect::<Vec<_>>().join(";");
        text += &format!("&item=even_odd,{:06x},0,{points}", 0x13_5790 * (item + 1));
    }
    text
}

/// What of an address the picture depends on.
fn picture(address: &str) -> String {
    let is_picture = |pair: &&str| {
        !["selected=", "point=", "loupe="]
            .iter()
            .any(|key| pair.starts_with(key))
    };
    address.split('&').filter(is_picture).collect::<Vec<_>>().join("&")
}

/// A state with another value.
fn replaced(address: &str, key: &str, value: &str) -> String {
    let pairs = address.split('&').map(|pair| match pair.split_once('=') {
        Some((other, _)) if other == key => format!("{key}={value}"),
        _ => pair.to_owned(),
    });
    pairs.collect::<Vec<_>>().join("&")
}

/// Where the script is.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("browser")
}
