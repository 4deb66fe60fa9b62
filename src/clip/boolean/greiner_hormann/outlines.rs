//! The third phase: the kept pieces become contours.
//!
//! An outline that comes to a point goes on along the border of the same part of the result: of all kept pieces that
//! leave, the one next to it on the positive side.

use core::cmp::Ordering;

use crate::{
    clip::boolean::{
        contours::{heading, is_kept, leaves, target, walk},
        vertices::{End, Place, Vertex, Vertices, Walk},
    },
    geometry::SubPixel,
};

/// Connects all kept pieces to contours, and chooses one piece to stand for each.
pub(crate) fn connect<S: SubPixel>(table: &mut [Vertex<S>]) {
    let places = 0..table.len() as Place;
    for piece in places.clone() {
        if is_kept(&table.at(piece)) {
            let follower = follower(table, piece);
            table.change(piece, |vertex| vertex.follower = follower);
        }
    }
    for piece in places {
        let vertex = table.at(piece);
        if is_kept(&vertex) && vertex.walk == Walk::Open {
            walk(table, piece);
        }
    }
}

/// The piece that borders the same part of the result after a kept piece: the last one of a positive turn from where
/// the outline came.
fn follower<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> Place {
    let back = heading(table, piece).reversed();
    let mut last: Option<End> = None;
    table.visit_ends(target(table, piece), &mut |end| {
        let is_later = |last: End| back.order(last.direction, end.direction) == Ordering::Less;
        if leaves(table, &end) && last.is_none_or(is_later) {
            last = Some(end);
        }
    });
    last.map_or(piece, |end| end.piece)
}
