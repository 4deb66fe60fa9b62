//! What a module holds, before it is written.

use crate::{
    edges::Edge,
    level::Level,
    octahedral,
    quantize::Up,
    texture::Texture,
    vector::{cross, difference},
};

/// How a model is converted.
#[derive(Debug, Copy, Clone)]
pub struct Options {
    /// What the greatest coordinate becomes.
    pub size: u16,
    /// Which axis of the file points up.
    pub up: Up,
    /// Whether faces have normals, and not vertices.
    pub flat: bool,
    /// How many coarser meshes there are, at most.
    pub levels: u8,
    /// Whether there is a table of edges, and by how many degrees faces turn at a crease at least.
    pub edges: Option<u8>,
}

/// A converted model.
#[derive(Debug, Clone, Default)]
pub struct Mesh {
    /// Positions in zrow's axes.
    pub vertices: Vec<[i16; 3]>,
    /// Octahedral normals of the vertices, or none.
    pub normals: Vec<[i8; 2]>,
    /// Texture coordinates of the vertices in 1/4096, or none.
    pub coordinates: Vec<[i16; 2]>,
    /// Three vertices each: cross(b - a, c - a) points outwards.
    pub faces: Vec<[u16; 3]>,
    /// A colour of 5, 6 and 5 bits for each face.
    pub colors: Vec<[u8; 3]>,
    /// The texture, if there is one.
    pub texture: Option<Texture>,
    /// Coarser meshes, each with about half of the faces of the one before.
    pub levels: Vec<Level>,
    /// Edges of the finest mesh.
    pub edges: Option<Vec<Edge>>,
    /// Triangles without an area after rounding.
    pub dropped: usize,
    /// The greatest distance by which a vertex moved when it was rounded.
    pub greatest_error: f64,
    /// The mean distance.
    pub mean_error: f64,
    /// What was skipped, or is not as it should be.
    pub notes: Vec<String>,
}

impl Mesh {
    /// Octahedral normals of faces, of the mesh or a level.
    pub fn face_normals<'a>(&'a self, faces: &'a [[u16; 3]]) -> impl ExactSizeIterator<Item = [i8; 2]> + 'a {
        faces.iter().map(|face| {
            let [a, b, c] = face.map(|index| self.vertices[usize::from(index)].map(f64::from));
            octahedral::encode(cross(difference(b, a), difference(c, a)))
        })
    }
}
