//! The third phase: at every intersection it is told whether a contour enters the other polygon or leaves it, and so which
//! fragments belong to the result.
//!
//! ```text
//!   leaves ^      / fragment      The boundary of the other polygon has a direction, its inside
//!          |    /              on the positive side: to the right on the screen. Around the
//!          |  /    inside      intersection, the first of its ends that a positive turn from
//!          + <------- arrives  the fragment meets tells on which side the fragment runs: inside
//!   outside                    where the boundary arrives by it, outside where it leaves.
//! ```
//!
//! No intersection is told from the ones before it. In particular a contour that only touches the other polygon neither
//! enters nor leaves, and one that runs along its boundary is told apart by the directions of both.

use core::cmp::Ordering;

use crate::{
    clip::boolean::{
        contours::{is_kept, leaves},
        operation::Operation,
        vertices::{ContourState, End, Label, Origin, Polygons, Vertex, VertexIndex, Vertices},
    },
    geometry::SubPixel,
};

/// Where a fragment lies, seen from the other polygon.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Relation {
    Inside,
    Outside,
    /// On its boundary, both polygons on the same side.
    SameSide,
    /// On its boundary, the polygons on different sides.
    OtherSide,
}

impl Relation {
    /// Whether such a fragment of a polygon bounds the result. On a common boundary the subject's fragment stands for both.
    fn is_kept(self, operation: Operation, owner: Polygons) -> bool {
        let is_subject = owner == Polygons::SUBJECT;
        match (operation, self) {
            (Operation::Intersection, Self::Inside) | (Operation::Union, Self::Outside) => true,
            (Operation::Intersection | Operation::Union, Self::SameSide) => is_subject,
            (Operation::Difference, Self::Outside | Self::OtherSide) => is_subject,
            (Operation::Difference, Self::Inside) => !is_subject,
            _ => false,
        }
    }
}

/// Drops all fragments that do not bound the result, and turns those around that bound it from their other side.
///
/// Cost: two orientations for every end at an intersection; for a contour without one, an orientation to each edge of the
/// other polygon that its ray meets.
pub(crate) fn classify<S: SubPixel>(table: &mut [Vertex<S>], operation: Operation) {
    let mut start = 0;
    // Corners come first, contour by contour.
    while matches!(table.get(usize::from(start)), Some(vertex) if matches!(vertex.origin, Origin::Corner { .. })) {
        start = classify_contour(table, operation, start) + 1;
    }
    for fragment in 0..table.len() as VertexIndex {
        let is_reversed = operation == Operation::Difference && table.owner(fragment) == Polygons::CLIP;
        table.change(fragment, |vertex| {
            vertex.label = match (vertex.walk, vertex.label) {
                (ContourState::Excluded, _) => Label::Dropped,
                (_, Label::Along) if is_reversed => Label::Against,
                (_, Label::Against) if is_reversed => Label::Along,
                (_, label) => label,
            };
        });
    }
}

/// Excludes those fragments of the contour that do not bound the result. Returns its last corner.
fn classify_contour<S: SubPixel>(table: &mut [Vertex<S>], operation: Operation, start: VertexIndex) -> VertexIndex {
    let owner = table.owner(start);
    let (first, mut relation) =
        first_intersection(table, start).unwrap_or_else(|| (start, relation_of_corner(table, start)));
    let (mut index, mut last_corner) = (first, start);
    loop {
        relation = relation_at(table, index).unwrap_or(relation);
        if !relation.is_kept(operation, owner) {
            table.change(index, |vertex| vertex.walk = ContourState::Excluded);
        }
        let vertex = table.at(index);
        if matches!(vertex.origin, Origin::Corner { .. }) {
            last_corner = last_corner.max(index);
        }
        index = vertex.next;
        if index == first {
            return last_corner;
        }
    }
}

/// The first vertex of a contour where the other polygon's boundary passes, and how the fragment after it lies.
fn first_intersection<S: SubPixel>(table: &[Vertex<S>], start: VertexIndex) -> Option<(VertexIndex, Relation)> {
    let mut index = start;
    loop {
        if let Some(relation) = relation_at(table, index) {
            return Some((index, relation));
        }
        index = table.at(index).next;
        if index == start {
            return None;
        }
    }
}

/// How the beginning of a fragment lies; `None` where the other polygon's boundary does not pass its first vertex.
fn relation_at<S: SubPixel>(table: &[Vertex<S>], fragment: VertexIndex) -> Option<Relation> {
    let vertex = table.at(fragment);
    if vertex.neighbour == fragment {
        return None;
    }
    let (owner, direction) = (table.owner(fragment), table.direction(fragment));
    let (mut common, mut next): (Option<End>, Option<End>) = (None, None);
    table.visit_ends(fragment, &mut |end| {
        if table.owner(end.fragment) == owner || !is_kept(&table.at(end.fragment)) {
            return;
        }
        let is_first = |next: End| direction.order(end.direction, next.direction) == Ordering::Less;
        if end.direction.is_along(direction) {
            common = Some(end);
        } else if next.is_none_or(is_first) {
            next = Some(end);
        }
    });
    if let Some(end) = common {
        let is_same_side = leaves(table, &end) == (vertex.label == Label::Along);
        return Some(if is_same_side {
            Relation::SameSide
        } else {
            Relation::OtherSide
        });
    }
    next.map(|end| {
        if leaves(table, &end) {
            Relation::Outside
        } else {
            Relation::Inside
        }
    })
}

/// How a contour that the other polygon's boundary does not meet lies, from a ray to one of its corners.
fn relation_of_corner<S: SubPixel>(table: &[Vertex<S>], corner: VertexIndex) -> Relation {
    let (owner, point) = (table.owner(corner), table.at(corner).point);
    let crossed = (0..table.len() as VertexIndex)
        .take_while(|&other| matches!(table.at(other).origin, Origin::Corner { .. }))
        .filter(|&other| table.owner(other) != owner && table.segment(other).crosses_ray_to(point));
    if crossed.count() % 2 == 1 {
        Relation::Inside
    } else {
        Relation::Outside
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::clip::boolean::{siblings::weiler_atherton::orientation::orient, vertices::tests::comb_of_all_indices};

    /// As many corners as there are indices, and no other vertex behind them.
    #[test]
    fn a_full_table_of_corners_is_classified() {
        for (operation, label) in [
            (Operation::Union, Label::Along),
            (Operation::Difference, Label::Along),
            (Operation::Intersection, Label::Dropped),
        ] {
            let mut table = comb_of_all_indices();
            orient(&mut table);
            classify(&mut table, operation);
            assert!(table.iter().all(|vertex| vertex.label == label), "{operation:?}");
        }
    }
}
