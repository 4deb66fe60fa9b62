//! The Rust module of a converted model, formatted as rustfmt would.

use std::fmt::Write;

use crate::{
    edges::{Beside, Edge},
    level::{Level, pick_from},
    mesh::{Mesh, Options},
    module_parts::{grouped, plain, quoted, write_lines},
    quantize::Up,
    texture::Texture,
};

/// Columns up to which rustfmt keeps a statement on a line.
const COLUMNS: usize = 100;

/// Pixels of the focal length for which the head says when levels are picked: a field of view of 90 degrees over 320 pixels.
const FOCAL_LENGTH: u16 = 160;

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
    let mut source = head(mesh, options, name, origin, bytes);
    // Writing to a string does not fail.
    let _ = write_face_set(&mut source, mesh, name, origin);
    let _ = write_neighbours(&mut source, mesh.faces.len(), name);
    let _ = write_colors(&mut source, &mesh.colors, name);
    let _ = write_normals(&mut source, mesh, name);
    let _ = write_coordinates(&mut source, mesh, name);
    if let Some(texture) = &mesh.texture {
        let _ = write_texture(&mut source, texture, name);
    }
    if let (Some(edges), Some(crease)) = (&mesh.edges, options.edges) {
        let _ = write_edges(&mut source, edges, crease, name);
    }
    for (number, level) in (1..).zip(&mesh.levels) {
        let _ = write_level(&mut source, mesh, level, &format!("{name}_LEVEL_{number}"));
    }
    let vertices = mesh.vertices.iter().map(|[x, y, z]| format!("[{x}, {y}, {z}],"));
    let _ = write_table(
        &mut source,
        "static VERTICES: [[i16; 3]; ",
        mesh.vertices.len(),
        vertices,
    );
    let _ = write_faces(&mut source, "static FACES: [[u16; 3]; ", &mesh.faces);
    for (number, level) in (1..).zip(&mesh.levels) {
        let begin = format!("static {name}_LEVEL_{number}_FACES: [[u16; 3]; ");
        let _ = write_faces(&mut source, &begin, &level.faces);
    }
    Module { source, bytes }
}

/// Bytes of all tables.
fn bytes(mesh: &Mesh) -> usize {
    let texture = mesh.texture.as_ref().map_or(0, |texture| 2 * texture.words.len());
    let of_face = if mesh.normals.is_empty() { 10 } else { 8 };
    let levels: usize = mesh.levels.iter().map(|level| of_face * level.faces.len()).sum();
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
        + levels
        + mesh.edges.as_ref().map_or(0, |edges| 8 * edges.len())
}

