//! Reads the materials of a Wavefront MTL file: `Kd` and `map_Kd`. Everything else describes light that zrow does not compute.

use anyhow::{Context, bail, ensure};

use crate::{
    lines::{keyword, numbers, path, shown, statements, text},
    model::{Material, Picture},
};

/// Reads a material library; `file` is its path as seen from the model's folder.
///
/// # Errors
/// Each bad line, by its number.
pub fn parse(bytes: &[u8], file: &str) -> anyhow::Result<Vec<Material>> {
    let mut materials = Vec::new();
    for (line, statement) in statements(&text(bytes)) {
        let place = format!("{file} line {line}");
        read(&statement, file, &place, &mut materials).with_context(|| place.clone())?;
    }
    Ok(materials)
}

fn read(statement: &str, file: &str, place: &str, materials: &mut Vec<Material>) -> anyhow::Result<()> {
    let (keyword, rest) = keyword(statement);
    match keyword {
        "newmtl" => {
            ensure!(!rest.is_empty(), "newmtl has no name: write newmtl NAME");
            materials.push(Material {
                name: rest.to_owned(),
                color: [1.0; 3],
                picture: None,
            });
        }
        "Kd" => of_material(materials)?.color = color(rest)?,
        "map_Kd" => {
            let picture = Picture {
                path: picture_path(file, rest)?,
                named_at: place.to_owned(),
            };
            of_material(materials)?.picture = Some(picture);
        }
        _ => {}
    }
    Ok(())
}

fn of_material(materials: &mut [Material]) -> anyhow::Result<&mut Material> {
    materials
        .last_mut()
        .context("it belongs to no material: write newmtl NAME above it")
}

fn color(words: &str) -> anyhow::Result<[f64; 3]> {
    let first = keyword(words).0;
    if first == "spectral" || first == "xyz" {
        bail!("Kd {first} is not read: write Kd with red, green and blue from 0 to 1");
    }
    let color = numbers(words, &[3], "Kd with red, green and blue from 0 to 1")?;
    for &component in &color {
        // Exporters round up.
        ensure!(
            (0.0..=1.001).contains(&component),
            "{component} is no colour: write Kd with red, green and blue from 0 to 1"
        );
    }
    Ok([color[0].min(1.0), color[1].min(1.0), color[2].min(1.0)])
}

/// The picture's path from the model's folder: in the file it is seen from the folder of the materials.
fn picture_path(library: &str, name: &str) -> anyhow::Result<String> {
    ensure!(!name.is_empty(), "map_Kd names no file: write map_Kd PICTURE.png");
    ensure!(
        !name.starts_with('-'),
        "options of map_Kd such as {} are not read: write map_Kd PICTURE.png",
        shown(keyword(name).0)
    );
    let name = path(name)?;
    Ok(match library.rsplit_once('/') {
        Some((folder, _)) if !name.starts_with('/') => format!("{folder}/{name}"),
        _ => name,
    })
}
