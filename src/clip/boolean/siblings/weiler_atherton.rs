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
//! 1. Every place where edges meet becomes a vertex on both of them.
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

pub use crate::clip::boolean::{
    clip_error::ClipError,
    contours::{Clipped, Contour},
    operation::Operation,
};
use crate::{
    clip::boolean::{
        clipper::{self, BooleanMethod},
        vertices::Vertex,
    },
    geometry::SubPixel,
};

/// Clips polygons by Weiler and Atherton's algorithm, and keeps the result.
///
/// `N` is the number of vertices that it has room for, of which 65,535 are used at most: the corners of both polygons, two for
/// every crossing of two edges, and one for every corner that lies inside an edge.
///
/// ```
/// use zrow::clip::boolean::weiler_atherton::{Clipper, Operation};
/// use zrow::geometry::{Sub8, SubPoint};
///
/// let corner = |x: i32, y: i32| SubPoint::<Sub8>::from_units(x << 8, y << 8);
/// let square = [corner(0, 0)?, corner(8, 0)?, corner(8, 8)?, corner(0, 8)?];
/// // Its upper side lies on the square's.
/// let slot = [corner(3, 0)?, corner(5, 0)?, corner(5, 4)?, corner(3, 4)?];
///
/// let mut clipper = Clipper::<Sub8, 16>::new();
/// let result = clipper.clip(&[&square], &[&slot], Operation::Difference)?;
/// let contours: Vec<_> = result.contours().collect();
/// assert_eq!(contours.len(), 1);
/// assert!(!contours[0].is_hole());
/// assert_eq!(contours[0].points().count(), 8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Clipper<S, const N: usize> = clipper::Clipper<S, WeilerAtherton, N>;

/// Weiler and Atherton's algorithm, as the method of a [`Clipper`].
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
