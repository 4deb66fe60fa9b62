//! What all boolean operations on polygons begin with and end with: the vertices of both polygons, and the contours read off
//! them. What lies between is the algorithm.

use core::marker::PhantomData;

use heapless::Vec;

use crate::{
    clip::boolean::{
        boolean_method::BooleanMethod, clip_error::ClipError, contours::Clipped, crossings,
        greiner_hormann::GreinerHormann, operation::Operation, vertices::Vertex,
    },
    geometry::{SubPixel, SubPoint},
};

/// Clips polygons by the algorithm `M`, and keeps the result.
///
/// `N` is the number of vertices that it has room for, of which 65,535 are used at most: the corners of both polygons, two for
/// every crossing of two edges, and one for every corner that lies inside an edge.
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
/// let result = clipper.clip(&[&square], &[&slot], Operation::Difference)?;
/// let contours: Vec<_> = result.contours().collect();
/// assert_eq!(contours.len(), 1);
/// assert!(!contours[0].is_hole());
/// assert_eq!(contours[0].points().count(), 8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Clipper<S: SubPixel, const N: usize, M = GreinerHormann> {
    vertices: Vec<Vertex<S>, N>,
    method: PhantomData<M>,
}

impl<S: SubPixel, const N: usize, M: BooleanMethod> Default for Clipper<S, N, M> {
    fn default() -> Self {
        Self {
            vertices: Vec::new(),
            method: PhantomData,
        }
    }
}

impl<S: SubPixel, const N: usize> Clipper<S, N> {
    /// A clipper by [`GreinerHormann`] that has clipped nothing yet; one by another algorithm is a
    /// `Clipper::<S, N, M>::default()`.
    pub const fn new() -> Self {
        Self {
            vertices: Vec::new(),
            method: PhantomData,
        }
    }
}

impl<S: SubPixel, const N: usize, M: BooleanMethod> Clipper<S, N, M> {
    /// Clips the subject by another polygon, which [`Operation::Intersection`] keeps and [`Operation::Difference`] takes
    /// away. What was clipped before is gone.
    ///
    /// A contour is closed by itself and may run either way.
    ///
    /// # Errors
    /// [`ClipError::OutOfDomain`]; [`ClipError::TableFull`] with a number of vertices that would do.
    pub fn clip(
        &mut self,
        subject: &[&[SubPoint<S>]],
        clip: &[&[SubPoint<S>]],
        operation: Operation,
    ) -> Result<Clipped<'_, S>, ClipError> {
        let vertices = self.vertices.as_mut_view();
        crossings::build(vertices, subject, clip, operation)?;
        M::link(vertices, operation);
        Ok(Clipped { vertices })
    }
}

#[cfg(feature = "defmt")]
impl<S: SubPixel, const N: usize, M> defmt::Format for Clipper<S, N, M> {
    /// A table is too long for the probe: its size will do.
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Clipper with {} of {} vertices", self.vertices.len(), N);
    }
}
