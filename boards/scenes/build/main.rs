//! Makes the tables that the scenes read from flash: meshes, a sine, a picture.

mod meshes;
mod picture;

use std::{env, error::Error, f64::consts::TAU, fmt::Write as _, fs, path::Path};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build");
    let folder = env::var("OUT_DIR")?;
    let folder = Path::new(&folder);
    fs::write(folder.join("meshes.rs"), mesh_tables()?)?;
    fs::write(folder.join("sine.rs"), sine_table())?;
    fs::write(folder.join("weather.rgb565"), picture::weather())?;
    Ok(())
}

fn mesh_tables() -> Result<String, Box<dyn Error>> {
    let mut tables = String::new();
    for (name, mesh) in [
        ("TORUS_AND_CUBE", meshes::torus_and_cube()),
        ("ICOSPHERE", meshes::icosphere()),
        ("CUBE", meshes::cube(1.0)),
    ] {
        let (vertices, faces, normals) = (mesh.rounded_vertices(), &mesh.faces, mesh.rounded_normals());
        table(&mut tables, &format!("{name}_VERTICES"), "[i16; 3]", &vertices)?;
        table(&mut tables, &format!("{name}_FACES"), "[u16; 3]", faces)?;
        table(&mut tables, &format!("{name}_NORMALS"), "[i8; 3]", &normals)?;
    }
    Ok(tables)
}

fn table<T: std::fmt::Debug>(text: &mut String, name: &str, kind: &str, values: &[T]) -> std::fmt::Result {
    writeln!(text, "static {name}: [{kind}; {}] = {values:?};", values.len())
}

/// One turn in 512 steps, 16,384 for 1.
fn sine_table() -> String {
    let sines: Vec<i16> = (0..512)
        .map(|step| (f64::from(step) / 512.0 * TAU).sin() * 16_384.0)
        .map(|sine| sine.round() as i16)
        .collect();
    format!("{sines:?}")
}
