//! Weiler and Atherton's polygon clipping (1977, "Hidden Surface Removal Using Polygon Area Sorting", SIGGRAPH '77): two
//! rings of vertices, with the intersections of both in both; walks that follow one polygon up to an intersection, and then
//! the other one.
//!
//! ```text
//!   +-----------+ subject
//!   |           |             An intersection, both polygons clockwise: from 1, where the
//!   |     +-----1------+      subject enters the clip polygon, down and left to 2, where it
//!   |     | / / |      |      leaves; over to the clip polygon, up and right to 1, where the
//!   +-----2-----+      |      subject enters: the contour is closed.
//!         |            |
//!         +------------+ clip
//! ```
//!
//! 1. Every point where edges meet becomes a vertex on both of them.
//! 2. Every contour gets a direction, its polygon on the positive side.
//! 3. Around each intersection, the directions of both boundaries tell whether the fragment of a contour that begins there is
//!    inside of the other polygon, outside of it, or on its boundary. An intersection by which fragments come to bound the
//!    result is an entering one. A contour that meets no other one is inside or outside as a whole; a ray tells.
//! 4. Walks begin at the entering intersections of the subject and go over to the other polygon where a contour ceases to
//!    bound the result. What no walk comes by are contours of one polygon alone.
//!
//! For a union the fragments outside are followed, and for a difference the clip polygon's inside, backwards.
//!
//! Guarantees: those of [`Clipper::greiner_hormann`], with the same contours for any input: shared
//! edges, touching and crossing contours of one polygon, coincident polygons, holes and contours without area included, which
//! the paper leaves out. Both compute vertices in the same way, exactly, and round crossings last.
//!
//! Cost: that of Greiner and Hormann's for the vertices, which grows with the square of the number of edges; then, at each
//! intersection, two orientations for each end that is there in two phases more. RAM: as much a vertex.
//!
//! Take it to see what a boolean operation does at an intersection without what came before it; where both polygons are known
//! to be simple and to run the right way round, its second phase would fall away.

mod intersections;
mod orientation;
mod traversal;

use crate::{
    clip::boolean::{
        clipper::Clipper,
        contours::{Contour, contours},
        operation::Operation,
    },
    geometry::{InputError, SubPixel, SubPoint},
};

impl<S: SubPixel, const N: usize> Clipper<S, N> {
    /// Clips the subject by another polygon with Weiler and Atherton's algorithm: [`Operation::Intersection`] keeps what lies in
    /// that polygon, and [`Operation::Difference`] takes it away. What was clipped before is gone. The contours come in no
    /// order that means something; there are none where nothing is left.
    ///
    /// The contours are those of [`greiner_hormann`](Self::greiner_hormann), for any input.
    ///
    /// Cost: contours are oriented first, by the winding number of a point of each; otherwise that of
    /// [`greiner_hormann`](Self::greiner_hormann). Source: Weiler and Atherton 1977.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`]; [`InputError::TooSmall`] with a number of vertices that would do.
    pub fn weiler_atherton<'c>(
        &'c mut self,
        subject: &[&[SubPoint<S>]],
        clip: &[&[SubPoint<S>]],
        operation: Operation,
    ) -> Result<impl Iterator<Item = Contour<'c, S>> + Clone + use<'c, S, N>, InputError> {
        let vertices = self.clip_by(subject, clip, operation, |vertices| {
            orientation::orient(vertices);
            intersections::classify(vertices, operation);
            traversal::traverse(vertices);
        })?;
        Ok(contours(vertices))
    }
}
