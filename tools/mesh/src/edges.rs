//! The edges of a mesh, to draw it as lines: boundaries and creases, which are always drawn where a face beside them is seen,
//! and the others, which are drawn where they are a silhouette.
//!
//! Vertices with the same position are one here, whatever normals and texture coordinates they have.

use std::collections::HashMap;

use crate::vector::{Vector, cross, difference, dot, length};

/// Edges of a mesh.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Edges {
    /// Two vertices, then the faces on both sides: the same one twice at a boundary. Boundaries and creases come first, and in
    /// both parts the edges in the order of the faces.
    pub table: Vec<[u16; 4]>,
    /// How many of them are boundaries or creases.
    pub sharp: usize,
}

/// An edge by the positions of its ends, the lesser one first.
type Ends = [[i16; 3]; 2];

/// An edge that is being found: its vertices, as the first face has them, and the faces beside it.
struct Found {
    vertices: [u16; 2],
    faces: Vec<u16>,
}

/// The edges of a mesh. One is a crease where its faces turn by more than so many degrees from one to the other, or where more
/// than two meet, of which it keeps the first two. `None` for more faces than 16 bits can number.
pub fn edges(vertices: &[[i16; 3]], faces: &[[u16; 3]], crease: u8) -> Option<Edges> {
    let count = u16::try_from(faces.len()).ok()?;
    let mut numbers = HashMap::<Ends, usize>::new();
    let mut found = Vec::<Found>::new();
    for (number, &[a, b, c]) in (0..count).zip(faces) {
        for ends in [[a, b], [b, c], [c, a]] {
            let mut positions = ends.map(|vertex| vertices[usize::from(vertex)]);
            positions.sort_unstable();
            let index = *numbers.entry(positions).or_insert_with(|| {
                found.push(Found {
                    vertices: ends,
                    faces: Vec::new(),
                });
                found.len() - 1
            });
            found[index].faces.push(number);
        }
    }
    // Rounding moves a right angle by less.
    let least = f64::from(crease).to_radians().cos() - 1e-9;
    let normal = |face: u16| normal(vertices, faces[usize::from(face)]);
    let is_sharp = |found: &Found| match found.faces[..] {
        [one, other] => {
            let (one, other) = (normal(one), normal(other));
            dot(one, other) < least * length(one) * length(other)
        }
        _ => true,
    };
    let (sharp, smooth): (Vec<_>, Vec<_>) = found.iter().partition(|found| is_sharp(found));
    let entry = |found: &&Found| {
        let [one, other] = found.vertices;
        let first = found.faces[0];
        [one, other, first, found.faces.get(1).copied().unwrap_or(first)]
    };
    Some(Edges {
        table: sharp.iter().chain(&smooth).map(entry).collect(),
        sharp: sharp.len(),
    })
}

/// The normal of a face, as long as twice its area.
fn normal(vertices: &[[i16; 3]], face: [u16; 3]) -> Vector {
    let [a, b, c] = face.map(|vertex| vertices[usize::from(vertex)].map(f64::from));
    cross(difference(b, a), difference(c, a))
}
