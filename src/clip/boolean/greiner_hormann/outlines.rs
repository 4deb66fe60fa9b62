//! The third phase: the kept pieces become contours.
//!
//! An outline that comes to a point goes on along the border of the same part of the result: of all kept pieces that
//! leave, the one next to it on the positive side. Where it comes to a point a second time, it is cut there in two. So
//! parts that only share a point are parts of their own, and no contour meets itself in a point.

use core::cmp::Ordering;

use crate::{
    clip::boolean::greiner_hormann::{
        direction::Direction,
        vertices::{End, Label, Place, Vertex, Vertices, Walk},
    },
    geometry::{SubPixel, SubPoint},
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

fn is_kept<S: SubPixel>(piece: &Vertex<S>) -> bool {
    matches!(piece.label, Label::Along | Label::Against)
}

/// Whether the outline leaves along a piece from the point that this end is at.
fn leaves<S: SubPixel>(table: &[Vertex<S>], end: &End) -> bool {
    match table.at(end.piece).label {
        Label::Along => end.begins,
        Label::Against => !end.begins,
        _ => false,
    }
}

/// The direction of the outline along a kept piece.
fn heading<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> Direction {
    let direction = table.direction(piece);
    match table.at(piece).label {
        Label::Against => direction.reversed(),
        _ => direction,
    }
}

/// The vertex that the outline arrives at along a kept piece.
fn target<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> Place {
    let vertex = table.at(piece);
    match vertex.label {
        Label::Against => piece,
        _ => vertex.next,
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

/// Walks from a piece until all walked pieces are in closed contours.
fn walk<S: SubPixel>(table: &mut [Vertex<S>], start: Place) {
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
pub(crate) fn corner_after<S: SubPixel>(table: &[Vertex<S>], piece: Place) -> Option<SubPoint<S>> {
    let turn = heading(table, piece).cross(heading(table, table.at(piece).follower));
    (turn != 0).then(|| table.at(target(table, piece)).point)
}
