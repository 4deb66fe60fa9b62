//! What methods of hidden lines hand over: parts of edges.

use embedded_graphics::geometry::Point;

use crate::{geometry::SubPoint, view::ScreenPrecision};

/// A part of an edge that is hidden or visible as a whole, on the screen.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinePart<S: ScreenPrecision> {
    /// Index of the edge's model among the models; of an intersection that of the first of the two.
    pub model: usize,
    /// Index of the edge in the table of edges of its model; `None` for an intersection.
    pub edge: Option<usize>,
    /// The ends on the screen, from the edge's first to its second end.
    pub ends: [SubPoint<S>; 2],
    /// What kind of line the edge is.
    pub kind: PartKind,
    /// Whether faces hide the part. Technical drawings have hidden parts dashed, others leave them out.
    pub is_hidden: bool,
}

impl<S: ScreenPrecision> LinePart<S> {
    /// The pixels that the ends are in: their positions to the nearest pixel, halves to the right and down.
    pub fn pixels(&self) -> [Point; 2] {
        let nearest = |units: i32| (units + (1 << (S::FRACTION_BITS - 1))) >> S::FRACTION_BITS;
        let pixel = |end: &SubPoint<S>| Point::new(nearest(end.x_units()), nearest(end.y_units()));
        let [from, to] = &self.ends;
        [pixel(from), pixel(to)]
    }
}

/// What kind of line a part of an edge is in a line drawing.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PartKind {
    /// Of the two faces at the edge one is seen from the front: the solid ends there as it is seen.
    Silhouette,
    /// The faces at the edge turn sharply, and both are seen.
    Crease,
    /// Only one face has the edge: the surface ends there.
    Boundary,
    /// Two faces penetrate each other there; no mesh has this edge.
    Intersection,
}
