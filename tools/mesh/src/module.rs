//! The Rust module of a converted model, formatted as rustfmt would.

use std::fmt::Write;

use crate::{
    mesh::{Mesh, Options},
    module_parts::{grouped, plain, quoted, write_lines},
    quantize::Up,
    texture::Texture,
};

/// Columns up to which rustfmt keeps a statement on a line.
const COLUMNS: usize = 100;

/// What the head of each written module says.
pub const MARK: &str = "Written by zrow's converter";

/// Where a module comes from: what is written into its head.
#[derive(Debug, Copy, Clone)]
pub struct Origin<'a> {
    /// The name of the model's file, without folders.
    pub file: &'a str,
    /// The name that was chosen with `--name`.
    pub name: Option<&'a str>,
}

/// A module, and how many bytes of flash its tables take.
#[derive(Debug, Clone)]
pub struct Module {
    /// The Rust source.
    pub source: String,
    /// Bytes of all tables.
    pub bytes: usize,
}

/// Writes a mesh as a module with a `static` of that name.
pub fn write(mesh: &Mesh, options: Options, name: &str, origin: Origin<'_>) -> Module {
    let bytes = bytes(mesh);
    let mut source = head(mesh, options, origin, bytes);
    // Writing to a string does not fail.
    let _ = write_face_set(&mut source, mesh, name, origin);
    let _ = write_colors(&mut source, mesh, name);
    let _ = write_normals(&mut source, mesh, name);
    let _ = write_coordinates(&mut source, mesh, name);
    if let Some(texture) = &mesh.texture {
        let _ = write_texture(&mut source, texture, name);
    }
    let vertices = mesh.vertices.iter().map(|[x, y, z]| format!("[{x}, {y}, {z}],"));
    let _ = write_table(
        &mut source,
        "static VERTICES: [[i16; 3]; ",
        mesh.vertices.len(),
        vertices,
    );
    let faces = mesh.faces.iter().map(|[a, b, c]| format!("[{a}, {b}, {c}],"));
    let _ = write_table(&mut source, "static FACES: [[u16; 3]; ", mesh.faces.len(), faces);
    Module { source, bytes }
}

/// Bytes of all tables.
fn bytes(mesh: &Mesh) -> usize {
    let texture = mesh.texture.as_ref().map_or(0, |texture| 2 * texture.words.len());
    6 * mesh.vertices.len()
        + 6 * mesh.faces.len()
        + 2 * mesh.colors.len()
        + 2 * if mesh.normals.is_empty() {
            mesh.faces.len()
        } else {
            mesh.normals.len()
        }
        + 4 * mesh.coordinates.len()
        + texture
}

fn head(mesh: &Mesh, options: Options, origin: Origin<'_>, bytes: usize) -> String {
    let mut arguments = format!("{} --size {}", quoted(&plain(origin.file)), options.size);
    for (is_chosen, option) in [(options.flat, " --flat"), (options.up == Up::Z, " --z-up")] {
        if is_chosen {
            arguments.push_str(option);
        }
    }
    if let Some(name) = origin.name {
        let _ = write!(arguments, " --name {name}");
    }
    format!(
        "//! {}: {} vertices, {} faces, {} bytes of flash.\n\
         //!\n\
         //! {MARK}; do not edit it, but convert again:\n\
         //! ```text\n\
         //! cargo run --release -- mesh {arguments}\n\
         //! ```\n\n\
         use embedded_graphics::pixelcolor::Rgb565;\n\
         use zrow::scene::FaceSet;\n",
        plain(origin.file),
        grouped(mesh.vertices.len()),
        grouped(mesh.faces.len()),
        grouped(bytes)
    )
}

