//! The second phase: every contour gets the direction that Weiler and Atherton start from, with its polygon on the positive
//! side.
//!
//! They ask for outer contours that run one way round and holes that run the other way. A contour that crosses itself runs
//! both ways: so it is the fragments between vertices that get a direction, by the even-odd rule of their own polygon alone.
//! Of fragments of one polygon between the same points, one stands for an odd number of them, and none for an even number.

use crate::{
    clip::boolean::{
        sides::label_fragments,
        vertices::{Label, Polygons, Vertex, VertexIndex, Vertices},
    },
    geometry::SubPixel,
};

/// Labels every fragment by the sides on which its own polygon lies.
///
/// Cost: that of [`label_fragments`], and for every fragment two orientations for each end at its first vertex.
pub(crate) fn orient<S: SubPixel>(table: &mut [Vertex<S>]) {
    label_fragments(table, direction_label);
}

/// The label of a fragment whose positive side is inside of these polygons.
fn direction_label<S: SubPixel>(table: &[Vertex<S>], fragment: VertexIndex, inside: Polygons) -> Label {
    let (owner, direction) = (table.owner(fragment), table.direction(fragment));
    let (mut is_odd, mut first) = (false, VertexIndex::MAX);
    table.visit_ends(fragment, &mut |end| {
        if table.owner(end.fragment) == owner && end.direction.is_along(direction) {
            is_odd = !is_odd;
            first = first.min(end.fragment);
        }
    });
    match inside.contains(owner) {
        _ if !is_odd || first != fragment => Label::Dropped,
        true => Label::Along,
        false => Label::Against,
    }
}
