//! The contours of a result: kept pieces, each of which names its follower, are walked and cut into closed contours.
//!
//! Where a walk comes to a point a second time, it is cut there in two. So parts that only share a point are parts of their
//! own, and no contour meets itself in a point.

use core::iter;

use crate::{
    clip::boolean::{
        direction::Direction,
        vertices::{End, Label, Place, Vertex, Vertices, Walk},
    },
    geometry::{SubPixel, SubPoint},
};

/// The polygon that is left.
#[derive(Debug)]
pub struct Clipped<'a, S: SubPixel> {
    pub(crate) vertices: &'a [Vertex<S>],
}

impl<'a, S: SubPixel> Clipped<'a, S> {
    /// The contours of the result, in no order that means something. None where nothing is left.
    pub fn contours(&self) -> impl Iterator<Item = Contour<'a, S>> + Clone + use<'a, S> {
        let vertices = self.vertices;
        let places = 0..vertices.len() as Place;
        places
            .filter(move |&piece| matches!(vertices.at(piece).walk, Walk::Outer | Walk::Hole))
            .map(move |first| Contour { vertices, first })
    }
}

/// A contour of the result, without corners on straight lines. It passes no point twice, but for crossings that rounding
/// brings together.
#[derive(Debug, Copy, Clone)]
pub struct Contour<'a, S: SubPixel> {
    vertices: &'a [Vertex<S>],
    first: Place,
}

impl<'a, S: SubPixel> Contour<'a, S> {
    /// Whether the result lies around it and not in it. Holes run counter-clockwise on the screen, where y grows
    /// downwards, and outer contours clockwise.
    pub fn is_hole(&self) -> bool {
        self.vertices.at(self.first).walk == Walk::Hole
    }

    /// The corners of the contour in order; the last one joins the first.
    pub fn points(&self) -> impl Iterator<Item = SubPoint<S>> + Clone + use<'a, S> {
        let Self { vertices, first } = *self;
        iter::successors(Some(first), move |&piece| {
            Some(vertices.at(piece).follower).filter(|&follower| follower != first)
        })
        .filter_map(move |piece| corner_after(vertices, piece))
    }
}

pub(crate) fn is_kept<S: SubPixel>(piece: &Vertex<S>) -> bool {
    matches!(piece.label, Label::Along | Label::Against)
}

/// Whether the outline leaves along a piece from the point that this end is at.
pub(crate) fn leaves<S: SubPixel>(table: &[Vertex<S>], end: &End) -> bool {
    match table.at(end.piece).label {
        Label::Along => end.begins,
        Label::Against => !end.begins,
        _ => false,
    }
}

/// The direction of the outline along a kept piece.
pub(crate) fn heading<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> Direction {
    let direction = table.direction(piece);
    match table.at(piece).label {
        Label::Against => direction.reversed(),
        _ => direction,
    }
}

/// The vertex that the outline arrives at along a kept piece.
pub(crate) fn target<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> Place {
    let vertex = table.at(piece);
    match vertex.label {
        Label::Against => piece,
        _ => vertex.next,
    }
}

/// Walks from a piece until all walked pieces are in closed contours.
pub(crate) fn walk<S: SubPixel>(table: &mut [Vertex<S>], start: Place) {
    let mut piece = start;
    loop {
        table.change(piece, |vertex| vertex.walk = Walk::Under);
        let follower = table.at(piece).follower;
        if let Some(first) = walked_from(table, target(table, piece)) {
            // The walk was at this point before: what lies between is a contour, and who came here first goes on.
            if first != follower {
                if let Some(came_first) = predecessor(table, target(table, piece), first) {
                    table.change(came_first, |vertex| vertex.follower = follower);
                }
                table.change(piece, |vertex| vertex.follower = first);
            }
            close(table, first);
            if first == follower {
                return;
            }
        }
        piece = follower;
    }
}

/// The piece on the walk that leaves from a point. There is one at most: a walk that comes back is cut.
fn walked_from<S: SubPixel>(table: &[Vertex<S>], place: Place) -> Option<Place> {
    let mut found = None;
    table.visit_ends(place, &mut |end| {
        if leaves(table, &end) && table.at(end.piece).walk == Walk::Under {
            found = Some(end.piece);
        }
    });
    found
}

/// The piece that arrives at a point and is followed by another one.
fn predecessor<S: SubPixel>(table: &[Vertex<S>], place: Place, follower: Place) -> Option<Place> {
    let mut found = None;
    table.visit_ends(place, &mut |end| {
        let piece = table.at(end.piece);
        if is_kept(&piece) && !leaves(table, &end) && piece.follower == follower {
            found = Some(end.piece);
        }
    });
    found
}

/// Closes the contour that a piece is of.
fn close<S: SubPixel>(table: &mut [Vertex<S>], first: Place) {
    let mut turns = 0;
    let mut piece = first;
    loop {
        table.change(piece, |vertex| vertex.walk = Walk::Closed);
        let follower = table.at(piece).follower;
        turns += heading(table, piece).turns_to(heading(table, follower));
        piece = follower;
        if piece == first {
            break;
        }
    }
    // The result lies on the positive side: around an outer contour the outline turns that way.
    let walk = if turns > 0 { Walk::Outer } else { Walk::Hole };
    table.change(first, |vertex| vertex.walk = walk);
}

/// The point that a kept piece leads to; `None` where the outline runs straight on.
fn corner_after<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> Option<SubPoint<S>> {
    let turn = heading(table, piece).cross(heading(table, table.at(piece).follower));
    (turn != 0).then(|| table.at(target(table, piece)).point)
}

#[cfg(feature = "defmt")]
mod formats {
    //! Tables are too long for the probe: their sizes will do.

    use super::{Clipped, Contour, SubPixel};

    impl<S: SubPixel> defmt::Format for Clipped<'_, S> {
        fn format(&self, formatter: defmt::Formatter<'_>) {
            defmt::write!(formatter, "Clipped of {} vertices", self.vertices.len());
        }
    }

    impl<S: SubPixel> defmt::Format for Contour<'_, S> {
        fn format(&self, formatter: defmt::Formatter<'_>) {
            defmt::write!(formatter, "Contour, hole: {}", self.is_hole());
        }
    }
}
