//! The edges of a mesh, each with its kind: sides of faces in buckets by where their ends are.
//!
//! Sides are the same edge that lie between the same two positions, in whichever direction and whatever the numbers of the
//! vertices are: where a texture has a seam, two vertices have one position. The first side of an edge, in the order of faces,
//! looks the others up. An edge between two faces in one plane, seen from the same side, is none.

use fixed::types::I2F14;

use crate::mesh::{
    Edge,
    element::set_element,
    face_normal::cosine_is_below,
    sides::{END, Ends, FaceSides, Sides, named, of_side, side_number},
};

/// The cosine of no angle, with 14 fractional bits.
const ONE: i16 = 1 << 14;

/// The edges of faces in the order of faces, as many as there is room for, and how many there are.
pub(super) const fn find<const FACES: usize, const EDGES: usize>(
    vertices: &[[i16; 3]],
    faces: &[[u16; 3]; FACES],
    cosine: I2F14,
) -> ([Edge; EDGES], usize) {
    let sides = Sides::new(vertices, faces);
    let (mut edges, mut count) = ([Edge::NONE; EDGES], 0);
    let (mut face, mut rest) = (0, named(faces));
    while let [[a, b, c], others @ ..] = rest {
        let number = side_number(face, 0);
        let (of_face, mut side) = (sides.face_of(number), 0);
        let normal = of_face.normal();
        while side < 3 && !matches!(normal, [0, 0, 0]) {
            if let Some(beside) = sides.beside(&of_face, number + side) {
                let ends = of_side([[*a, *b], [*b, *c], [*c, *a]], side);
                if let Some(edge) = beside.edge(ends, face as u16, normal, cosine) {
                    set_element(&mut edges, count, edge);
                    count += 1;
                }
            }
            side += 1;
        }
        face += 1;
        rest = others;
    }
    (edges, count)
}

/// The other faces that have an edge, as seen from the first side of a face that lies in it.
struct Beside {
    /// The number of the mesh's faces that share the edge, with the face whose edge it is asked about.
    faces: u32,
    /// The next side of a face that lies in the edge, by its number, and the sides of that face; `None` where there is none.
    following: Option<(u32, FaceSides)>,
}

impl Beside {
    /// The edge of a side with its vertices, its face and the normal of that; none between faces in one plane.
    const fn edge(&self, side: [u16; 2], face: u16, normal: [i64; 3], cosine: I2F14) -> Option<Edge> {
        let Some((following, other)) = self.following else {
            return Some(if self.faces == 1 {
                Edge::boundary(side, face)
            } else {
                Edge::crease(side, [face; 2])
            });
        };
        let faces = [face, (following / 4) as u16];
        if self.faces > 2 {
            return Some(Edge::crease(side, faces));
        }
        let other = other.normal();
        if !cosine_is_below(normal, other, ONE) {
            None
        } else if cosine_is_below(normal, other, cosine.to_bits()) {
            Some(Edge::crease(side, faces))
        } else {
            Some(Edge::smooth(side, faces))
        }
    }
}

impl<const FACES: usize> Sides<FACES> {
    /// The other faces that have the edge in which a side of a face lies; `None` where a side before it stands for the edge. An
    /// edge that more than two faces have is there once for every two of them, for which the first of both stands.
    const fn beside(&self, face: &FaceSides, side: u32) -> Option<Beside> {
        let (ends, hash) = (face.ends(side), face.hash(side));
        let (mut before, mut after, mut following) = (0u32, 0u32, None);
        let mut other = self.first(hash);
        while other != END {
            let of_other = self.face_of(other);
            if other == side {
                if before % 2 != 0 {
                    return None;
                }
            } else if of_other.hash(other) == hash && are_same(ends, of_other.ends(other)) {
                if other < side {
                    before += 1;
                } else {
                    if after == 0 {
                        following = Some((other, of_other));
                    }
                    after += 1;
                }
            }
            other = of_other.after(other);
        }
        let faces = before + 1 + after;
        Some(Beside { faces, following })
    }
}

/// Whether two sides have the same ends, in whichever direction.
const fn are_same([a, b]: Ends, [c, d]: Ends) -> bool {
    is_same(a, c) && is_same(b, d) || is_same(a, d) && is_same(b, c)
}

const fn is_same([x, y, z]: [i16; 3], [u, v, w]: [i16; 3]) -> bool {
    x == u && y == v && z == w
}
