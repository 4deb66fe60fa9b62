//! Writes a font as a Rust module: `cargo run --release -- font FILE.ttf --size 24 --chars '0-9.:°C'`.

use std::{fs, path::PathBuf, process::ExitCode};

use anyhow::{Context, ensure};
use clap::Parser;
use zrow_font::{
    characters,
    font::{Hinting, Options, Source},
    module::{self, Origin, grouped},
};

/// Converts a TrueType or OpenType font to a Rust module with coverage masks, for `zrow::draw::MaskTextStyle`.
///
/// The module is a derived work of the font: what the font says about its licence is copied into it. Where a licence
/// reserves the font's name, choose another one with --name.
#[derive(Parser)]
#[command(name = "cargo run --release -- font", version)]
struct Arguments {
    /// The font: TTF, OTF, or the first one of a TTC
    file: PathBuf,
    /// Pixels of the em square; capitals are about seven tenths of that high
    #[arg(long)]
    size: f32,
    /// The characters: a list in which a minus between two characters is a range, as in '0-9.:°C'. Write \- for a minus
    #[arg(long, allow_hyphen_values = true)]
    chars: String,
    /// How outlines are fitted to rows of pixels
    #[arg(long, value_enum, default_value_t)]
    hinting: Hinting,
    /// Leaves kerning out
    #[arg(long)]
    no_kerning: bool,
    /// Drawn for characters that the font does not have; without it they take no space
    #[arg(long, allow_hyphen_values = true)]
    replacement: Option<char>,
    /// The name of the `static`, such as DIGITS_24 [default: family and size]
    #[arg(long)]
    name: Option<String>,
    /// Where the module is written [default: the name in lower case, in this folder]
    #[arg(long)]
    output: Option<PathBuf>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let file = arguments.file.display();
    let mut list = characters::parse(&arguments.chars)?;
    if let Some(replacement) = arguments.replacement
        && let Err(index) = list.binary_search(&replacement)
    {
        list.insert(index, replacement);
    }
    let options = Options {
        size: arguments.size,
        characters: list,
        hinting: arguments.hinting,
        kerning: !arguments.no_kerning,
        replacement: arguments.replacement,
    };
    let bytes = fs::read(&arguments.file).with_context(|| format!("cannot read {file}: pass the path of a font"))?;
    let font = Source::new(&bytes)
        .and_then(|source| source.convert(&options))
        .with_context(|| format!("cannot convert {file}"))?;
    let name = match &arguments.name {
        Some(name) => {
            let is_name = name
                .chars()
                .all(|character| character.is_ascii_alphanumeric() || character == '_')
                && name.starts_with(|first: char| first.is_ascii_alphabetic());
            ensure!(is_name, "--name {name} is no Rust name: write one such as DIGITS_24");
            name.clone()
        }
        None => module::static_name(&font.names.family, arguments.size),
    };
    let file_name = arguments.file.file_name().unwrap_or_default().to_string_lossy();
    let origin = Origin {
        file: &file_name,
        characters: &arguments.chars,
    };
    let module = module::write(&font, &options, &name, origin);
    let output = arguments
        .output
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("{}.rs", name.to_ascii_lowercase())));
    fs::write(&output, &module.source)
        .with_context(|| format!("cannot write {}: choose another path with --output", output.display()))?;
    println!(
        "{}: {name}, {} {} at {} px",
        output.display(),
        font.names.family,
        font.names.style,
        arguments.size
    );
    println!(
        "{} glyphs, {} kerning pairs, lines of {} rows, one every {} rows",
        font.glyphs.len(),
        font.kerning.len(),
        font.above + font.below,
        font.line_height
    );
    println!(
        "{} bytes: {} of masks, {} of tables",
        grouped(module.bytes),
        grouped(module.mask_bytes),
        grouped(module.bytes - module.mask_bytes)
    );
    Ok(())
}
