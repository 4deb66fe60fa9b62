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
//! all edges of the result, on both axes. A part thinner than a unit may so be left with no area, or meet itself or
//! another one; it is handed over all the same.
//!
//! Cost: a comparison of extents for every two edges of both polygons, four products where these meet, two 64-bit
//! divisions for each coordinate of a crossing. Polygons whose extents are apart are told at once. RAM: 20 bytes a
//! vertex with [`Sub4`](crate::geometry::Sub4), 24 with [`Sub8`](crate::geometry::Sub8).
//!
//! Take it when either polygon is not convex, has holes, or is to be joined or subtracted. Its number of steps grows with
//! the square of the number of edges.

mod labels;
mod outlines;

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

/// Clips polygons by Greiner and Hormann's algorithm, and keeps the result.
///
/// `N` is the number of vertices that it has room for, of which 65,535 are used at most: the corners of both polygons, two for
/// every crossing of two edges, and one for every corner that lies inside an edge.
///
/// ```
/// use zrow::clip::boolean::greiner_hormann::{Clipper, Operation};
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
pub type Clipper<S, const N: usize> = clipper::Clipper<S, GreinerHormann, N>;

/// Greiner and Hormann's algorithm, as the method of a [`Clipper`].
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GreinerHormann;

impl BooleanMethod for GreinerHormann {
    fn link<S: SubPixel>(vertices: &mut VecView<Vertex<S>>, operation: Operation) {
        labels::label(vertices, operation);
        outlines::connect(vertices);
    }
}
