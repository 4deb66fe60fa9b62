//! The fourth phase: the walk over both polygons' contours, from the points where the subject comes to bound the result.
//!
//! ```text
//!      subject ----->(enters)=====>(leaves)- - - >     A walk starts where the subject enters,
//!                       ^             |               follows the subject up to where it leaves,
//!      clip             |             v               goes over to the clip polygon, follows that
//!                       +====<====<===+               up to where the subject enters, and so on.
//! ```
//!
//! Where more than two pieces of the result meet in a point, more than one may go on there. The walk then takes the one that
//! bounds the sector of the result that it has walked along: the last of a positive turn from where it came.

use core::cmp::Ordering;

use crate::{
    clip::boolean::{
        contours::{heading, is_kept, leaves, target, walk},
        vertices::{End, Label, Place, Polygons, Vertex, Vertices, Walk},
    },
    geometry::SubPixel,
};

/// Connects all kept pieces to contours: first those that begin where the subject enters, then what has no such point.
///
/// Cost: two orientations for every end where a kept piece comes to an intersection.
pub(crate) fn traverse<S: SubPixel>(table: &mut [Vertex<S>]) {
    let pieces = 0..table.len() as Place;
    for piece in pieces.clone() {
        if is_kept(&table.at(piece)) {
            let follower = go_on(table, piece);
            table.change(piece, |vertex| vertex.follower = follower);
        }
    }
    for piece in pieces.clone() {
        if is_open(table, piece) && table.owner(piece) == Polygons::SUBJECT && is_entered(table, piece) {
            walk(table, piece);
        }
    }
    // Contours of one polygon alone, and those on which the other one enters by coming away from a common boundary.
    for piece in pieces {
        if is_open(table, piece) {
            walk(table, piece);
        }
    }
}

/// Whether a piece bounds the result and is in no contour yet.
fn is_open<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> bool {
    let vertex = table.at(piece);
    is_kept(&vertex) && vertex.walk == Walk::Open
}

/// Whether a kept piece begins where its contour comes to bound the result: the piece before it does not.
fn is_entered<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> bool {
    let vertex = table.at(piece);
    let before = match vertex.label {
        Label::Against => vertex.next,
        _ => vertex.previous,
    };
    !is_kept(&table.at(before))
}

/// The piece on which the walk goes on after a kept piece.
fn go_on<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> Place {
    let vertex = table.at(piece);
    let point = target(table, piece);
    let next = match vertex.label {
        Label::Against => vertex.previous,
        _ => vertex.next,
    };
    if table.at(point).neighbour == point {
        // No intersection: on along the same contour.
        return next;
    }
    let back = heading(table, piece).reversed();
    let mut last: Option<End> = None;
    table.visit_ends(point, &mut |end| {
        let is_later = |last: End| back.order(last.direction, end.direction) == Ordering::Less;
        if leaves(table, &end) && last.is_none_or(is_later) {
            last = Some(end);
        }
    });
    last.map_or(next, |end| end.piece)
}
