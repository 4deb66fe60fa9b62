//! Which face is on the other side of each edge: the sides of the faces in buckets by the sum of their vertices.
//!
//! Two faces are neighbours that have the same two vertices one after the other, each in its own direction: then they belong to
//! one surface. An edge that only one face has bounds the surface, and in one that three or more have surfaces meet; both have
//! no neighbour.

use crate::mesh::side_buckets::{END, Side, SideBuckets, face_at, side_at, sides};

/// In a table of neighbours: there is none.
pub(super) const NO_NEIGHBOUR: u16 = u16::MAX;

/// The neighbours of faces across the edges from their first vertex to the second, from there to the third, and back.
pub(super) const fn find<const FACES: usize>(faces: &[[u16; 3]; FACES]) -> [[u16; 3]; FACES] {
    let mut buckets = SideBuckets::<FACES>::new();
    let mut face = 0;
    while face < FACES {
        let [ab, bc, ca] = sides(face_at(faces, face));
        buckets.enter(face, [hash(ab), hash(bc), hash(ca)]);
        face += 1;
    }
    let mut neighbours = [[NO_NEIGHBOUR; 3]; FACES];
    face = 0;
    while face < FACES {
        let [ab, bc, ca] = sides(face_at(faces, face));
        if let Some((_, [entry, ..])) = neighbours.split_at_mut_checked(face) {
            *entry = [
                across(faces, &buckets, ab),
                across(faces, &buckets, bc),
                across(faces, &buckets, ca),
            ];
        }
        face += 1;
    }
    neighbours
}

/// The hash of a side, in whichever direction: below 2^17.
const fn hash([from, to]: Side) -> u32 {
    from as u32 + to as u32
}

/// The face that has a side in the other direction, where it is the only one, and no other face has it in this direction.
const fn across<const FACES: usize>(faces: &[[u16; 3]; FACES], buckets: &SideBuckets<FACES>, [from, to]: Side) -> u16 {
    let (mut there, mut back, mut found) = (0u32, 0u32, NO_NEIGHBOUR);
    let mut side = buckets.first(hash([from, to]));
    while side != END {
        let [start, end] = side_at(faces, side);
        if start == from && end == to {
            there += 1;
        }
        if start == to && end == from {
            back += 1;
            found = (side / 4) as u16;
        }
        side = buckets.after(side);
    }
    if there == 1 && back == 1 { found } else { NO_NEIGHBOUR }
}
