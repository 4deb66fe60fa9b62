//! The second phase: on which sides of each fragment the result lies.
//!
//! What is inside is followed along a contour, as Greiner and Hormann do: one test where it starts, then only what its
//! vertices say. Foster, Hormann and Popa's labels are read off the order of directions around a vertex: of the other
//! ends there, those on the positive side of the passing contour toggle the inside of their polygon. An edge that
//! crosses has one end there and toggles; one that bounces has both or none. One that comes to run along the same line
//! is on neither side: it parts the two sides of the common fragments, and when it leaves, that decides which it was. So
//! crossings are delayed by themselves, and touching contours of one polygon need no rule of their own.

use crate::{
    clip::boolean::{
        operation::Operation,
        sides::{common, label_fragments},
        vertices::{Label, Polygons, Vertex, VertexIndex, Vertices},
    },
    geometry::SubPixel,
};

/// Labels every fragment.
///
/// Cost: that of [`label_fragments`], and for every fragment two orientations for each end at its first vertex.
pub(crate) fn label<S: SubPixel>(table: &mut [Vertex<S>], operation: Operation) {
    label_fragments(table, |table, fragment, inside| {
        piece_label(table, operation, fragment, inside)
    });
}

/// `inside` is what the positive side is inside of.
fn piece_label<S: SubPixel>(
    table: &[Vertex<S>],
    operation: Operation,
    fragment: VertexIndex,
    inside: Polygons,
) -> Label {
    let (common, first) = common(table, fragment, table.direction(fragment));
    let beyond = inside.toggled(common);
    match (operation.keeps(inside), operation.keeps(beyond)) {
        // Of fragments on the same place, one stands for all.
        _ if first != fragment => Label::Dropped,
        (true, false) => Label::Along,
        (false, true) => Label::Against,
        _ => Label::Dropped,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::clip::boolean::vertices::tests::comb_of_all_places;

    /// As many corners as there are places, and no other vertex behind them.
    #[test]
    fn a_full_table_of_corners_is_labelled() {
        let mut table = comb_of_all_places();
        label(&mut table, Operation::Union);
        assert!(table.iter().all(|vertex| vertex.label == Label::Along));
    }
}