fn write_face_set(to: &mut String, mesh: &Mesh, name: &str, origin: Origin<'_>) -> std::fmt::Result {
    writeln!(
        to,
        "\n/// {}: {} vertices, {} faces.",
        plain(origin.file),
        grouped(mesh.vertices.len()),
        grouped(mesh.faces.len())
    )?;
    let begin = format!("pub static {name}: FaceSet = match FaceSet::new(&VERTICES, &FACES) {{");
    if begin.len() > COLUMNS {
        writeln!(to, "#[rustfmt::skip]")?;
    }
    writeln!(
        to,
        "{begin}\n    Ok(faces) => faces,\n    Err(_) => panic!(\"a face names a vertex that is not there\"),\n}};"
    )
}

fn write_colors(to: &mut String, mesh: &Mesh, name: &str) -> std::fmt::Result {
    let color = |[red, green, blue]: &[u8; 3]| format!("Rgb565::new({red}, {green}, {blue})");
    let count = mesh.colors.len();
    write!(to, "\n/// The colour of each face.")?;
    match mesh.colors.first() {
        Some(first) if mesh.colors.iter().all(|color| color == first) => {
            let line = format!(
                "pub static {name}_COLORS: [Rgb565; {count}] = [{}; {count}];",
                color(first)
            );
            let skip = if line.len() > COLUMNS { "\n#[rustfmt::skip]" } else { "" };
            writeln!(to, "{skip}\n{line}")
        }
        _ => {
            let colors = mesh.colors.iter().map(|one| color(one) + ",");
            write_table(to, &format!("pub static {name}_COLORS: [Rgb565; "), count, colors)
        }
    }
}

fn write_normals(to: &mut String, mesh: &Mesh, name: &str) -> std::fmt::Result {
    let text = |[a, b]: [i8; 2]| format!("[{a}, {b}],");
    let axes = "octahedral, 127 is 1, with x to the right, y up and z away from the viewer.";
    if mesh.normals.is_empty() {
        write!(to, "\n/// The normal of each face: {axes}")?;
        let begin = format!("pub static {name}_FACE_NORMALS: [[i8; 2]; ");
        return write_table(to, &begin, mesh.faces.len(), mesh.face_normals().map(text));
    }
    write!(to, "\n/// The normal of each vertex: {axes}")?;
    let begin = format!("pub static {name}_NORMALS: [[i8; 2]; ");
    write_table(to, &begin, mesh.normals.len(), mesh.normals.iter().copied().map(text))
}

fn write_coordinates(to: &mut String, mesh: &Mesh, name: &str) -> std::fmt::Result {
    if mesh.coordinates.is_empty() {
        return Ok(());
    }
    write!(
        to,
        "\n/// The texture coordinates of each vertex: u to the right and v down, in 1/4096 of the texture's width and height."
    )?;
    let coordinates = mesh.coordinates.iter().map(|[u, v]| format!("[{u}, {v}],"));
    let begin = format!("pub static {name}_COORDINATES: [[i16; 2]; ");
    write_table(to, &begin, mesh.coordinates.len(), coordinates)
}

fn write_texture(to: &mut String, texture: &Texture, name: &str) -> std::fmt::Result {
    let Texture {
        width, height, words, ..
    } = texture;
    writeln!(
        to,
        "\n/// The texture: RGB565 words, rows from the top on.\n#[rustfmt::skip]\n\
         pub static {name}_TEXTURE: [[u16; {width}]; {height}] = ["
    )?;
    for row in words.chunks(*width) {
        let words: Vec<String> = row.iter().map(|word| format!("0x{word:04x},")).collect();
        let lines: Vec<String> = words.chunks(12).map(|line| line.join(" ")).collect();
        writeln!(to, "    [\n        {}\n    ],", lines.join("\n        "))?;
    }
    writeln!(to, "];")
}

/// Writes a table whose type begins as it is given and ends with a length.
fn write_table(to: &mut String, begin: &str, count: usize, entries: impl Iterator<Item = String>) -> std::fmt::Result {
    writeln!(to, "\n#[rustfmt::skip]\n{begin}{count}] = [")?;
    write_lines(to, entries)?;
    writeln!(to, "];")
}
