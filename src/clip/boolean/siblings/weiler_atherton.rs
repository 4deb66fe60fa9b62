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
//! Guarantees: those of [`greiner_hormann`](crate::clip::boolean::greiner_hormann), with the same contours for any input: shared
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

use heapless::VecView;

use crate::{
    clip::boolean::{boolean_method::BooleanMethod, operation::Operation, vertices::Vertex},
    geometry::SubPixel,
};

/// Weiler and Atherton's algorithm, as the method of a [`Clipper`](crate::clip::Clipper).
///
/// The contours are those of [`GreinerHormann`](crate::clip::GreinerHormann). Cost: contours are oriented first, by
/// the winding number of a point of each; otherwise like those. Source: Weiler and Atherton 1977.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WeilerAtherton;

impl BooleanMethod for WeilerAtherton {
    fn link<S: SubPixel>(vertices: &mut VecView<Vertex<S>>, operation: Operation) {
        orientation::orient(vertices);
        intersections::classify(vertices, operation);
        traversal::traverse(vertices);
    }
}
