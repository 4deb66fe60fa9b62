//! The faces of a table as they are in a row or in a window, for methods that keep no list of active faces.

use crate::{
    geometry::Window,
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        active_face::ActiveFace,
        face_table::{FaceTable, NONE, corners_from_top},
        painter::Painter,
        passes::{face_in_first_row, surroundings},
        sides::Sides,
    },
};

/// Visits the nodes of all faces that begin above the lower side of a window, in the order of the rows in which they begin.
pub(super) fn for_each_node<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    window: &Window,
    mut visit: impl FnMut(u16),
) {
    for row in faces.viewport().top..window.bottom {
        let mut node = faces.first_in_row(row);
        while node != NONE {
            visit(node);
            node = faces.next(node);
        }
    }
}

/// A face as it is in the first of its rows that is not above a row, with that row; columns count from a column. `None` where
/// the face ends above.
pub(super) fn face_from_row<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
    [first_column, row]: [i32; 2],
) -> Option<(ActiveFace<S, H>, i32)> {
    let sides = Sides::of(corners_from_top(faces, node)?, first_column);
    let mut face = face_in_first_row(faces, node, &surroundings(faces, first_column))?;
    let first = sides.first_row::<S>();
    if first >= row {
        return Some((face, first));
    }
    face.enter(&sides, row).then_some((face, row))
}

/// Hands over the pixels of a row, in runs of the same face: of each pixel the node of its face, or [`NONE`].
pub(super) fn paint_row<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    painter: &mut impl Painter<S, H>,
    faces: &impl FaceTable<S, D, H>,
    at: [i32; 2],
    nodes: &[u16],
) {
    let [_, row] = at;
    let mut end = 0;
    for run in nodes.chunk_by(|one, other| one == other) {
        let start = end;
        end += run.len() as i32;
        let node = run.first().copied().filter(|node| *node != NONE);
        if let Some((face, _)) = node.and_then(|node| face_from_row(faces, node, at)) {
            painter.span(&face, row, [start, end]);
        }
    }
}
