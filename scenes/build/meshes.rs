//! The meshes of the standard scenes, computed in floating point and rounded once.

use std::{
    collections::{BTreeMap, btree_map::Entry},
    f64::consts::TAU,
};

/// Units of a rounded vertex for a length of 1.
const UNITS: f64 = 512.0;

type Vector = [f64; 3];

/// Triangles that share vertices; cross(b - a, c - a) points outwards.
pub struct Mesh {
    vertices: Vec<Vector>,
    pub faces: Vec<[u16; 3]>,
}

impl Mesh {
    /// The vertices in units of 1/512; a half goes away from zero.
    pub fn rounded_vertices(&self) -> Vec<[i16; 3]> {
        let round = |vertex: &Vector| vertex.map(|coordinate| (coordinate * UNITS).round() as i16);
        self.vertices.iter().map(round).collect()
    }

    /// How high the middle of each face is: -1 to 1 on the unit sphere.
    pub fn heights(&self) -> Vec<f64> {
        let y = |vertex: u16| normalized(self.vertices[usize::from(vertex)])[1];
        let height = |[a, b, c]: &[u16; 3]| (y(*a) + y(*b) + y(*c)) / 3.0;
        self.faces.iter().map(height).collect()
    }

    fn append(&mut self, other: Mesh) {
        let first = self.vertices.len() as u16;
        self.vertices.extend(other.vertices);
        self.faces
            .extend(other.faces.iter().map(|face| face.map(|vertex| vertex + first)));
    }

    fn add_quad(&mut self, [a, b, c, d]: [u16; 4]) {
        self.faces.extend([[a, b, c], [a, c, d]]);
    }
}

/// A torus about z and a cube within it; they interpenetrate.
pub fn torus_and_cube() -> Mesh {
    let mut mesh = torus(1.0, 0.45, 24, 12);
    mesh.append(cube(0.5));
    mesh
}

fn torus(radius: f64, tube: f64, around: u16, across: u16) -> Mesh {
    let mut mesh = Mesh {
        vertices: Vec::new(),
        faces: Vec::new(),
    };
    for i in 0..around {
        let (sin_a, cos_a) = (TAU * f64::from(i) / f64::from(around)).sin_cos();
        for j in 0..across {
            let (sin_b, cos_b) = (TAU * f64::from(j) / f64::from(across)).sin_cos();
            let distance = radius + tube * cos_b;
            mesh.vertices.push([distance * cos_a, distance * sin_a, tube * sin_b]);
            let at = |i: u16, j: u16| i % around * across + j % across;
            mesh.add_quad([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    mesh
}

/// A cube about the origin. Bits 0, 1 and 2 of a vertex's number are the signs of its x, y and z.
pub fn cube(half_size: f64) -> Mesh {
    let sign = |vertex: u8, bit: u8| if vertex >> bit & 1 == 1 { half_size } else { -half_size };
    let mut mesh = Mesh {
        vertices: (0..8).map(|k| [sign(k, 0), sign(k, 1), sign(k, 2)]).collect(),
        faces: Vec::new(),
    };
    for quad in [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ] {
        mesh.add_quad(quad);
    }
    mesh
}

/// An icosahedron whose faces are cut into four, twice, on a sphere of radius 1.4.
pub fn icosphere() -> Mesh {
    let mut mesh = icosahedron();
    for _ in 0..2 {
        mesh = subdivided(mesh);
    }
    for vertex in &mut mesh.vertices {
        *vertex = normalized(*vertex).map(|coordinate| coordinate * 1.4);
    }
    mesh
}

fn icosahedron() -> Mesh {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut vertices = Vec::new();
    for one in [-1.0, 1.0] {
        for golden in [-golden, golden] {
            vertices.extend([[0.0, one, golden], [one, golden, 0.0], [golden, 0.0, one]]);
        }
    }
    // Neighbours are 2 apart; every three neighbours are a face.
    let near = |a: u16, b: u16| {
        let edge = difference(vertices[usize::from(a)], vertices[usize::from(b)]);
        dot(edge, edge) < 4.5
    };
    let mut faces = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    faces.push(outwards(&vertices, [a, b, c]));
                }
            }
        }
    }
    Mesh { vertices, faces }
}

/// The face with its corners in the order that lets it look away from the origin.
fn outwards(vertices: &[Vector], [a, b, c]: [u16; 3]) -> [u16; 3] {
    let corner = |index: u16| vertices[usize::from(index)];
    let normal = cross(difference(corner(b), corner(a)), difference(corner(c), corner(a)));
    if dot(normal, corner(a)) < 0.0 {
        [a, c, b]
    } else {
        [a, b, c]
    }
}

fn subdivided(mesh: Mesh) -> Mesh {
    let Mesh { mut vertices, faces } = mesh;
    let mut middles = BTreeMap::new();
    let mut middle = |a: u16, b: u16| match middles.entry((a.min(b), a.max(b))) {
        Entry::Occupied(index) => *index.get(),
        Entry::Vacant(entry) => {
            let (a, b) = (vertices[usize::from(a)], vertices[usize::from(b)]);
            vertices.push([0, 1, 2].map(|axis| (a[axis] + b[axis]) / 2.0));
            *entry.insert(vertices.len() as u16 - 1)
        }
    };
    let mut smaller = Vec::new();
    for [a, b, c] in faces {
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        smaller.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    Mesh {
        vertices,
        faces: smaller,
    }
}

fn difference(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn normalized(vector: Vector) -> Vector {
    let length = dot(vector, vector).sqrt();
    vector.map(|coordinate| coordinate / length)
}
