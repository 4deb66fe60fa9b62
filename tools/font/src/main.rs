//! Writes a font as a Rust module: `cargo run --release -- font FILE.ttf --size 24 --chars '0-9.:°C'`, or with `--outlines`
//! instead of a size.

use std::{fs, path::PathBuf, process::ExitCode};

use anyhow::{Context, ensure};
use clap::Parser;
use zrow_font::{
    characters,
    font::{Hinting, Names, Options, Source},
    module,
    module_parts::{MARK, Origin, grouped, is_name},
    outline_module,
    outlines::OutlineOptions,
};

/// Converts a TrueType or OpenType font to a Rust module: with coverage masks of one size, for `zrow::draw::MaskTextStyle`, or
/// with outlines for any size, for `zrow::draw::OutlineTextStyle`.
///
/// The module is a derived work of the font: what the font says about its licence is copied into it. Where a licence
/// reserves the font's name, choose another one with --name.
#[derive(Parser)]
#[command(name = "cargo run --release -- font", version)]
struct Arguments {
    /// The font: TTF, OTF, or the first one of a TTC
    file: PathBuf,
    /// Pixels of the em square; capitals are about seven tenths of that high
    #[arg(long, required_unless_present = "outlines", conflicts_with = "outlines")]
    size: Option<f32>,
    /// Writes outlines, which are drawn in any size
    #[arg(long)]
    outlines: bool,
    /// Units of the em square, which points are rounded to: with about 100, a point takes 2 bytes [default: those of the font, mostly 4 bytes]
    #[arg(long, conflicts_with = "size")]
    units: Option<u16>,
    /// The characters: a list in which a minus between two characters is a range, as in '0-9.:°C'. Write \- for a minus
    #[arg(long, allow_hyphen_values = true)]
    chars: String,
    /// How outlines are fitted to rows of pixels
    #[arg(long, value_enum, default_value_t, conflicts_with = "outlines")]
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

/// A module with its name, and what is said about it.
struct Written {
    name: String,
    source: String,
    summary: String,
}

fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let file = arguments.file.display();
    let mut list = characters::parse(&arguments.chars)?;
    if let Some(replacement) = arguments.replacement
        && let Err(index) = list.binary_search(&replacement)
    {
        list.insert(index, replacement);
    }
    let bytes = fs::read(&arguments.file).with_context(|| format!("cannot read {file}: pass the path of a font"))?;
    let source = Source::new(&bytes).with_context(|| format!("cannot convert {file}"))?;
    let file_name = arguments.file.file_name().unwrap_or_default().to_string_lossy();
    let origin = Origin {
        file: &file_name,
        characters: &arguments.chars,
        name: arguments.name.as_deref(),
    };
    let written = match arguments.size {
        Some(size) => masks(arguments, &source, size, list, origin),
        None => outlines(arguments, &source, list, origin),
    };
    let Written { name, source, summary } = written.with_context(|| format!("cannot convert {file}"))?;
    let output = output(arguments, &name)?;
    fs::write(&output, source)
        .with_context(|| format!("cannot write {}: choose another path with --output", output.display()))?;
    println!("{}: {name}, {summary}", output.display());
    Ok(())
}

/// The path that was chosen, or one in this folder; what lies there must be a module that was written before.
fn output(arguments: &Arguments, name: &str) -> anyhow::Result<PathBuf> {
    if let Some(output) = &arguments.output {
        return Ok(output.clone());
    }
    let output = PathBuf::from(format!("{}.rs", name.to_ascii_lowercase()));
    let is_free = !output.exists() || fs::read_to_string(&output).is_ok_and(|source| source.contains(MARK));
    ensure!(
        is_free,
        "{} is there, and was not written by this command: choose another path with --output",
        output.display()
    );
    Ok(output)
}

/// The name that was chosen, or the one that the font gives.
fn name(arguments: &Arguments, given: String) -> anyhow::Result<String> {
    let Some(name) = &arguments.name else {
        return Ok(given);
    };
    ensure!(
        is_name(name),
        "--name {name} is no name of a static: write one such as DIGITS_24"
    );
    Ok(name.clone())
}

/// Family and style, as they are printed.
fn title(names: &Names) -> String {
    format!("{} {}", names.family, names.style)
}

fn masks(
    arguments: &Arguments,
    source: &Source<'_>,
    size: f32,
    characters: Vec<char>,
    origin: Origin<'_>,
) -> anyhow::Result<Written> {
    let options = Options {
        size,
        characters,
        hinting: arguments.hinting,
        kerning: !arguments.no_kerning,
        replacement: arguments.replacement,
    };
    let font = source.convert(&options)?;
    let name = name(arguments, module::static_name(&font.names.family, size))?;
    let module = module::write(&font, &options, &name, origin);
    let summary = format!(
        "{} at {size} px\n{} glyphs, {} kerning pairs, lines of {} rows, one every {} rows\n{} bytes: {} of masks, {} of tables",
        title(&font.names),
        font.glyphs.len(),
        font.kerning.len(),
        font.above + font.below,
        font.line_height,
        grouped(module.bytes),
        grouped(module.mask_bytes),
        grouped(module.bytes - module.mask_bytes)
    );
    Ok(Written {
        name,
        source: module.source,
        summary,
    })
}

fn outlines(
    arguments: &Arguments,
    source: &Source<'_>,
    characters: Vec<char>,
    origin: Origin<'_>,
) -> anyhow::Result<Written> {
    let options = OutlineOptions {
        units: arguments.units,
        characters,
        kerning: !arguments.no_kerning,
        replacement: arguments.replacement,
    };
    let font = source.convert_outlines(&options)?;
    let name = name(arguments, outline_module::static_name(&font.names.family))?;
    let module = outline_module::write(&font, &options, &name, origin);
    let summary = format!(
        "{} in any size\n{} glyphs, {} points, {} kerning pairs, {} units an em\n{} bytes: {} of points, {} of tables",
        title(&font.names),
        font.glyphs.len(),
        grouped(module.points),
        font.kerning.len(),
        grouped(font.units.into()),
        grouped(module.bytes),
        grouped(module.point_bytes),
        grouped(module.bytes - module.point_bytes)
    );
    Ok(Written {
        name,
        source: module.source,
        summary,
    })
}
