//! What all boolean operations on polygons begin with and end with: the vertices of both polygons, and the contours read off
//! them. What lies between is the algorithm.

use core::marker::PhantomData;

use heapless::{Vec, VecView};

use crate::{
    clip::boolean::{clip_error::ClipError, contours::Clipped, crossings, operation::Operation, vertices::Vertex},
    geometry::{SubPixel, SubPoint},
};

/// An algorithm for boolean operations: [`GreinerHormann`](crate::clip::boolean::greiner_hormann::GreinerHormann) or
/// [`WeilerAtherton`](crate::clip::boolean::weiler_atherton::WeilerAtherton).
pub trait BooleanMethod {
    /// Links the fragments of both polygons' contours that bound the result: each gets the fragment that follows it.
    #[doc(hidden)]
    fn link<S: SubPixel>(vertices: &mut VecView<Vertex<S>>, operation: Operation);
}

/// Clips polygons, and keeps the result: the `Clipper` of a module such as
/// [`greiner_hormann`](crate::clip::boolean::greiner_hormann::Clipper) is one with the algorithm `M`.
///
/// `N` is the number of vertices that it has room for, of which 65,535 are used at most: the corners of both polygons, two for
/// every crossing of two edges, and one for every corner that lies inside an edge.
#[derive(Debug)]
pub struct Clipper<S: SubPixel, M, const N: usize> {
    vertices: Vec<Vertex<S>, N>,
    method: PhantomData<M>,
}

impl<S: SubPixel, M, const N: usize> Default for Clipper<S, M, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: SubPixel, M, const N: usize> Clipper<S, M, N> {
    /// A clipper that has clipped nothing yet.
    pub const fn new() -> Self {
        Self {
            vertices: Vec::new(),
            method: PhantomData,
        }
    }
}

impl<S: SubPixel, M: BooleanMethod, const N: usize> Clipper<S, M, N> {
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
impl<S: SubPixel, M, const N: usize> defmt::Format for Clipper<S, M, N> {
    /// A table is too long for the probe: its size will do.
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Clipper with {} of {} vertices", self.vertices.len(), N);
    }
}
