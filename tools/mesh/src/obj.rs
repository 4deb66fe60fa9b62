//! Reads the polygons of a Wavefront OBJ file.

use std::collections::HashMap;

use anyhow::{Context, bail, ensure};

use crate::{
    lines::{keyword, numbers, path, shown, statements, text},
    model::{Corner, Face, Model},
    mtl,
};

/// Corners of one face at most: cutting a polygon into triangles takes a time that grows with the square of their number.
pub const MOST_CORNERS: usize = 1_024;

/// Reads a file that the model names, as seen from the model's folder.
pub type Files<'a> = &'a dyn Fn(&str) -> anyhow::Result<Vec<u8>>;

/// Reads an OBJ file and the materials that it names.
///
/// # Errors
/// Each bad line, by its number.
pub fn parse(bytes: &[u8], file: &str, files: Files<'_>) -> anyhow::Result<Model> {
    let mut reader = Reader {
        model: Model {
            file: file.to_owned(),
            ..Model::default()
        },
        files,
        materials: HashMap::new(),
        material: None,
        has_library: false,
        skipped: [0; 3],
    };
    for (line, statement) in statements(&text(bytes)) {
        reader
            .read(line, &statement)
            .with_context(|| format!("{file} line {line}"))?;
    }
    Ok(reader.finish())
}

struct Reader<'a> {
    model: Model,
    files: Files<'a>,
    /// Index of each material by its name.
    materials: HashMap<String, usize>,
    /// That of the faces to come.
    material: Option<usize>,
    has_library: bool,
    /// Lines and points, vertices with colours, uses of materials without a library.
    skipped: [usize; 3],
}

impl Reader<'_> {
    fn read(&mut self, line: usize, statement: &str) -> anyhow::Result<()> {
        let (keyword, rest) = keyword(statement);
        match keyword {
            "v" => self.position(rest)?,
            "vt" => {
                let values = numbers(rest, &[1, 2, 3], "vt u v")?;
                self.model
                    .coordinates
                    .push([values[0], values.get(1).copied().unwrap_or(0.0)]);
            }
            "vn" => {
                let values = numbers(rest, &[3], "vn x y z")?;
                self.model.normals.push([values[0], values[1], values[2]]);
            }
            "f" | "fo" => self.face(line, rest)?,
            "mtllib" => self.material_library(rest)?,
            "usemtl" => self.use_material(rest)?,
            "l" | "p" => self.skipped[0] += 1,
            // Names, smoothing groups, and what other programs draw with.
            "o" | "g" | "s" | "mg" | "vp" | "bevel" | "c_interp" | "d_interp" | "lod" | "usemap" | "maplib"
            | "shadow_obj" | "trace_obj" | "ctech" | "stech" => {}
            "cstype" | "deg" | "bmat" | "step" | "curv" | "curv2" | "surf" | "parm" | "trim" | "hole" | "scrv"
            | "sp" | "end" | "con" => {
                bail!("{keyword} belongs to curved surfaces: export the model as polygons")
            }
            _ => bail!(
                "{} is no statement of OBJ: remove the line, or export the model again",
                shown(keyword)
            ),
        }
        Ok(())
    }

    /// x, y, z; then perhaps a weight, or the colours that some programs write.
    fn position(&mut self, words: &str) -> anyhow::Result<()> {
        let values = numbers(words, &[3, 4, 6, 7], "v x y z")?;
        self.model.positions.push([values[0], values[1], values[2]]);
        self.skipped[1] += usize::from(values.len() > 4);
        Ok(())
    }

    fn face(&mut self, line: usize, words: &str) -> anyhow::Result<()> {
        let first = self.model.corners.len();
        for word in words.split_whitespace() {
            let corner = self.corner(word)?;
            self.model.corners.push(corner);
        }
        let count = self.model.corners.len() - first;
        ensure!(
            count >= 3,
            "a face has {count} corners: write at least 3, or remove the line"
        );
        ensure!(
            count <= MOST_CORNERS,
            "a face has {count} corners, and {MOST_CORNERS} at most: cut it into several"
        );
        self.model.faces.push(Face {
            corners: first..first + count,
            material: self.material,
            line,
        });
        Ok(())
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    fn corner(&self, word: &str) -> anyhow::Result<Corner> {
        let mut parts = word.split('/');
        let position = parts.next().unwrap_or_default();
        let mut other = |what, count| match parts.next() {
            None | Some("") => Ok(None),
            Some(part) => index(part, what, count).map(Some),
        };
        let corner = Corner {
            position: index(position, "v", self.model.positions.len())?,
            coordinates: other("vt", self.model.coordinates.len())?,
            normal: other("vn", self.model.normals.len())?,
        };
        ensure!(parts.next().is_none(), "{} is no corner: write v/vt/vn", shown(word));
        Ok(corner)
    }

    /// The name of one file, perhaps with spaces, or of several.
    fn material_library(&mut self, names: &str) -> anyhow::Result<()> {
        ensure!(!names.is_empty(), "mtllib names no file: write mtllib MATERIALS.mtl");
        let read = |name: &str| {
            let path = path(name)?;
            (self.files)(&path).map(|bytes| (path, bytes))
        };
        let libraries = match (read(names), names.split_whitespace().count()) {
            (Ok(library), _) => vec![library],
            (Err(error), 1) => return Err(error),
            (Err(_), _) => names.split_whitespace().map(read).collect::<anyhow::Result<_>>()?,
        };
        for (path, bytes) in libraries {
            for material in mtl::parse(&bytes, &path)? {
                self.materials.insert(material.name.clone(), self.model.materials.len());
                self.model.materials.push(material);
            }
        }
        self.has_library = true;
        Ok(())
    }

    fn use_material(&mut self, name: &str) -> anyhow::Result<()> {
        self.material = self.materials.get(name).copied();
        if self.material.is_none() {
            ensure!(
                !self.has_library,
                "there is no material {}: add newmtl to the MTL file, or use one of it",
                shown(name)
            );
            self.skipped[2] += 1;
        }
        Ok(())
    }

    fn finish(mut self) -> Model {
        let texts = [
            "lines and points that are skipped",
            "vertices with colours, which are skipped",
            "uses of materials without mtllib above them, which are skipped",
        ];
        for (count, text) in self.skipped.into_iter().zip(texts) {
            if count > 0 {
                self.model.notes.push(format!("{text}: {count}"));
            }
        }
        self.model
    }
}

/// The index that a corner names: from 1 on, or back from the last one with a minus.
fn index(word: &str, what: &str, count: usize) -> anyhow::Result<usize> {
    let number: i64 = word
        .parse()
        .ok()
        .with_context(|| format!("{} is no index of {what}: write a whole number", shown(word)))?;
    let index = match number {
        1.. => usize::try_from(number - 1).ok(),
        _ => usize::try_from(number.unsigned_abs())
            .ok()
            .and_then(|back| count.checked_sub(back)),
    };
    index.filter(|&index| index < count).with_context(|| match count {
        0 => format!(
            "{what} {number} is not there: no {what} stands above this line, move them up or leave the index out"
        ),
        _ => format!(
            "{what} {number} is not there, {count} stand above this line: write 1 to {count}, or -1 to -{count}"
        ),
    })
}