fn head(mesh: &Mesh, options: Options, name: &str, origin: Origin<'_>, bytes: usize) -> String {
    let mut arguments = format!("{} --size {}", quoted(&plain(origin.file)), options.size);
    for (is_chosen, option) in [(options.flat, " --flat"), (options.up == Up::Z, " --z-up")] {
        if is_chosen {
            arguments.push_str(option);
        }
    }
    if options.levels > 0 {
        let _ = write!(arguments, " --levels {}", options.levels);
    }
    if let Some(crease) = options.edges {
        let _ = write!(arguments, " --edges {crease}");
    }
    if let Some(name) = origin.name {
        let _ = write!(arguments, " --name {name}");
    }
    let levels = how_to_pick(mesh, name);
    let names = if mesh.edges.is_some() {
        "{Edge, FaceSet}"
    } else {
        "FaceSet"
    };
    format!(
        "//! {}: {} vertices, {} faces, {} bytes of flash.\n\
         //!\n\
         //! {MARK}; do not edit it, but convert again:\n\
         //! ```text\n\
         //! cargo run --release -- mesh {arguments}\n\
         //! ```\n{levels}\n\
         use embedded_graphics::pixelcolor::Rgb565;\n\
         use zrow::scene::{names};\n",
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

fn write_neighbours(to: &mut String, count: usize, name: &str) -> std::fmt::Result {
    let line = format!("pub static {name}_NEIGHBOURS: [[u16; 3]; {count}] = FaceSet::find_neighbours(&FACES);");
    let skip = if line.len() > COLUMNS { "\n#[rustfmt::skip]" } else { "" };
    writeln!(
        to,
        "\n/// The faces beside each face, 6 bytes each where they are used: `{name}.with_neighbours(&{name}_NEIGHBOURS)`.\n\
         #[allow(dead_code, reason = \"for antialiased silhouettes alone\")]{skip}\n{line}"
    )
}

fn write_colors(to: &mut String, colors: &[[u8; 3]], name: &str) -> std::fmt::Result {
    let color = |[red, green, blue]: &[u8; 3]| format!("Rgb565::new({red}, {green}, {blue})");
    let count = colors.len();
    write!(to, "\n/// The colour of each face.")?;
    match colors.first() {
        Some(first) if colors.iter().all(|color| color == first) => {
            let line = format!(
                "pub static {name}_COLORS: [Rgb565; {count}] = [{}; {count}];",
                color(first)
            );
            let skip = if line.len() > COLUMNS { "\n#[rustfmt::skip]" } else { "" };
            writeln!(to, "{skip}\n{line}")
        }
        _ => {
            let colors = colors.iter().map(|one| color(one) + ",");
            write_table(to, &format!("pub static {name}_COLORS: [Rgb565; "), count, colors)
        }
    }
}

fn write_normals(to: &mut String, mesh: &Mesh, name: &str) -> std::fmt::Result {
    if mesh.normals.is_empty() {
        return write_face_normals(to, mesh, &mesh.faces, name);
    }
    write!(to, "\n/// The normal of each vertex: {NORMAL_AXES}")?;
    let begin = format!("pub static {name}_NORMALS: [[i8; 2]; ");
    write_table(to, &begin, mesh.normals.len(), mesh.normals.iter().copied().map(normal))
}

fn write_face_normals(to: &mut String, mesh: &Mesh, faces: &[[u16; 3]], name: &str) -> std::fmt::Result {
    write!(to, "\n/// The normal of each face: {NORMAL_AXES}")?;
    let begin = format!("pub static {name}_FACE_NORMALS: [[i8; 2]; ");
    write_table(to, &begin, faces.len(), mesh.face_normals(faces).map(normal))
}

/// What normals are in.
const NORMAL_AXES: &str = "octahedral, 127 is 1, with x to the right, y up and z away from the viewer.";

fn normal([a, b]: [i8; 2]) -> String {
    format!("[{a}, {b}],")
}

/// Writes a level: it takes the first vertices, with their normals and texture coordinates.
fn write_level(to: &mut String, mesh: &Mesh, level: &Level, name: &str) -> std::fmt::Result {
    writeln!(
        to,
        "\n/// {} vertices, the first of all, and {} faces: within {:.2} units of the finest mesh.\n#[rustfmt::skip]\n\
         pub static {name}: FaceSet = match FaceSet::new(VERTICES.split_at({}).0, &{name}_FACES) {{\n    \
             Ok(faces) => faces,\n    \
             Err(_) => panic!(\"a face names a vertex that is not there\"),\n}};",
        grouped(level.vertices),
        grouped(level.faces.len()),
        level.greatest_error,
        level.vertices
    )?;
    write_colors(to, &level.colors, name)?;
    if mesh.normals.is_empty() {
        write_face_normals(to, mesh, &level.faces, name)?;
    }
    Ok(())
}

/// How an application picks a level: nothing without any.
fn how_to_pick(mesh: &Mesh, name: &str) -> String {
    let mut text = String::new();
    if mesh.levels.is_empty() {
        return text;
    }
    let _ = write!(
        text,
        "//!\n\
         //! A level is picked by its distance from the camera in units: its error is half a pixel at twice the error times\n\
         //! the focal length in pixels. All levels take the first vertices of one table, so normals and texture coordinates\n\
         //! are those of {name}. With a focal length of {FOCAL_LENGTH} pixels:\n\
         //! ```text\n\
         //! let (mesh, colors) = match distance {{\n"
    );
    let froms = mesh
        .levels
        .iter()
        .map(|level| pick_from(level.greatest_error, FOCAL_LENGTH));
    // A level that is no farther off than a finer one is taken instead of it.
    let mut nearest = u32::MAX;
    let mut arms = Vec::new();
    for (index, from) in froms.enumerate().rev() {
        if from < nearest {
            let until = if nearest == u32::MAX {
                "_".to_owned()
            } else {
                format!("..{nearest}")
            };
            arms.push((until, format!("{name}_LEVEL_{}", index + 1)));
            nearest = from;
        }
    }
    if nearest > 0 {
        arms.push((format!("..{nearest}"), name.to_owned()));
    }
    for (until, name) in arms.iter().rev() {
        let _ = writeln!(text, "//!     {until} => (&{name}, &{name}_COLORS[..]),");
    }
    text + "//! };\n//! ```\n"
}

fn write_faces(to: &mut String, begin: &str, faces: &[[u16; 3]]) -> std::fmt::Result {
    let lines = faces.iter().map(|[a, b, c]| format!("[{a}, {b}, {c}],"));
    write_table(to, begin, faces.len(), lines)
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

fn write_edges(to: &mut String, edges: &[Edge], crease: u8, name: &str) -> std::fmt::Result {
    write!(
        to,
        "\n/// Edges, for `Prepared::edges`: at creases faces turn by more than {crease} degrees."
    )?;
    let lines = edges.iter().map(|edge| {
        let [a, b] = edge.vertices;
        match edge.beside {
            Beside::Boundary(face) => format!("Edge::boundary([{a}, {b}], {face}),"),
            Beside::Crease([one, other]) => format!("Edge::crease([{a}, {b}], [{one}, {other}]),"),
            Beside::Smooth([one, other]) => format!("Edge::smooth([{a}, {b}], [{one}, {other}]),"),
        }
    });
    write_table(to, &format!("pub static {name}_EDGES: [Edge; "), edges.len(), lines)
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
