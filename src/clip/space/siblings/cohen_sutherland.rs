//! Cohen and Sutherland's segment clipping in homogeneous space: outcodes of six bits (Newman and Sproull 1979; Blinn and
//! Newell 1978, "Clipping Using Homogeneous Coordinates", SIGGRAPH). An end that is outside moves to the plane of one of its
//! bits, until both ends are inside, or share a bit.
//!
//! ```text
//!     bit 5   4     3    2       1      0
//!         far near  top  bottom  right  left       from 000001 *---+=======* to 000000
//!                                                              the left plane
//! ```
//!
//! Guarantees: the parts of [`Segments::homogeneous_liang_barsky`](crate::clip::Segments::homogeneous_liang_barsky). An end
//! that has moved is kept as an exact fraction of the whole segment, and its outcode is that of this exact point.
//!
//! Take it where most segments are inside or on one side of a plane: then it compares bits only. An end that is outside of
//! several planes may move more than once.

use crate::clip::{
    segment::segments::Segments,
    space::{clip_matrix::ClipMatrix, clip_point::ClipPoint, fraction::Fraction, space_segment::SpaceSegment},
};

impl Segments {
    /// The part of the segment between two vertices that a camera sees, by outcodes of six bits in homogeneous clip
    /// coordinates; `None` where no point of it is visible. Right for vertices beside the eye and behind it.
    ///
    /// The part is that of [`homogeneous_liang_barsky`](Self::homogeneous_liang_barsky).
    ///
    /// Takes any vertices. Cost: two products with the matrix; for each move of an end up to 24 products for its new outcode.
    /// Source: Cohen and Sutherland 1967; Blinn and Newell 1978.
    pub fn homogeneous_cohen_sutherland(from: [i16; 3], to: [i16; 3], matrix: &ClipMatrix) -> Option<SpaceSegment> {
        let ends = Ends {
            from: distances(matrix.apply(from)),
            to: distances(matrix.apply(to)),
        };
        let mut part = SpaceSegment::whole(from, to);
        let (mut from_code, mut to_code) = (outcode(ends.from), outcode(ends.to));
        while from_code | to_code != 0 {
            if from_code & to_code != 0 {
                return None;
            }
            // Not 0, so that a bit is set.
            let moves_from = from_code != 0;
            let plane = if moves_from { from_code } else { to_code }.trailing_zeros() as usize;
            let cut = ends.cut(plane)?;
            if moves_from {
                part.entry = Some(cut);
                from_code = ends.outcode_at(&cut);
            } else {
                part.exit = Some(cut);
                to_code = ends.outcode_at(&cut);
            }
        }
        Some(part)
    }
}

/// How far inside of the six planes the two ends of the whole segment are.
struct Ends {
    from: [i64; 6],
    to: [i64; 6],
}

impl Ends {
    /// Where the segment crosses a plane. Its ends are on two sides of it: an end beyond a plane moves, and the other is not
    /// beyond that plane.
    fn cut(&self, plane: usize) -> Option<Fraction> {
        Some(Fraction::of_crossing(*self.from.get(plane)?, *self.to.get(plane)?))
    }

    /// The outcode of a point between the ends.
    fn outcode_at(&self, cut: &Fraction) -> u8 {
        let planes = self.from.into_iter().zip(self.to).enumerate();
        planes.fold(0, |code, (plane, (from, to))| {
            code | u8::from(cut.is_below_zero(from, to)) << plane
        })
    }
}

/// One bit for each plane that a point is beyond, the first one's lowest.
fn outcode(distances: [i64; 6]) -> u8 {
    let planes = distances.iter().rev();
    planes.fold(0, |code, &distance| code << 1 | u8::from(distance < 0))
}

/// How far inside of the six planes a point is: left, right, bottom, top, near, far. Of coordinates that a matrix made, below
/// 2^60.
fn distances(ClipPoint { x, y, z, w }: ClipPoint) -> [i64; 6] {
    [w + x, w - x, w + y, w - y, z, w - z]
}
