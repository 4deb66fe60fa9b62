//! Writes a model as a Rust module: `cargo run --release -- mesh MODEL.obj --size 512`.

use std::{
    fs,
    path::{Path, PathBuf},
    process::ExitCode,
};

use anyhow::{Context, ensure};
use clap::Parser;
use zrow_mesh::{
    convert,
    edges::Beside,
    levels::MOST_LEVELS,
    mesh::{Mesh, Options},
    module::{self, Module, Origin},
    module_parts::{grouped, is_name, name_of},
    quantize::Up,
    read,
};

/// Converts an OBJ or STL model to a Rust module: a `zrow::scene::FaceSet`, the colours of its faces, and where the model has
/// them, normals, texture coordinates and a texture.
///
/// The model keeps its origin: it turns about that one. Materials (MTL) and the texture (PNG) are read from the files that the
/// model names.
#[derive(Parser)]
#[command(name = "cargo run --release -- mesh", version)]
struct Arguments {
    /// The model: OBJ, or STL as text or binary
    file: PathBuf,
    /// What the greatest coordinate of the model becomes
    #[arg(long, default_value_t = 512, value_parser = clap::value_parser!(u16).range(1..=32_767))]
    size: u16,
    /// Writes the normals of faces, which `FlatLit` shading takes, and not those of vertices
    #[arg(long)]
    flat: bool,
    /// Writes that many coarser levels of detail too, each with half of the faces of the one before
    #[arg(long, value_name = "COUNT", default_value_t = 0)]
    #[arg(value_parser = clap::value_parser!(u8).range(..=i64::from(MOST_LEVELS)))]
    levels: u8,
    /// Writes a table of edges too, to draw the model as lines; at creases faces turn by more than so many degrees, such as 30
    #[arg(long, value_name = "DEGREES", value_parser = clap::value_parser!(u8).range(..=180))]
    edges: Option<u8>,
    /// The model's z is up, as in files of CAD programs, and not y
    #[arg(long)]
    z_up: bool,
    /// The name of the `static`, such as TEAPOT [default: that of the file]
    #[arg(long)]
    name: Option<String>,
    /// Where the module is written [default: beside the model, as MODEL.rs]
    #[arg(short, long)]
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
    let file = arguments.file.file_name().unwrap_or_default().to_string_lossy();
    let folder = arguments.file.parent().unwrap_or(Path::new(""));
    let files = |path: &str| {
        read::bytes(&folder.join(path)).with_context(|| format!("{path} is named here: put it beside the model"))
    };
    let bytes = read::bytes(&arguments.file).context("pass the path of a model")?;
    let model = read::model(&bytes, &file, &files)?;
    let name = name(arguments)?;
    let options = Options {
        size: arguments.size,
        up: if arguments.z_up { Up::Z } else { Up::Y },
        flat: arguments.flat,
        levels: arguments.levels,
        edges: arguments.edges,
    };
    let mesh = convert::convert(&model, options, &files)?;
    let origin = Origin {
        file: &file,
        name: arguments.name.as_deref(),
    };
    let module = module::write(&mesh, options, &name, origin);
    let output = output(arguments)?;
    fs::write(&output, &module.source)
        .with_context(|| format!("cannot write {}: choose another path with --output", output.display()))?;
    eprintln!("{}: {name}", output.display());
    report(&mesh, &module, options);
    Ok(())
}

/// The path that was chosen, or one beside the model; what lies there must be a module that was written before.
fn output(arguments: &Arguments) -> anyhow::Result<PathBuf> {
    if let Some(output) = &arguments.output {
        return Ok(output.clone());
    }
    let output = arguments.file.with_extension("rs");
    let is_free = !output.exists() || fs::read_to_string(&output).is_ok_and(|source| source.contains(module::MARK));
    ensure!(
        is_free,
        "{} is there, and was not written by this command: choose another path with --output",
        output.display()
    );
    Ok(output)
}

/// The name that was chosen, or that of the file.
fn name(arguments: &Arguments) -> anyhow::Result<String> {
    if let Some(name) = &arguments.name {
        ensure!(
            is_name(name),
            "--name {name} is no name of a static: write one such as TEAPOT"
        );
        return Ok(name.clone());
    }
    let stem = arguments.file.file_stem().unwrap_or_default().to_string_lossy();
    let name = name_of(&stem);
    ensure!(
        is_name(&name),
        "{stem} gives no name: choose one with --name, such as TEAPOT"
    );
    Ok(name)
}

fn report(mesh: &Mesh, module: &Module, options: Options) {
    let percent = 100.0 / f64::from(options.size);
    eprintln!(
        "{} vertices, {} faces, {} dropped (without area after rounding)",
        grouped(mesh.vertices.len()),
        grouped(mesh.faces.len()),
        grouped(mesh.dropped)
    );
    eprintln!(
        "rounded by up to {:.3} units ({:.3} % of the size), {:.3} units ({:.3} %) in the mean",
        mesh.greatest_error,
        mesh.greatest_error * percent,
        mesh.mean_error,
        mesh.mean_error * percent
    );
    for (number, level) in (1..).zip(&mesh.levels) {
        eprintln!(
            "level {number}: {} vertices, {} faces, off by up to {:.3} units ({:.3} %), {:.3} units ({:.3} %) in the mean",
            grouped(level.vertices),
            grouped(level.faces.len()),
            level.greatest_error,
            level.greatest_error * percent,
            level.mean_error,
            level.mean_error * percent
        );
    }
    if let Some(edges) = &mesh.edges {
        let smooth = edges.iter().filter(|edge| matches!(edge.beside, Beside::Smooth(_)));
        eprintln!(
            "{} edges, {} of them boundaries and creases",
            grouped(edges.len()),
            grouped(edges.len() - smooth.count())
        );
    }
    eprintln!("{} bytes of flash", grouped(module.bytes));
    eprintln!(
        "axes: the file's {}; zrow's z points away from the viewer, so {} and the corners of faces are reversed",
        match options.up {
            Up::Y => "y is up (or else --z-up)",
            Up::Z => "z is up",
        },
        match options.up {
            Up::Y => "z is negated",
            Up::Z => "y and z change places",
        }
    );
    for note in &mesh.notes {
        eprintln!("note: {note}");
    }
}
