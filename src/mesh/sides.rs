//! The sides of the faces of a mesh in buckets: a hash table with chaining, so that the sides between the same two positions
//! are found without a look at all others.
//!
//! A side has a number: four times the index of its face, and 0 from the first corner to the second, 1 from there to the third,
//! 2 back to the first. There are as many buckets as faces, and the sides of a bucket have ascending numbers. All of a face
//! lies in one entry, so that the compiler, which counts its steps, takes it out of the table at once.

use crate::mesh::{
    convex::position,
    element::{element, set_element},
    face_normal::normal,
    neighbours::NO_NEIGHBOUR,
};

/// No side: the end of a bucket.
pub(super) const END: u32 = u32::MAX;

/// The positions of the ends of a side.
pub(super) type Ends = [[i16; 3]; 2];

/// A face: the positions of its corners, and for each of its sides the hash and the next side in the bucket.
#[derive(Copy, Clone)]
pub(super) struct FaceSides {
    pub(super) corners: [[i16; 3]; 3],
    hashes: [u32; 3],
    next: [u32; 3],
}

impl FaceSides {
    const NONE: Self = Self {
        corners: [[0; 3]; 3],
        hashes: [0; 3],
        next: [END; 3],
    };

    /// The positions of the ends of a side, by its number.
    pub(super) const fn ends(&self, side: u32) -> Ends {
        let [a, b, c] = self.corners;
        of_side([[a, b], [b, c], [c, a]], side)
    }

    /// The hash of a side, by its number.
    pub(super) const fn hash(&self, side: u32) -> u32 {
        of_side(self.hashes, side)
    }

    /// The side after another one in its bucket, or [`END`].
    pub(super) const fn after(&self, side: u32) -> u32 {
        of_side(self.next, side)
    }

    /// The normal of the face, as long as twice its area.
    pub(super) const fn normal(&self) -> [i64; 3] {
        normal(self.corners)
    }
}

/// The buckets of the sides of `FACES` faces.
pub(super) struct Sides<const FACES: usize> {
    heads: [u32; FACES],
    faces: [FaceSides; FACES],
}

impl<const FACES: usize> Sides<FACES> {
    /// Enters the sides of the faces that can be named, but for those that have no area.
    pub(super) const fn new(vertices: &[[i16; 3]], faces: &[[u16; 3]; FACES]) -> Self {
        let mut sides = Self {
            heads: [END; FACES],
            faces: [FaceSides::NONE; FACES],
        };
        // From the last one on, and so within a face, too: each side becomes the head of its bucket.
        let mut rest = named(faces);
        while let [others @ .., [a, b, c]] = rest {
            rest = others;
            let face = rest.len();
            let corners = [position(vertices, *a), position(vertices, *b), position(vertices, *c)];
            if !matches!(normal(corners), [0, 0, 0]) {
                sides.enter(face, corners);
            }
        }
        sides
    }

    const fn enter(&mut self, face: usize, [a, b, c]: [[i16; 3]; 3]) {
        let hashes = [hash([a, b]), hash([b, c]), hash([c, a])];
        let [ab, bc, ca] = hashes;
        let number = side_number(face, 0);
        let after_ca = self.make_head(ca, number + 2);
        let after_bc = self.make_head(bc, number + 1);
        let after_ab = self.make_head(ab, number);
        let entry = FaceSides {
            corners: [a, b, c],
            hashes,
            next: [after_ab, after_bc, after_ca],
        };
        set_element(&mut self.faces, face, entry);
    }

    /// The face that a side with a number has; one without an area where none was entered.
    pub(super) const fn face_of(&self, side: u32) -> FaceSides {
        match element(&self.faces, (side / 4) as usize) {
            Some(face) => face,
            None => FaceSides::NONE,
        }
    }

    /// The first side in the bucket of a hash, or [`END`].
    pub(super) const fn first(&self, hash: u32) -> u32 {
        match element(&self.heads, Self::bucket(hash)) {
            Some(head) => head,
            None => END,
        }
    }

    const fn bucket(hash: u32) -> usize {
        match (hash as usize).checked_rem(FACES) {
            Some(bucket) => bucket,
            None => 0,
        }
    }

    /// Makes a side the head of the bucket of its hash, and returns the previous head.
    const fn make_head(&mut self, hash: u32, side: u32) -> u32 {
        let before = self.first(hash);
        set_element(&mut self.heads, Self::bucket(hash), side);
        before
    }
}

/// The faces that an edge can name: in 16 bits, of which one number says that there is none.
pub(super) const fn named(faces: &[[u16; 3]]) -> &[[u16; 3]] {
    match faces.split_at_checked(NO_NEIGHBOUR as usize) {
        Some((named, _)) => named,
        None => faces,
    }
}

/// The number of a side, by the index of its face and its place there: 0, 1 or 2.
pub(super) const fn side_number(face: usize, side: u32) -> u32 {
    face as u32 * 4 + side
}

/// What the side with a number has, out of what the three sides of its face have.
pub(super) const fn of_side<T: Copy>([ab, bc, ca]: [T; 3], side: u32) -> T {
    match side % 4 {
        0 => ab,
        1 => bc,
        _ => ca,
    }
}

/// The hash of a side by its ends, in whichever direction.
const fn hash([[x, y, z], [u, v, w]]: Ends) -> u32 {
    // Below 2^28, whatever the signs are; then modulo a prime, so that coordinates on a grid use all buckets.
    let sum = (x as u16 as u32 + u as u16 as u32)
        + 263 * (y as u16 as u32 + v as u16 as u32)
        + 1_699 * (z as u16 as u32 + w as u16 as u32);
    (sum as u64 * 40_503 % 65_521) as u32
}
