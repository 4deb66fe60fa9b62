//! What all boolean operations on polygons begin with and end with: the vertices of both polygons, and the contours read off
//! them. What lies between is the algorithm.

use heapless::{Vec, VecView};

use crate::{
    clip::boolean::{crossings, operation::Operation, vertices::Vertex},
    geometry::{InputError, SubPixel, SubPoint},
};

/// Clips polygons against polygons, and keeps the result: a function for each algorithm, all with the signature
/// `fn(&mut self, subject, clip, operation)`.
///
/// [`greiner_hormann`](Self::greiner_hormann) is the one to take, [`weiler_atherton`](Self::weiler_atherton) is kept to compare
/// it. Both find where edges meet in the same way, exactly, and give the same contours; they differ in how they tell what of
/// a contour belongs to the result.
///
/// `N` is the number of vertices that it has room for, of which 65,535 are used at most: the corners of both polygons, two for
/// every crossing of two edges, and one for every corner that lies inside an edge.
/// The number that an error names is exact where no three edges meet in a point, and enough everywhere. Above 65,535 no table
/// will do: clip parts of the polygons. With more corners than that, no more is counted.
///
/// ```
/// use zrow::clip::{Clipper, Operation};
/// use zrow::geometry::{Sub8, SubPoint};
///
/// let corner = |x: i32, y: i32| SubPoint::<Sub8>::from_units(x << 8, y << 8);
/// let square = [corner(0, 0)?, corner(8, 0)?, corner(8, 8)?, corner(0, 8)?];
/// // Its upper side lies on the square's.
/// let slot = [corner(3, 0)?, corner(5, 0)?, corner(5, 4)?, corner(3, 4)?];
///
/// let mut clipper = Clipper::<Sub8, 16>::new();
/// let result = clipper.greiner_hormann(&[&square], &[&slot], Operation::Difference)?;
/// let contours: Vec<_> = result.collect();
/// assert_eq!(contours.len(), 1);
/// assert!(!contours[0].is_hole());
/// assert_eq!(contours[0].points().count(), 8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Clipper<S: SubPixel, const N: usize> {
    vertices: Vec<Vertex<S>, N>,
}

impl<S: SubPixel, const N: usize> Default for Clipper<S, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: SubPixel, const N: usize> Clipper<S, N> {
    /// A clipper that has clipped nothing yet.
    pub const fn new() -> Self {
        Self { vertices: Vec::new() }
    }

    /// Computes the vertices of both polygons, and has an algorithm link the fragments that bound the result: each gets the
    /// fragment that follows it.
    pub(super) fn clip_by(
        &mut self,
        subject: &[&[SubPoint<S>]],
        clip: &[&[SubPoint<S>]],
        operation: Operation,
        link: impl FnOnce(&mut VecView<Vertex<S>>),
    ) -> Result<&[Vertex<S>], InputError> {
        let vertices = self.vertices.as_mut_view();
        crossings::build(vertices, subject, clip, operation)?;
        link(vertices);
        Ok(vertices)
    }
}

#[cfg(feature = "defmt")]
impl<S: SubPixel, const N: usize> defmt::Format for Clipper<S, N> {
    /// A table is too long for the probe: its size will do.
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Clipper with {} of {} vertices", self.vertices.len(), N);
    }
}
