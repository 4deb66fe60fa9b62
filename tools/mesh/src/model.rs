//! A model as it stands in its file: in the file's axes and units, with polygons of any number of corners.

use std::collections::HashSet;

use crate::vector::Vector;

/// What a corner of a face names.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Corner {
    /// Index of the position.
    pub position: usize,
    /// Index of the texture coordinates.
    pub coordinates: Option<usize>,
    /// Index of the normal.
    pub normal: Option<usize>,
}

/// A polygon.
#[derive(Debug, Clone)]
pub struct Face {
    /// Its corners, a range of those of the model: counter-clockwise as seen from outside.
    pub corners: std::ops::Range<usize>,
    /// Index of the material.
    pub material: Option<usize>,
    /// The line of the file, or of a binary file the number of the face, from 1 on.
    pub line: usize,
}

/// The picture of a material.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Its file, as seen from the model's folder.
    pub path: String,
    /// File and line that name it.
    pub named_at: String,
}

/// What the faces of a material look like.
#[derive(Debug, Clone)]
pub struct Material {
    /// What `usemtl` calls it.
    pub name: String,
    /// Red, green and blue from 0 to 1: `Kd`.
    pub color: [f64; 3],
    /// The texture: `map_Kd`.
    pub picture: Option<Picture>,
}

/// A model.
#[derive(Debug, Clone, Default)]
pub struct Model {
    /// The name of its file, without folders.
    pub file: String,
    /// Whether faces are counted, because the file has no lines.
    pub is_binary: bool,
    /// Positions of vertices.
    pub positions: Vec<Vector>,
    /// Texture coordinates: u to the right, v up.
    pub coordinates: Vec<[f64; 2]>,
    /// Normals of any length.
    pub normals: Vec<Vector>,
    /// The corners of all faces.
    pub corners: Vec<Corner>,
    /// The faces.
    pub faces: Vec<Face>,
    /// The materials.
    pub materials: Vec<Material>,
    /// What was skipped in the file.
    pub notes: Vec<String>,
}

impl Model {
    /// The corners of a face.
    pub fn corners_of(&self, face: &Face) -> &[Corner] {
        &self.corners[face.corners.clone()]
    }

    /// Where a face stands, for messages.
    pub fn place(&self, face: &Face) -> String {
        let unit = if self.is_binary { "facet" } else { "line" };
        format!("{} {unit} {}", self.file, face.line)
    }

    /// The pictures of the materials that faces have, each file once.
    pub fn pictures(&self) -> Vec<&Picture> {
        let (mut seen, mut pictures) = (HashSet::new(), Vec::new());
        let used: HashSet<usize> = self.faces.iter().filter_map(|face| face.material).collect();
        for (index, material) in self.materials.iter().enumerate() {
            if let Some(picture) = &material.picture
                && used.contains(&index)
                && seen.insert(&picture.path)
            {
                pictures.push(picture);
            }
        }
        pictures
    }
}
