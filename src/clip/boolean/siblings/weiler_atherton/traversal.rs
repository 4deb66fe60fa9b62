//! The fourth phase: the walk over both polygons' contours, from the points where the subject comes to bound the result.
//!
//! ```text
//!      subject ----->(enters)=====>(leaves)- - - >     A walk starts where the subject enters,
//!                       ^             |               follows the subject up to where it leaves,
//!      clip             |             v               goes over to the clip polygon, follows that
//!                       +====<====<===+               up to where the subject enters, and so on.
//! ```
//!
//! Where more than two fragments of the result meet in a point, more than one may go on there. The walk then takes the one that
//! bounds the sector of the result that it has walked along: the last of a positive turn from where it came.

use core::cmp::Ordering;

use crate::{
    clip::boolean::{
        contours::{heading, is_kept, leaves, target, walk},
        vertices::{ContourState, End, Label, Polygons, Vertex, VertexIndex, Vertices},
    },
    geometry::SubPixel,
};

/// Connects all kept fragments to contours: first those that begin where the subject enters, then what has no such point.
///
/// Cost: two orientations for every end where a kept fragment comes to an intersection.
pub(crate) fn traverse<S: SubPixel>(table: &mut [Vertex<S>]) {
    let fragments = 0..table.len() as VertexIndex;
    for fragment in fragments.clone() {
        if is_kept(&table.at(fragment)) {
            let follower = go_on(table, fragment);
            table.change(fragment, |vertex| vertex.follower = follower);
        }
    }
    for fragment in fragments.clone() {
        if is_open(table, fragment) && table.owner(fragment) == Polygons::SUBJECT && is_entered(table, fragment) {
            walk(table, fragment);
        }
    }
    // Contours of one polygon alone, and those on which the other one enters by coming away from a common boundary.
    for fragment in fragments {
        if is_open(table, fragment) {
            walk(table, fragment);
        }
    }
}

/// Whether a fragment bounds the result and is in no contour yet.
fn is_open<S: SubPixel>(table: &[Vertex<S>], fragment: VertexIndex) -> bool {
    let vertex = table.at(fragment);
    is_kept(&vertex) && vertex.walk == ContourState::Open
}

/// Whether a kept fragment begins where its contour comes to bound the result: the fragment before it does not.
fn is_entered<S: SubPixel>(table: &[Vertex<S>], fragment: VertexIndex) -> bool {
    let vertex = table.at(fragment);
    let before = match vertex.label {
        Label::Against => vertex.next,
        _ => vertex.previous,
    };
    !is_kept(&table.at(before))
}

/// The fragment on which the walk goes on after a kept fragment.
fn go_on<S: SubPixel>(table: &[Vertex<S>], fragment: VertexIndex) -> VertexIndex {
    let vertex = table.at(fragment);
    let point = target(table, fragment);
    let next = match vertex.label {
        Label::Against => vertex.previous,
        _ => vertex.next,
    };
    if table.at(point).neighbour == point {
        // No intersection: on along the same contour.
        return next;
    }
    let back = heading(table, fragment).reversed();
    let mut last: Option<End> = None;
    table.visit_ends(point, &mut |end| {
        let is_later = |last: End| back.order(last.direction, end.direction) == Ordering::Less;
        if leaves(table, &end) && last.is_none_or(is_later) {
            last = Some(end);
        }
    });
    last.map_or(next, |end| end.fragment)
}
