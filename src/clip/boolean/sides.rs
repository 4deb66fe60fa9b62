//! Which polygons the two sides of a fragment are inside of, by the even-odd rule, wherever contours touch, overlap and cross.
//!
//! A contour is followed from a vertex whose inside is found by one test (a ray); at each later vertex, only the ends of edges
//! there change which polygons the sides are inside of. Of the other ends
//! around a vertex, those on the positive side of the passing contour toggle the inside of their polygon. An edge that
//! crosses has one end there and toggles; one that bounces has both or none. One that comes to run along the same line is on
//! neither side: it parts the two sides of the common fragments, and when it leaves, that decides which it was.

use crate::{
    clip::boolean::{
        direction::Direction,
        vertices::{Label, Origin, Polygons, Vertex, VertexIndex, Vertices},
    },
    geometry::SubPixel,
};

/// Gives every fragment the label that `label` finds for it: it is asked with the polygons that the positive side of the fragment
/// is inside of. Pieces of one contour come one after another.
///
/// Cost: the orientation of each contour's first corner to all edges that its ray meets, and at every vertex two
/// orientations an end.
pub(crate) fn label_fragments<S: SubPixel>(
    table: &mut [Vertex<S>],
    label: impl Fn(&[Vertex<S>], VertexIndex, Polygons) -> Label,
) {
    for corner in 0..table.len() as VertexIndex {
        let vertex = table.at(corner);
        if !matches!(vertex.origin, Origin::Corner { .. }) {
            // Corners come first.
            return;
        }
        if vertex.label == Label::Unknown {
            label_contour(table, &label, corner);
        }
    }
}

fn label_contour<S: SubPixel>(
    table: &mut [Vertex<S>],
    label: &impl Fn(&[Vertex<S>], VertexIndex, Polygons) -> Label,
    start: VertexIndex,
) {
    let mut inside = inside_at(table, start);
    let mut index = start;
    loop {
        let label = label(table, index, inside);
        table.change(index, |vertex| vertex.label = label);
        index = table.at(index).next;
        if index == start {
            return;
        }
        let vertex = table.at(index);
        if vertex.neighbour != index {
            let back = table.ending(vertex.previous).direction;
            inside = inside.toggled(toggles(table, index, table.direction(index), back));
        }
    }
}

/// The polygons that the positive side of the fragment is inside of, at a corner. Even-odd rule.
fn inside_at<S: SubPixel>(table: &[Vertex<S>], corner: VertexIndex) -> Polygons {
    let point = table.at(corner).point;
    let at_left = (0..table.len() as VertexIndex)
        .map_while(|other| matches!(table.at(other).origin, Origin::Corner { .. }).then_some(other))
        .filter(|&other| table.segment(other).crosses_ray_to(point))
        .fold(Polygons::NEITHER, |inside, other| inside.toggled(table.owner(other)));
    // From the ray on to the fragment, and across it and all that lie on it.
    let direction = table.direction(corner);
    at_left
        .toggled(toggles(table, corner, Direction::LEFT, direction))
        .toggled(common(table, corner, direction).0)
}

/// The polygons whose inside changes between two directions around a point, positive turn, without the two themselves.
fn toggles<S: SubPixel>(table: &[Vertex<S>], index: VertexIndex, from: Direction, to: Direction) -> Polygons {
    let mut all = Polygons::NEITHER;
    table.visit_ends(index, &mut |end| {
        if from.passes(end.direction, to) {
            all = all.toggled(table.owner(end.fragment));
        }
    });
    all
}

/// The polygons whose inside changes across all fragments in one direction, and the first of these fragments.
pub(crate) fn common<S: SubPixel>(
    table: &[Vertex<S>],
    index: VertexIndex,
    direction: Direction,
) -> (Polygons, VertexIndex) {
    let (mut all, mut first) = (Polygons::NEITHER, VertexIndex::MAX);
    table.visit_ends(index, &mut |end| {
        if end.direction.is_along(direction) {
            all = all.toggled(table.owner(end.fragment));
            first = first.min(end.fragment);
        }
    });
    (all, first)
}
