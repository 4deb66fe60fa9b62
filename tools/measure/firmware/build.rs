//! Chooses the memory map of the emulated board that runs the target.

use std::{env, error::Error, fs, path::PathBuf};

/// `mps2-an386`: 4 MB of code memory and 4 MB of data memory.
const MPS2_AN386: &str = "MEMORY
{
  FLASH (rx)  : ORIGIN = 0x00000000, LENGTH = 4M
  RAM   (rwx) : ORIGIN = 0x20000000, LENGTH = 4M
}
";

fn main() -> Result<(), Box<dyn Error>> {
    let reference_board = "../../../memory.x";
    // A Cortex-M3 is measured on the reference board, anything else on the board with room for frame buffers.
    let map = match env::var("TARGET")?.as_str() {
        "thumbv7m-none-eabi" => fs::read_to_string(reference_board)?,
        _ => MPS2_AN386.to_owned(),
    };
    let out = PathBuf::from(env::var("OUT_DIR")?);
    fs::write(out.join("memory.x"), map)?;
    println!("cargo::rustc-link-search={}", out.display());
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    // The linker's map of each program goes beside the program: OUT_DIR is three folders below.
    let programs = out.ancestors().nth(3).ok_or("OUT_DIR is no cargo folder")?;
    for source in fs::read_dir("src/bin")? {
        let name = source?.path().file_stem().ok_or("a program without a name")?.to_owned();
        let map = programs.join(&name).with_extension("map");
        println!("cargo::rustc-link-arg-bin={}=-Map={}", name.display(), map.display());
    }
    println!("cargo::rerun-if-changed=src/bin");
    println!("cargo::rerun-if-changed={reference_board}");
    println!("cargo::rerun-if-changed=build.rs");
    Ok(())
}
