//! Cyrus and Beck's segment clipping in space (1978, "Generalized Two- and Three-Dimensional Clipping", Computers and Graphics
//! 3(1)): against any convex volume that is given by its planes.
//!
//! Along a segment the distance from a plane changes evenly. Where the start is outside of a plane and the end inside, the
//! segment enters there, and it leaves where it is the other way round. The last entry and the first exit are the ends of what
//! is inside.
//!
//! Guarantees: exactly what of the segment lies in the closed volume, touching a corner included. Clipping the result again
//! changes nothing; neither does the order of the planes. For the planes of a matrix it is the result of
//! [`Segments::homogeneous_liang_barsky`], which is its case of six planes in homogeneous space.

use crate::clip::{
    segment::segments::Segments,
    space::{clip_plane::ClipPlane, fraction::Fraction, space_segment::SpaceSegment},
};

impl Segments {
    /// The part of the segment between two vertices inside a closed convex volume, which planes in the space of the vertices
    /// bound; `None` where no point of it does. Without planes it is the whole segment.
    ///
    /// Takes any vertices. Cost: six products of 64 bits a plane, and four for each one that is crossed. Source: Cyrus and Beck
    /// 1978.
    ///
    /// ```
    /// use zrow::clip::{ClipPlane, Segments};
    ///
    /// // A corner: x + y + z <= 90, and nothing below 0.
    /// let faces = [
    ///     ClipPlane::through([90, 0, 0], [-1, -1, -1]),
    ///     ClipPlane::through([0, 0, 0], [1, 0, 0]),
    ///     ClipPlane::through([0, 0, 0], [0, 1, 0]),
    ///     ClipPlane::through([0, 0, 0], [0, 0, 1]),
    /// ];
    /// let part = Segments::cyrus_beck_in_space([-10, 20, 20], [100, 20, 20], &faces);
    /// assert_eq!(part.map(|part| part.vertices()), Some(([0, 20, 20], [50, 20, 20])));
    /// assert_eq!(part.and_then(|part| part.clip(&faces)), part);
    /// ```
    pub fn cyrus_beck_in_space(from: [i16; 3], to: [i16; 3], planes: &[ClipPlane]) -> Option<SpaceSegment> {
        SpaceSegment::whole(from, to).clip(planes)
    }
}

impl SpaceSegment {
    /// The part of it inside of another closed convex volume, given by its planes; `None` where no point of it is. Exact, so
    /// that volumes may be taken in any order.
    #[must_use]
    pub fn clip(mut self, planes: &[ClipPlane]) -> Option<Self> {
        for plane in planes {
            let (start, end) = (plane.distance(self.from), plane.distance(self.to));
            match (start < 0, end < 0) {
                (false, false) => {}
                (true, true) => return None,
                (true, false) => {
                    let cut = Fraction::of_crossing(start, end);
                    self.entry = self.entry.filter(|entry| entry.compare(&cut).is_ge()).or(Some(cut));
                }
                (false, true) => {
                    let cut = Fraction::of_crossing(start, end);
                    self.exit = self.exit.filter(|exit| exit.compare(&cut).is_le()).or(Some(cut));
                }
            }
        }
        match (&self.entry, &self.exit) {
            (Some(entry), Some(exit)) if exit.compare(entry).is_lt() => None,
            _ => Some(self),
        }
    }
}
