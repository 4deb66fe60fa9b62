//! The meshes of the standard scenes, computed in `f64` and rounded half away from zero; 1.0 is 512 units.

use std::f64::consts::TAU;

use zrow::scene::FaceSet;

#[derive(Debug, Clone)]
pub struct Mesh {
    pub vertices: Vec<[i16; 3]>,
    pub faces: Vec<[u16; 3]>,
}

impl Mesh {
    pub fn new(vertices: Vec<[i16; 3]>, faces: Vec<[u16; 3]>) -> Self {
        Self { vertices, faces }
    }

    pub fn face_set(&self) -> FaceSet<'_> {
        FaceSet::new(&self.vertices, &self.faces).unwrap()
    }

    /// The mesh with each face seen from both sides.
    pub fn two_sided(mut self) -> Self {
        let behind: Vec<_> = self.faces.iter().map(|&[a, b, c]| [a, c, b]).collect();
        self.faces.extend(behind);
        self
    }
}

fn vertex(point: [f64; 3]) -> [i16; 3] {
    point.map(|coordinate| (coordinate * 512.0).round() as i16)
}

pub fn torus() -> Mesh {
    const AROUND: u16 = 24;
    const TUBE: u16 = 12;
    let mut vertices = Vec::new();
    let mut faces = Vec::new();
    for i in 0..AROUND {
        for j in 0..TUBE {
            let a = TAU * f64::from(i) / f64::from(AROUND);
            let b = TAU * f64::from(j) / f64::from(TUBE);
            let radius = 1.0 + 0.45 * b.cos();
            vertices.push(vertex([radius * a.cos(), radius * a.sin(), 0.45 * b.sin()]));
            let index = |i: u16, j: u16| i % AROUND * TUBE + j % TUBE;
            let [p00, p10, p11, p01] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            faces.push([p00, p10, p11]);
            faces.push([p00, p11, p01]);
        }
    }
    Mesh { vertices, faces }
}

pub fn cube(half: f64) -> Mesh {
    let vertices = (0..8)
        .map(|k| vertex([0, 1, 2].map(|bit| if k >> bit & 1 == 1 { half } else { -half })))
        .collect();
    let quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let faces = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Mesh { vertices, faces }
}

/// An icosahedron, each face cut into four twice.
pub fn icosphere(radius: f64) -> Mesh {
    let g = (1.0 + 5.0f64.sqrt()) / 2.0;
    let mut points: Vec<[f64; 3]> = vec![
        [-1.0, g, 0.0],
        [1.0, g, 0.0],
        [-1.0, -g, 0.0],
        [1.0, -g, 0.0],
        [0.0, -1.0, g],
        [0.0, 1.0, g],
        [0.0, -1.0, -g],
        [0.0, 1.0, -g],
        [g, 0.0, -1.0],
        [g, 0.0, 1.0],
        [-g, 0.0, -1.0],
        [-g, 0.0, 1.0],
    ];
    let mut faces: Vec<[u16; 3]> = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    for _ in 0..2 {
        let mut middles = std::collections::HashMap::new();
        let mut middle = |a: u16, b: u16| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let [p, q] = [points[usize::from(a)], points[usize::from(b)]];
                points.push([(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0, (p[2] + q[2]) / 2.0]);
                (points.len() - 1) as u16
            })
        };
        faces = faces
            .iter()
            .flat_map(|&[a, b, c]| {
                let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    let vertices = points
        .iter()
        .map(|point| {
            let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
            vertex(point.map(|x| x / length * radius))
        })
        .collect();
    Mesh { vertices, faces }
}

/// The meshes of the three standard scenes.
pub fn standard_scenes() -> [Vec<Mesh>; 3] {
    [vec![torus(), cube(0.5)], vec![icosphere(1.4)], vec![cube(1.0)]]
}
