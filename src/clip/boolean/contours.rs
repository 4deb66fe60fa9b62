//! The contours of a result: kept fragments, each of which names its follower, are walked and cut into closed contours.
//!
//! A walk that comes to a point a second time is cut there into two contours. So parts that only share a point become contours
//! of their own, and no contour meets itself in a point.

use core::iter;

use crate::{
    clip::boolean::{
        direction::Direction,
        vertices::{ContourState, End, Label, Vertex, VertexIndex, Vertices},
    },
    geometry::{SubPixel, SubPoint},
};

/// The contours of a result, in no order that means something. None where nothing is left.
pub(crate) fn contours<S: SubPixel>(vertices: &[Vertex<S>]) -> impl Iterator<Item = Contour<'_, S>> + Clone {
    let indices = 0..vertices.len() as VertexIndex;
    indices
        .filter(move |&fragment| matches!(vertices.at(fragment).walk, ContourState::Outer | ContourState::Hole))
        .map(move |first| Contour { vertices, first })
}

/// A contour of what a boolean operation on two polygons leaves, in the clipper's memory, without corners on straight lines. It passes no point twice, but for crossings that rounding
/// brings together.
#[derive(Debug, Copy, Clone)]
pub struct Contour<'a, S: SubPixel> {
    vertices: &'a [Vertex<S>],
    first: VertexIndex,
}

impl<'a, S: SubPixel> Contour<'a, S> {
    /// Whether the contour bounds a hole: the result lies around the contour and not in it. Holes run counter-clockwise on the screen, where y grows
    /// downwards, and outer contours clockwise, but for those thinner than a unit, which rounding may turn around.
    pub fn is_hole(&self) -> bool {
        self.vertices.at(self.first).walk == ContourState::Hole
    }

    /// The corners of the contour in order; the last one joins the first.
    pub fn points(&self) -> impl Iterator<Item = SubPoint<S>> + Clone + use<'a, S> {
        let Self { vertices, first } = *self;
        iter::successors(Some(first), move |&fragment| {
            Some(vertices.at(fragment).follower).filter(|&follower| follower != first)
        })
        .filter_map(move |fragment| corner_after(vertices, fragment))
    }
}

pub(crate) fn is_kept<S: SubPixel>(fragment: &Vertex<S>) -> bool {
    matches!(fragment.label, Label::Along | Label::Against)
}

/// Whether the outline leaves along a fragment from the point that this end is at.
pub(crate) fn leaves<S: SubPixel>(table: &[Vertex<S>], end: &End) -> bool {
    match table.at(end.fragment).label {
        Label::Along => end.begins,
        Label::Against => !end.begins,
        _ => false,
    }
}

/// The direction of the outline along a kept fragment.
pub(crate) fn heading<S: SubPixel>(table: &[Vertex<S>], fragment: VertexIndex) -> Direction {
    let direction = table.direction(fragment);
    match table.at(fragment).label {
        Label::Against => direction.reversed(),
        _ => direction,
    }
}

/// The vertex that the outline arrives at along a kept fragment.
pub(crate) fn target<S: SubPixel>(table: &[Vertex<S>], fragment: VertexIndex) -> VertexIndex {
    let vertex = table.at(fragment);
    match vertex.label {
        Label::Against => fragment,
        _ => vertex.next,
    }
}

/// Walks from a fragment until all walked fragments are in closed contours.
pub(crate) fn walk<S: SubPixel>(table: &mut [Vertex<S>], start: VertexIndex) {
    let mut fragment = start;
    loop {
        table.change(fragment, |vertex| vertex.walk = ContourState::Under);
        let follower = table.at(fragment).follower;
        if let Some(first) = walked_from(table, target(table, fragment)) {
            // The walk was at this point before: what lies between is a contour, and who came here first goes on.
            if first != follower {
                if let Some(came_first) = predecessor(table, target(table, fragment), first) {
                    table.change(came_first, |vertex| vertex.follower = follower);
                }
                table.change(fragment, |vertex| vertex.follower = first);
            }
            close(table, first);
            if first == follower {
                return;
            }
        }
        fragment = follower;
    }
}

/// The fragment on the walk that leaves from a point. There is one at most: a walk that comes back is cut.
fn walked_from<S: SubPixel>(table: &[Vertex<S>], index: VertexIndex) -> Option<VertexIndex> {
    let mut found = None;
    table.visit_ends(index, &mut |end| {
        if leaves(table, &end) && table.at(end.fragment).walk == ContourState::Under {
            found = Some(end.fragment);
        }
    });
    found
}

/// The fragment that arrives at a point and is followed by another one.
fn predecessor<S: SubPixel>(table: &[Vertex<S>], index: VertexIndex, follower: VertexIndex) -> Option<VertexIndex> {
    let mut found = None;
    table.visit_ends(index, &mut |end| {
        let fragment = table.at(end.fragment);
        if is_kept(&fragment) && !leaves(table, &end) && fragment.follower == follower {
            found = Some(end.fragment);
        }
    });
    found
}

/// Marks all fragments of the contour that begins with a fragment as closed, and the first one as that of an outer
/// contour or of a hole.
fn close<S: SubPixel>(table: &mut [Vertex<S>], first: VertexIndex) {
    let mut turns = 0;
    let mut fragment = first;
    loop {
        table.change(fragment, |vertex| vertex.walk = ContourState::Closed);
        let follower = table.at(fragment).follower;
        turns += heading(table, fragment).turns_to(heading(table, follower));
        fragment = follower;
        if fragment == first {
            break;
        }
    }
    // The result lies on the positive side: around an outer contour the outline turns that way.
    let walk = if turns > 0 {
        ContourState::Outer
    } else {
        ContourState::Hole
    };
    table.change(first, |vertex| vertex.walk = walk);
}

/// The point that a kept fragment leads to; `None` where the outline runs straight on.
fn corner_after<S: SubPixel>(table: &[Vertex<S>], fragment: VertexIndex) -> Option<SubPoint<S>> {
    let turn = heading(table, fragment).cross(heading(table, table.at(fragment).follower));
    (turn != 0).then(|| table.at(target(table, fragment)).point)
}

#[cfg(feature = "defmt")]
mod formats {
    //! For the log a number stands for a table, which would be too long for a debug probe.

    use super::{Contour, SubPixel};

    impl<S: SubPixel> defmt::Format for Contour<'_, S> {
        fn format(&self, formatter: defmt::Formatter<'_>) {
            defmt::write!(formatter, "Contour, hole: {}", self.is_hole());
        }
    }
}
