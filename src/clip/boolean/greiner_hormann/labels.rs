//! The second phase: on which sides of each fragment the result lies.
//!
//! Greiner and Hormann follow a contour and toggle "inside" at each intersection. The toggling is that of
//! [`sides`](crate::clip::boolean::sides), which reads Foster, Hormann and Popa's labels off the order of directions around a
//! vertex; so crossings are delayed by themselves, and touching contours of one polygon need no rule of their own. What is
//! decided here is which sides the operation keeps.

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
        fragment_label(table, operation, fragment, inside)
    });
}

/// `inside` is what the positive side is inside of.
fn fragment_label<S: SubPixel>(
    table: &[Vertex<S>],
    operation: Operation,
    fragment: VertexIndex,
    inside: Polygons,
) -> Label {
    let (common, first) = common(table, fragment, table.direction(fragment));
    let beyond = inside.toggled(common);
    match (operation.keeps(inside), operation.keeps(beyond)) {
        // Of fragments between the same points, one stands for all.
        _ if first != fragment => Label::Dropped,
        (true, false) => Label::Along,
        (false, true) => Label::Against,
        _ => Label::Dropped,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::clip::boolean::vertices::tests::comb_of_all_indices;

    /// As many corners as there are indices, and no other vertex behind them.
    #[test]
    fn a_full_table_of_corners_is_labelled() {
        let mut table = comb_of_all_indices();
        label(&mut table, Operation::Union);
        assert!(table.iter().all(|vertex| vertex.label == Label::Along));
    }
}
