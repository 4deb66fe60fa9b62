//! The edges of a mesh, each with its kind: sides of faces in buckets by where their ends are.
//!
//! Sides are the same edge that lie between the same two positions, in whichever direction and whatever the numbers of the
//! vertices are: where a texture has a seam, two vertices have one position. The first side of an edge, in the order of faces,
//! looks the others up. An edge between two faces in one plane, seen from the same side, is none.

use fixed::types::I2F14;

use crate::mesh::{
    Edge,
    face_normal::{cosine_is_below, normal},
    neighbours::NO_NEIGHBOUR,
    side_buckets::{END, Side, SideBuckets, face_at, side_at, side_number, sides},
};

/// The cosine of no angle, with 14 fractional bits.
const ONE: i16 = 1 << 14;

/// The edges of faces in the order of faces, as many as there is room for, and how many there are.
pub(super) const fn find<const FACES: usize, const EDGES: usize>(
    vertices: &[[i16; 3]],
    faces: &[[u16; 3]; FACES],
    cosine: I2F14,
) -> ([Edge; EDGES], usize) {
    let buckets = enter_sides(vertices, faces);
    let (mut edges, mut count) = ([Edge::NONE; EDGES], 0);
    let mut face = 0;
    while face < faces_with_number(FACES) {
        let mut side = 0;
        while side < 3 {
            if let Some(edge) = edge_of(vertices, faces, &buckets, side_number(face, side), cosine) {
                if let Some((_, [slot, ..])) = edges.split_at_mut_checked(count) {
                    *slot = edge;
                }
                count += 1;
            }
            side += 1;
        }
        face += 1;
    }
    (edges, count)
}

/// Of how many faces an edge can name each: one number says that there is none.
const fn faces_with_number(faces: usize) -> usize {
    if faces < NO_NEIGHBOUR as usize {
        faces
    } else {
        NO_NEIGHBOUR as usize
    }
}

/// The sides of all faces that have an area.
const fn enter_sides<const FACES: usize>(vertices: &[[i16; 3]], faces: &[[u16; 3]; FACES]) -> SideBuckets<FACES> {
    let mut buckets = SideBuckets::<FACES>::new();
    let mut face = faces_with_number(FACES);
    while face > 0 {
        face -= 1;
        if has_area(vertices, faces, face) {
            let [ab, bc, ca] = sides(face_at(faces, face));
            buckets.enter(
                face,
                [
                    hash(ends(vertices, ab)),
                    hash(ends(vertices, bc)),
                    hash(ends(vertices, ca)),
                ],
            );
        }
    }
    buckets
}

/// The edge of a side, if it is the first side of one. An edge that more than two faces have is there once for every two of
/// them.
const fn edge_of<const FACES: usize>(
    vertices: &[[i16; 3]],
    faces: &[[u16; 3]; FACES],
    buckets: &SideBuckets<FACES>,
    side: u32,
    cosine: I2F14,
) -> Option<Edge> {
    let face = (side / 4) as usize;
    if !has_area(vertices, faces, face) {
        return None;
    }
    let of_side = ends(vertices, side_at(faces, side));
    // How many faces have the edge, how many of them come before this one, and which side is the next one.
    let (mut count, mut before, mut following) = (0u32, 0u32, END);
    let mut other = buckets.first(hash(of_side));
    while other != END {
        if are_same(of_side, ends(vertices, side_at(faces, other))) {
            count += 1;
            if other < side {
                before += 1;
            } else if other > side && following == END {
                following = other;
            }
        }
        other = buckets.after(other);
    }
    if before % 2 != 0 {
        return None;
    }
    let side = side_at(faces, side);
    let beside = [face as u16, (following / 4) as u16];
    if following == END {
        let [face, _] = beside;
        return Some(if count == 1 {
            Edge::boundary(side, face)
        } else {
            Edge::crease(side, [face; 2])
        });
    }
    let (one, other) = (
        normal_of(vertices, faces, face),
        normal_of(vertices, faces, (following / 4) as usize),
    );
    if count > 2 {
        Some(Edge::crease(side, beside))
    } else if !cosine_is_below(one, other, ONE) {
        None
    } else if cosine_is_below(one, other, cosine.to_bits()) {
        Some(Edge::crease(side, beside))
    } else {
        Some(Edge::smooth(side, beside))
    }
}

const fn normal_of(vertices: &[[i16; 3]], faces: &[[u16; 3]], face: usize) -> [i64; 3] {
    let [a, b, c] = face_at(faces, face);
    normal([position(vertices, a), position(vertices, b), position(vertices, c)])
}

const fn has_area(vertices: &[[i16; 3]], faces: &[[u16; 3]], face: usize) -> bool {
    !matches!(normal_of(vertices, faces, face), [0, 0, 0])
}

/// The position of a vertex; that of one that is not there is the origin.
const fn position(vertices: &[[i16; 3]], vertex: u16) -> [i16; 3] {
    match vertices.split_at_checked(vertex as usize) {
        Some((_, [position, ..])) => *position,
        _ => [0; 3],
    }
}

/// The positions of the ends of a side.
const fn ends(vertices: &[[i16; 3]], [from, to]: Side) -> [[i16; 3]; 2] {
    [position(vertices, from), position(vertices, to)]
}

/// Whether two sides have the same ends, in whichever direction.
const fn are_same([a, b]: [[i16; 3]; 2], [c, d]: [[i16; 3]; 2]) -> bool {
    is_same(a, c) && is_same(b, d) || is_same(a, d) && is_same(b, c)
}

const fn is_same([x, y, z]: [i16; 3], [u, v, w]: [i16; 3]) -> bool {
    x == u && y == v && z == w
}

/// The hash of a side by its ends, in whichever direction.
const fn hash([[x, y, z], [u, v, w]]: [[i16; 3]; 2]) -> u32 {
    // Below 2^28, whatever the signs are; then modulo a prime, so that coordinates on a grid use all buckets.
    let sum = (x as u16 as u32 + u as u16 as u32)
        + 263 * (y as u16 as u32 + v as u16 as u32)
        + 1_699 * (z as u16 as u32 + w as u16 as u32);
    (sum as u64 * 40_503 % 65_521) as u32
}
