//! The edges of a mesh, to draw it as lines: boundaries and creases, which are drawn where a face beside them is seen, and
//! smooth ones, which are drawn where they are a silhouette. They are those of `FaceSet::find_edges`, found by a hash map.
//!
//! Vertices with the same position are one here, whatever normals and texture coordinates they have.

use std::collections::HashMap;

/// What an edge of a mesh is, and the faces beside it: `zrow::scene::EdgeKind`.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub enum Beside {
    /// Only one face has the edge.
    Boundary(u16),
    /// The faces turn by more than the angle of a crease, or more than two meet; twice the same one where there are no other
    /// two.
    Crease([u16; 2]),
    /// The faces turn by less.
    Smooth([u16; 2]),
}

/// An edge of a mesh.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Edge {
    /// The vertices, as the first face has them.
    pub vertices: [u16; 2],
    /// What is beside it.
    pub beside: Beside,
}

/// An edge by the positions of its ends, the lesser one first.
type Ends = [[i16; 3]; 2];

/// An edge that is being found: its sides in the order of faces, each with its face.
type Found = Vec<([u16; 2], u16)>;

/// The edges of a mesh, in the order of the faces that have them: one for every two faces where more than two meet, and none
/// where two faces lie in one plane. One is a crease where its faces turn by more than so many degrees from one to the other.
/// `None` for more faces than 16 bits can number.
pub fn edges(vertices: &[[i16; 3]], faces: &[[u16; 3]], crease: u8) -> Option<Vec<Edge>> {
    let count = u16::try_from(faces.len()).ok()?;
    let mut numbers = HashMap::<Ends, usize>::new();
    let mut found = Vec::<Found>::new();
    for (number, &[a, b, c]) in (0..count).zip(faces) {
        if normal(vertices, [a, b, c]) == [0; 3] {
            continue;
        }
        for side in [[a, b], [b, c], [c, a]] {
            let mut positions = side.map(|vertex| vertices[usize::from(vertex)]);
            positions.sort_unstable();
            let index = *numbers.entry(positions).or_insert_with(|| {
                found.push(Vec::new());
                found.len() - 1
            });
            found[index].push((side, number));
        }
    }
    let cosine = cosine(crease);
    let normal = |face: u16| normal(vertices, faces[usize::from(face)]);
    // Which face comes first, so that the table is in the order of faces and of their sides.
    let mut edges: Vec<(usize, Edge)> = Vec::new();
    let order = |(side, face): ([u16; 2], u16)| {
        let [a, b, c] = faces[usize::from(face)];
        let of_face = [[a, b], [b, c], [c, a]].iter().position(|other| *other == side);
        3 * usize::from(face) + of_face.unwrap_or(0)
    };
    for sides in &found {
        for pair in sides.chunks(2) {
            let beside = match *pair {
                [(_, face)] if sides.len() == 1 => Beside::Boundary(face),
                [(_, face)] => Beside::Crease([face; 2]),
                [(_, one), (_, other)] if sides.len() == 2 => match turn(normal(one), normal(other), cosine) {
                    None => continue,
                    Some(true) => Beside::Crease([one, other]),
                    Some(false) => Beside::Smooth([one, other]),
                },
                [(_, one), (_, other)] => Beside::Crease([one, other]),
                _ => continue,
            };
            let (vertices, _) = pair[0];
            edges.push((order(pair[0]), Edge { vertices, beside }));
        }
    }
    edges.sort_by_key(|(order, _)| *order);
    Some(edges.into_iter().map(|(_, edge)| edge).collect())
}

/// The cosine of an angle in degrees, with 14 fractional bits.
pub fn cosine(degrees: u8) -> i16 {
    (f64::from(degrees).to_radians().cos() * 16_384.0).round() as i16
}

/// Whether faces turn by more than the angle with a cosine; `None` where they lie in one plane and are seen together.
///
/// Exact where faces are less than 2,896 units long and wide, as in models of the usual sizes; normals of greater ones are
/// rounded to 23 bits.
fn turn(one: [i128; 3], other: [i128; 3], cosine: i16) -> Option<bool> {
    if cross(one, other) == [0; 3] && dot(one, other) > 0 {
        return None;
    }
    let (one, other) = (rounded(one), rounded(other));
    let (turned, cosine) = (dot(one, other), i128::from(cosine));
    // Squares with their signs: below 2^48, so that products are below 2^124.
    Some(turned * turned.abs() * (1 << 28) < dot(one, one) * dot(other, other) * cosine * cosine.abs())
}

/// A normal, halved as often as it takes to have a square below 2^48.
fn rounded(mut normal: [i128; 3]) -> [i128; 3] {
    while dot(normal, normal) >= 1 << 48 {
        normal = normal.map(|part| part / 2);
    }
    normal
}

/// The normal of a face, as long as twice its area.
fn normal(vertices: &[[i16; 3]], face: [u16; 3]) -> [i128; 3] {
    let [a, b, c] = face.map(|vertex| vertices[usize::from(vertex)].map(i128::from));
    let way = |to: [i128; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
    cross(way(b), way(c))
}

fn cross([x, y, z]: [i128; 3], [u, v, w]: [i128; 3]) -> [i128; 3] {
    [y * w - z * v, z * u - x * w, x * v - y * u]
}

fn dot([x, y, z]: [i128; 3], [u, v, w]: [i128; 3]) -> i128 {
    x * u + y * v + z * w
}
