//! The third phase: the kept fragments become contours.
//!
//! An outline that comes to a point goes on along the border of the same part of the result: of all kept fragments that
//! leave, the one next to it on the positive side.

use core::cmp::Ordering;

use crate::{
    clip::boolean::{
        contours::{heading, is_kept, leaves, target, walk},
        vertices::{ContourState, End, Vertex, VertexIndex, Vertices},
    },
    geometry::SubPixel,
};

/// Connects all kept fragments to contours, and chooses one fragment to stand for each.
pub(crate) fn connect<S: SubPixel>(table: &mut [Vertex<S>]) {
    let indices = 0..table.len() as VertexIndex;
    for fragment in indices.clone() {
        if is_kept(&table.at(fragment)) {
            let follower = follower(table, fragment);
            table.change(fragment, |vertex| vertex.follower = follower);
        }
    }
    for fragment in indices {
        let vertex = table.at(fragment);
        if is_kept(&vertex) && vertex.walk == ContourState::Open {
            walk(table, fragment);
        }
    }
}

/// The fragment that borders the same part of the result after a kept fragment: the last one of a positive turn from where
/// the outline came.
fn follower<S: SubPixel>(table: &[Vertex<S>], fragment: VertexIndex) -> VertexIndex {
    let back = heading(table, fragment).reversed();
    let mut last: Option<End> = None;
    table.visit_ends(target(table, fragment), &mut |end| {
        let is_later = |last: End| back.order(last.direction, end.direction) == Ordering::Less;
        if leaves(table, &end) && last.is_none_or(is_later) {
            last = Some(end);
        }
    });
    last.map_or(fragment, |end| end.fragment)
}
