//! Hands the linker this board's memory map.
use std::{env, fs, path::PathBuf};

fn main() {
    let map = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("memory.x");
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    fs::copy(&map, out.join("memory.x")).expect("memory.x is copied from the board's folder");
    println!("cargo::rustc-link-search={}", out.display());
    // Here and not in RUSTFLAGS, so that flags a caller sets there do not lose the linker script.
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    println!("cargo::rerun-if-changed={}", map.display());
}
