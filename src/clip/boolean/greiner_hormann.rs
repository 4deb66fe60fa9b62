//! Greiner and Hormann's polygon clipping (1998, "Efficient Clipping of Arbitrary Polygons", ACM Transactions on Graphics
//! 17(2), a linked-list form of Weiler and Atherton's of 1977), with its degenerate cases resolved by labels as Foster,
//! Hormann and Popa do (2019, "Clipping Simple Polygons with Degenerate Intersections", Computers & Graphics: X 2).
//!
//! Guarantees: intersection, union and difference of two polygons with any number of contours each, which have parts,
//! holes and islands by the even-odd rule. Contours may touch, share edges, cross and coincide, with each other and with
//! themselves; repeated corners, spikes and contours without area count for nothing. What meets what is decided by
//! exact orientation in 64 bits, before anything is rounded, and nothing is perturbed. So the number of parts and holes is that
//! of the exact result: parts are what hangs together by more than points, each with one outer contour. Only then a
//! crossing is rounded, once, to the nearest unit (ties to the larger coordinate): the same point whichever edge and end
//! it is computed from, and corners stay where they are.
//!
//! The area is that of the exact result but for this rounding: each crossing is off by half a unit at most on each axis,
//! which moves the area by less than `length / 2 + corners / 4` square units in all, `length` the sum of the sizes of
//! all edges of the result, on both axes. A part or hole thinner than a unit may so be left with no area, be turned
//! around, or meet itself or another one; it is handed over all the same.
//!
//! Cost: a comparison of extents for every two edges of both polygons, four products where these meet, two 64-bit
//! divisions for each coordinate of a crossing. Polygons whose extents are apart are told at once. RAM: 20 bytes a
//! vertex with [`Sub4`](crate::geometry::Sub4), 24 with [`Sub8`](crate::geometry::Sub8).
//!
//! Take it when either polygon is not convex, has holes, or is to be joined or subtracted. Its number of steps grows with
//! the square of the number of edges.

mod labels;
mod outlines;

use crate::{
    clip::boolean::{
        clipper::Clipper,
        contours::{Contour, contours},
        operation::Operation,
    },
    geometry::{InputError, SubPixel, SubPoint},
};

impl<S: SubPixel, const N: usize> Clipper<S, N> {
    /// Clips the subject by another polygon with Greiner and Hormann's algorithm: [`Operation::Intersection`] keeps what lies in
    /// that polygon, and [`Operation::Difference`] takes it away. What was clipped before is gone. The contours come in no
    /// order that means something; there are none where nothing is left.
    ///
    /// A contour is closed by itself and may run either way, touch, share edges with and cross others and itself; a crossing is
    /// rounded once, to the nearest unit.
    ///
    /// Cost: a comparison of extents for every two edges, four products where these meet, two 64-bit divisions for each
    /// coordinate of a crossing. Source: Greiner and Hormann 1998; degenerate cases: Foster, Hormann and Popa 2019.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`]; [`InputError::TooSmall`] with a number of vertices that would do.
    pub fn greiner_hormann<'c>(
        &'c mut self,
        subject: &[&[SubPoint<S>]],
        clip: &[&[SubPoint<S>]],
        operation: Operation,
    ) -> Result<impl Iterator<Item = Contour<'c, S>> + Clone + use<'c, S, N>, InputError> {
        let vertices = self.clip_by(subject, clip, operation, |vertices| {
            labels::label(vertices, operation);
            outlines::connect(vertices);
        })?;
        Ok(contours(vertices))
    }
}
