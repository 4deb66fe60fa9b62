//! The vertices of both polygons: each contour a ring, rings linked where they meet.
//!
//! A vertex is one passage of a contour through a point. Where two contours meet, or one meets itself, each has a vertex
//! of its own there, and these neighbours form a ring as well. Between two vertices along a contour lies a fragment of an
//! edge; it is called by the vertex that it begins with, and nothing meets it between its ends.

use core::iter;

use heapless::VecView;

use crate::{
    clip::boolean::{direction::Direction, segment::ExactSegment},
    geometry::{SubPixel, SubPoint},
};

/// Where a vertex is in the table: fewer than `VertexIndex::MAX` have one, so that their number is one, too.
pub(crate) type VertexIndex = u16;

/// A set of the two polygons.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Polygons(u8);

impl Polygons {
    pub(crate) const NEITHER: Self = Self(0);
    pub(crate) const SUBJECT: Self = Self(1);
    pub(crate) const CLIP: Self = Self(2);

    pub(crate) const fn contains(self, polygon: Self) -> bool {
        self.0 & polygon.0 != 0
    }

    /// The polygons that are in one of two sets but not in both: what crossing an edge does to the inside.
    #[must_use]
    pub(crate) const fn toggled(self, other: Self) -> Self {
        Self(self.0 ^ other.0)
    }
}

#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) enum Origin {
    /// A corner of a contour of that polygon; its edge runs to the corner `end`.
    Corner { end: VertexIndex, owner: Polygons },
    /// A vertex on an edge, where a corner lies on it.
    Touch,
    /// A vertex on an edge, where the edge that begins at the corner `by` crosses it.
    Crossing { by: VertexIndex },
}

/// What the fragment that begins at a vertex is to the result.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) enum Label {
    /// Whether the fragment belongs to the result is not known yet.
    Unknown,
    /// The result has both its sides, or neither; or another fragment between the same points stands for it.
    Dropped,
    /// The result lies on its positive side: its outline runs along.
    Along,
    /// The result lies on its negative side: its outline runs against it.
    Against,
}

/// How far a kept fragment has come into a contour of the result.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) enum ContourState {
    /// The fragment is in no contour yet.
    Open,
    /// The fragment is not in the result, although its label does not say so yet.
    Excluded,
    /// The fragment is on the walk around a contour that is not closed yet.
    Under,
    /// The fragment is in a contour that is closed.
    Closed,
    /// The fragment is in a closed outer contour, which is found by this vertex.
    Outer,
    /// The fragment is in a closed contour that is a hole and is found by this vertex.
    Hole,
}

#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vertex<S: SubPixel> {
    /// Exact, but for a crossing, which is rounded.
    pub(crate) point: SubPoint<S>,
    pub(crate) origin: Origin,
    /// The corner that its edge begins with: where it lies, and where a corner's contour goes on.
    pub(crate) edge: VertexIndex,
    pub(crate) next: VertexIndex,
    pub(crate) previous: VertexIndex,
    /// The next vertex at the same point; itself where there is no other.
    pub(crate) neighbour: VertexIndex,
    /// The fragment after this one in the outline of the result.
    pub(crate) follower: VertexIndex,
    pub(crate) label: Label,
    pub(crate) walk: ContourState,
}

impl<S: SubPixel> Vertex<S> {
    pub(crate) const fn new(point: SubPoint<S>, origin: Origin, edge: VertexIndex) -> Self {
        Self {
            point,
            origin,
            edge,
            next: 0,
            previous: 0,
            neighbour: 0,
            follower: 0,
            label: Label::Unknown,
            walk: ContourState::Open,
        }
    }
}

/// One end of a fragment, seen from the point that it is at.
#[derive(Debug, Copy, Clone)]
pub(crate) struct End {
    pub(crate) fragment: VertexIndex,
    /// The direction of a fragment, away from the point that it is seen from.
    pub(crate) direction: Direction,
    /// Whether the fragment begins here.
    pub(crate) begins: bool,
}

/// The table of vertices is full.
#[derive(Debug)]
pub(crate) struct Full;

/// What a table of vertices is asked. Indices come from the table itself: where one is not in it, nothing depends on the
/// answer.
pub(crate) trait Vertices<S: SubPixel> {
    fn at(&self, index: VertexIndex) -> Vertex<S>;

    fn change(&mut self, index: VertexIndex, change: impl FnOnce(&mut Vertex<S>));

    /// The edge that begins at a corner.
    fn segment(&self, corner: VertexIndex) -> ExactSegment<S> {
        let start = self.at(corner);
        let end = match start.origin {
            Origin::Corner { end, .. } => self.at(end).point,
            _ => start.point,
        };
        ExactSegment {
            start: start.point,
            end,
        }
    }

