//! The part of a boolean operation on polygons in which algorithms differ.

use heapless::VecView;

use crate::{
    clip::boolean::{operation::Operation, vertices::Vertex},
    geometry::SubPixel,
};

/// An algorithm for boolean operations on polygons: [`GreinerHormann`](crate::clip::GreinerHormann) or
/// [`WeilerAtherton`](crate::clip::WeilerAtherton). No other type can be one.
pub trait BooleanMethod {
    /// Links the fragments of both polygons' contours that bound the result: each gets the fragment that follows it.
    fn link<S: SubPixel>(vertices: &mut VecView<Vertex<S>>, operation: Operation);
}
