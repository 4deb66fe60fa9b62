//! Segment clipping in eye space, against the six planes of what a camera sees, one after the other (Sutherland and Hodgman
//! 1974, for a segment). No vertex is brought to clip coordinates: the planes come to the vertices (Gribb and Hartmann 2001,
//! "Fast Extraction of Viewing Frustum Planes from the World-View-Projection Matrix").
//!
//! Guarantees: the parts of [`Segments::homogeneous_liang_barsky`](crate::clip::Segments::homogeneous_liang_barsky). What a
//! plane leaves is kept as exact fractions of the whole segment, and the next plane asks for its exact ends.
//!
//! Take it to see that clipping in homogeneous coordinates is clipping in space: each of the six distances is the same number.
//! For a single segment it is dearer, because the planes are set up; for many the planes of a model could be kept.

use crate::clip::{
    segment::segments::Segments,
    space::{clip_matrix::ClipMatrix, fraction::Fraction, space_segment::SpaceSegment},
};

impl Segments {
    /// The part of the segment between two vertices that a camera sees, by its six planes in the space of the vertices, which
    /// is eye space where the matrix is the projection alone; `None` where no point of it is visible. Right for vertices beside
    /// the eye and behind it.
    ///
    /// The part is that of [`homogeneous_liang_barsky`](Self::homogeneous_liang_barsky).
    ///
    /// Takes any vertices. Cost: six products a plane, and eight more to find the side of ends that were cut. Source:
    /// Sutherland and Hodgman 1974; planes as Gribb and Hartmann 2001.
    pub fn eye_space(from: [i16; 3], to: [i16; 3], matrix: &ClipMatrix) -> Option<SpaceSegment> {
        let mut part = SpaceSegment::whole(from, to);
        for plane in matrix.planes() {
            let (start, end) = (plane.distance(from), plane.distance(to));
            let is_outside = |cut: &Option<Fraction>, whole: i64| {
                cut.as_ref().map_or(whole < 0, |cut| cut.is_below_zero(start, end))
            };
            match (is_outside(&part.entry, start), is_outside(&part.exit, end)) {
                (false, false) => {}
                (true, true) => return None,
                (true, false) => part.entry = Some(Fraction::of_crossing(start, end)),
                (false, true) => part.exit = Some(Fraction::of_crossing(start, end)),
            }
        }
        Some(part)
    }
}
