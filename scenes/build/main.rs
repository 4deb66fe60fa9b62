//! Makes the tables that the scenes read from flash: meshes and their colours, a sine, a picture.

mod colors;
mod meshes;
mod picture;

use std::{env, error::Error, f64::consts::TAU, fmt, fmt::Write as _, fs, path::Path};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build");
    let folder = env::var("OUT_DIR")?;
    let folder = Path::new(&folder);
    fs::write(folder.join("meshes.rs"), mesh_tables()?)?;
    fs::write(folder.join("sine.rs"), sine_table())?;
    fs::write(folder.join("weather.rgb565"), picture::weather())?;
    Ok(())
}

fn mesh_tables() -> Result<String, fmt::Error> {
    let mut tables = String::new();
    for (name, mesh, colors) in [
        ("TORUS_AND_CUBE", meshes::torus_and_cube(), colors::torus_and_cube()),
        ("ICOSPHERE", meshes::icosphere(), colors::icosphere()),
        ("CUBE", meshes::cube(1.0), colors::cube()),
    ] {
        table(
            &mut tables,
            &format!("static {name}_VERTICES"),
            "[i16; 3]",
            &mesh.rounded_vertices(),
        )?;
        table(&mut tables, &format!("static {name}_FACES"), "[u16; 3]", &mesh.faces)?;
        let documented = format!("/// A colour for each face.\npub static {name}_COLORS");
        table(&mut tables, &documented, "Rgb565", &colors)?;
    }
    Ok(tables)
}

fn table<T: fmt::Debug>(text: &mut String, declaration: &str, kind: &str, values: &[T]) -> fmt::Result {
    writeln!(text, "{declaration}: [{kind}; {}] = {values:?};", values.len())
}

/// One turn in 512 steps, 16,384 for 1.
fn sine_table() -> String {
    let sines: Vec<i16> = (0..512)
        .map(|step| (f64::from(step) / 512.0 * TAU).sin() * 16_384.0)
        .map(|sine| sine.round() as i16)
        .collect();
    format!("{sines:?}")
}
