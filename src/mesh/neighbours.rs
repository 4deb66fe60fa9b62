//! Which face is on the other side of each edge: edges in buckets by the sum of their vertices.
//!
//! Two faces are neighbours that have the same two vertices one after the other, each in its own direction: then they belong to
//! one surface. An edge that only one face has bounds the surface, and in one that three or more have surfaces meet; both have
//! no neighbour.

use crate::mesh::element::{element, set_element};

/// In a table of neighbours: there is none.
pub(super) const NO_NEIGHBOUR: u16 = u16::MAX;

/// No edge: the end of a bucket.
const END: u32 = u32::MAX;

/// The neighbours of faces across the edges from their first vertex to the second, from there to the third, and back.
pub(super) const fn find<const FACES: usize>(faces: &[[u16; 3]; FACES]) -> [[u16; 3]; FACES] {
    let mut heads = [END; FACES];
    // The next edge of the bucket after each edge, three a face.
    let mut next = [[END; 3]; FACES];
    let mut face = 0;
    while face < FACES {
        let [ab, bc, ca] = edges(face_at(faces, face));
        let of_face = [
            enter(&mut heads, ab, edge_number(face, 0)),
            enter(&mut heads, bc, edge_number(face, 1)),
            enter(&mut heads, ca, edge_number(face, 2)),
        ];
        set_element(&mut next, face, of_face);
        face += 1;
    }
    let mut neighbours = [[NO_NEIGHBOUR; 3]; FACES];
    face = 0;
    while face < FACES {
        let [ab, bc, ca] = edges(face_at(faces, face));
        let of_face = [
            across(faces, &heads, &next, ab),
            across(faces, &heads, &next, bc),
            across(faces, &heads, &next, ca),
        ];
        set_element(&mut neighbours, face, of_face);
        face += 1;
    }
    neighbours
}

/// From which vertex an edge leads to which.
type Edge = [u16; 2];

const fn edges([a, b, c]: [u16; 3]) -> [Edge; 3] {
    [[a, b], [b, c], [c, a]]
}

const fn face_at(faces: &[[u16; 3]], face: usize) -> [u16; 3] {
    match element(faces, face) {
        Some(corners) => corners,
        None => [0; 3],
    }
}

const fn edge_number(face: usize, edge: u32) -> u32 {
    face as u32 * 4 + edge
}

/// The bucket of an edge, in whichever direction; there is at least one.
const fn bucket([from, to]: Edge, buckets: usize) -> usize {
    // Below 2^17.
    match (from as usize + to as usize).checked_rem(buckets) {
        Some(bucket) => bucket,
        None => 0,
    }
}

/// The first edge in the bucket of an edge, by its number, or [`END`].
const fn first(heads: &[u32], edge: Edge) -> u32 {
    match element(heads, bucket(edge, heads.len())) {
        Some(head) => head,
        None => END,
    }
}

/// Makes an edge the head of its bucket, and returns the previous head.
const fn enter(heads: &mut [u32], edge: Edge, number: u32) -> u32 {
    let before = first(heads, edge);
    set_element(heads, bucket(edge, heads.len()), number);
    before
}

/// The face that has an edge in the other direction, where it is the only one, and no other face has it in this direction;
/// none where that face has no number of 16 bits.
const fn across(faces: &[[u16; 3]], heads: &[u32], next: &[[u32; 3]], [from, to]: Edge) -> u16 {
    let (mut there, mut back, mut found) = (0u32, 0u32, NO_NEIGHBOUR);
    let mut number = first(heads, [from, to]);
    while number != END {
        let (face, edge) = ((number / 4) as usize, number % 4);
        let [ab, bc, ca] = edges(face_at(faces, face));
        let [after_ab, after_bc, after_ca] = match element(next, face) {
            Some(after) => after,
            None => [END; 3],
        };
        let ([start, end], after) = match edge {
            0 => (ab, after_ab),
            1 => (bc, after_bc),
            _ => (ca, after_ca),
        };
        if start == from && end == to {
            there += 1;
        }
        if start == to && end == from {
            back += 1;
            let has_number = face < NO_NEIGHBOUR as usize;
            found = if has_number { face as u16 } else { NO_NEIGHBOUR };
        }
        number = after;
    }
    if there == 1 && back == 1 { found } else { NO_NEIGHBOUR }
}