    /// The polygon that a fragment is of.
    fn owner(&self, fragment: VertexIndex) -> Polygons {
        match self.at(self.at(fragment).edge).origin {
            Origin::Corner { owner, .. } => owner,
            _ => Polygons::NEITHER,
        }
    }

    /// The direction of a fragment, taken from its whole edge: exact, unlike the difference of rounded points.
    fn direction(&self, fragment: VertexIndex) -> Direction {
        self.segment(self.at(fragment).edge).direction()
    }

    fn beginning(&self, fragment: VertexIndex) -> End {
        End {
            fragment,
            direction: self.direction(fragment),
            begins: true,
        }
    }

    fn ending(&self, fragment: VertexIndex) -> End {
        End {
            fragment,
            direction: self.direction(fragment).reversed(),
            begins: false,
        }
    }

    /// All vertices at the same point, this one first.
    fn neighbours(&self, index: VertexIndex) -> impl Iterator<Item = VertexIndex> {
        iter::successors(Some(index), move |&at| {
            Some(self.at(at).neighbour).filter(|&next| next != index)
        })
    }

    /// Visits the ends of all fragments at a point. One loop in flash for all who ask.
    fn visit_ends(&self, index: VertexIndex, visit: &mut dyn FnMut(End));

    /// Makes neighbours of two vertices, and of their neighbours.
    fn link(&mut self, one: VertexIndex, other: VertexIndex) {
        if self.neighbours(one).all(|index| index != other) {
            // Two rings become one when two of their links are exchanged.
            let (after_one, after_other) = (self.at(one).neighbour, self.at(other).neighbour);
            self.change(one, |vertex| vertex.neighbour = after_other);
            self.change(other, |vertex| vertex.neighbour = after_one);
        }
    }
}

impl<S: SubPixel> Vertices<S> for [Vertex<S>] {
    fn at(&self, index: VertexIndex) -> Vertex<S> {
        let nowhere = || Vertex::new(SubPoint::default(), Origin::Touch, index);
        self.get(usize::from(index)).copied().unwrap_or_else(nowhere)
    }

    #[inline(never)]
    fn segment(&self, corner: VertexIndex) -> ExactSegment<S> {
        let start = self.at(corner);
        let end = match start.origin {
            Origin::Corner { end, .. } => self.at(end).point,
            _ => start.point,
        };
        ExactSegment {
            start: start.point,
            end,
        }
    }

    #[inline(never)]
    fn visit_ends(&self, index: VertexIndex, visit: &mut dyn FnMut(End)) {
        for at in self.neighbours(index) {
            visit(self.beginning(at));
            visit(self.ending(self.at(at).previous));
        }
    }

    fn change(&mut self, index: VertexIndex, change: impl FnOnce(&mut Vertex<S>)) {
        if let Some(vertex) = self.get_mut(usize::from(index)) {
            change(vertex);
        }
    }
}

/// Puts a vertex into the ring of its contour, after the one at `previous`.
///
/// The first one of a contour is not in the table yet, and is its own ring.
pub(crate) fn insert<S: SubPixel>(
    table: &mut VecView<Vertex<S>>,
    vertex: Vertex<S>,
    previous: Option<VertexIndex>,
) -> Result<VertexIndex, Full> {
    let index = VertexIndex::try_from(table.len()).map_err(|_| Full)?;
    if index == VertexIndex::MAX {
        return Err(Full);
    }
    let previous = previous.unwrap_or(index);
    let next = if previous == index {
        index
    } else {
        table.at(previous).next
    };
    let linked = Vertex {
        next,
        previous,
        neighbour: index,
        ..vertex
    };
    table.push(linked).map_err(|_| Full)?;
    table.change(previous, |vertex| vertex.next = index);
    table.change(next, |vertex| vertex.previous = index);
    Ok(index)
}

#[cfg(test)]
pub(crate) mod tests {
    extern crate std;

    use super::*;
    use crate::geometry::Sub8;

    /// A contour with as many corners as there are indices.
    pub(crate) fn comb_of_all_indices() -> std::vec::Vec<Vertex<Sub8>> {
        let corners = VertexIndex::MAX;
        // Teeth upwards, closed by the straight way back along their feet's line, below it at the last corner.
        let height = |index: VertexIndex| if index == corners - 1 { 9 } else { -i32::from(index % 2) };
        let vertex = |index: VertexIndex| {
            let (next, previous) = ((index + 1) % corners, index.checked_sub(1).unwrap_or(corners - 1));
            let origin = Origin::Corner {
                end: next,
                owner: Polygons::SUBJECT,
            };
            let point = SubPoint::<Sub8>::from_units(i32::from(index), height(index)).unwrap();
            Vertex {
                next,
                previous,
                neighbour: index,
                ..Vertex::new(point, origin, index)
            }
        };
        (0..corners).map(vertex).collect()
    }
}
