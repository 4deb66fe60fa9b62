//! The sides of the faces of a mesh in buckets: a hash table with chaining, so that the sides between the same two vertices are
//! found without a look at all others.
//!
//! A side has a number: four times the index of its face, and 0 from the first vertex to the second, 1 from there to the third, 2
//! back to the first. There are as many buckets as faces.

/// No side: the end of a bucket.
pub(super) const END: u32 = u32::MAX;

/// From which vertex a side of a face leads to which.
pub(super) type Side = [u16; 2];

/// The buckets of the sides of `FACES` faces.
pub(super) struct SideBuckets<const FACES: usize> {
    heads: [u32; FACES],
    /// The next side of the bucket after each side, three a face.
    next: [[u32; 3]; FACES],
}

impl<const FACES: usize> SideBuckets<FACES> {
    pub(super) const fn new() -> Self {
        Self {
            heads: [END; FACES],
            next: [[END; 3]; FACES],
        }
    }

    /// Enters the three sides of a face, each under its hash. Where faces are entered from the last one on, the sides of a
    /// bucket have ascending numbers.
    pub(super) const fn enter(&mut self, face: usize, [ab, bc, ca]: [u32; 3]) {
        // In this order, so that the numbers ascend within the face, too.
        let after_ca = self.make_head(ca, side_number(face, 2));
        let after_bc = self.make_head(bc, side_number(face, 1));
        let after_ab = self.make_head(ab, side_number(face, 0));
        if let Some((_, [entry, ..])) = self.next.split_at_mut_checked(face) {
            *entry = [after_ab, after_bc, after_ca];
        }
    }

    /// The first side in the bucket of a hash, or [`END`].
    pub(super) const fn first(&self, hash: u32) -> u32 {
        match self.heads.split_at_checked(Self::bucket(hash)) {
            Some((_, [head, ..])) => *head,
            _ => END,
        }
    }

    /// The side after another one in its bucket, or [`END`].
    pub(super) const fn after(&self, side: u32) -> u32 {
        match self.next.split_at_checked((side / 4) as usize) {
            Some((_, [after, ..])) => of_side(*after, side),
            _ => END,
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
        match self.heads.split_at_mut_checked(Self::bucket(hash)) {
            Some((_, [head, ..])) => {
                let before = *head;
                *head = side;
                before
            }
            _ => END,
        }
    }
}

/// The number of a side of a face: 0, 1 or 2.
pub(super) const fn side_number(face: usize, side: u32) -> u32 {
    face as u32 * 4 + side
}

/// The vertices of a face; those of a face that is not there are all the first one.
pub(super) const fn face_at(faces: &[[u16; 3]], face: usize) -> [u16; 3] {
    match faces.split_at_checked(face) {
        Some((_, [corners, ..])) => *corners,
        _ => [0; 3],
    }
}

/// The sides of a face.
pub(super) const fn sides([a, b, c]: [u16; 3]) -> [Side; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The vertices of the side with a number.
pub(super) const fn side_at(faces: &[[u16; 3]], side: u32) -> Side {
    of_side(sides(face_at(faces, (side / 4) as usize)), side)
}

/// What the side with a number has, out of what the three sides of its face have.
const fn of_side<T: Copy>([ab, bc, ca]: [T; 3], side: u32) -> T {
    match side % 4 {
        0 => ab,
        1 => bc,
        _ => ca,
    }
}
