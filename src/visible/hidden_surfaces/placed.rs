//! The faces of a table as they are in a row or in a window, for methods that keep no list of active faces.

use core::ops::Range;

use crate::{
    geometry::Window,
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        active_face::ActiveFace,
        face_table::{FaceTable, NONE, corners_from_top},
        painter::Painter,
        passes::{Passes, face_in_first_row, surroundings},
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

/// Whether a depth of a face hides that of another one: it is nearer, or as near and that of the first face in the order of
/// models.
#[inline]
pub(super) fn is_nearer<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    (depth, node): (D, u16),
    (other_depth, other): (D, u16),
) -> bool {
    // Most often nearer or farther: the order of faces is seldom asked for.
    depth > other_depth || (depth == other_depth && faces.order(node) < faces.order(other))
}

/// Keeps of some pixels of a row that a face covers its depth and its node where it is seen, given the column of the first one,
/// the row, and the depths and the nodes that are there.
pub(super) fn keep_nearer<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    face: &ActiveFace<S, H>,
    [column, row]: [i32; 2],
    (depths, nodes): (&mut [D], &mut [u16]),
) {
    let mut depth = face.plane.at(column, row);
    for (stored, node) in depths.iter_mut().zip(nodes) {
        let candidate = D::from_interpolated(depth.0);
        if is_nearer(faces, (candidate, face.node), (*stored, *node)) {
            (*stored, *node) = (candidate, face.node);
        }
        depth += face.plane.per_column;
    }
}

/// The face that is seen in a column of a row, by a look at all faces, or [`NONE`]. `at` are the first column of the row, from
/// which the column counts, and the row; `is_covered` tells whether a face covers the pixel.
pub(super) fn nearest_of_all<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    (at, column): ([i32; 2], i32),
    mut is_covered: impl FnMut(u16) -> bool,
) -> u16 {
    let [_, row] = at;
    let mut seen = (D::FARTHEST, NONE);
    let mut all = Passes::from_top(faces);
    while let Some(node) = all.next_crossing(faces, row) {
        if is_covered(node) {
            seen = nearer_of(faces, node, (at, column), seen);
        }
    }
    let (_, node) = seen;
    node
}

/// Of a face that covers a pixel, and the depth and the face that are seen there without it, what is nearer. `at` are the first
/// column of the row, from which the column counts, and the row.
pub(super) fn nearer_of<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
    (at, column): ([i32; 2], i32),
    seen: (D, u16),
) -> (D, u16) {
    let [_, row] = at;
    let Some((face, _)) = face_from_row(faces, node, at) else {
        return seen;
    };
    let candidate = (D::from_interpolated(face.plane.at(column, row).0), node);
    if is_nearer(faces, candidate, seen) {
        candidate
    } else {
        seen
    }
}

/// Hands over pixels of a row in runs of the same face: of each of the columns from left to right the node of its face, or
/// [`NONE`]. `at` are the first column of the row, from which columns count, and the row.
pub(super) fn paint_row<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    painter: &mut impl Painter<S, H>,
    faces: &impl FaceTable<S, D, H>,
    at: [i32; 2],
    columns: Range<i32>,
    mut node_of: impl FnMut(i32) -> u16,
) {
    paint_row_reporting(painter, faces, at, columns, |_, column| node_of(column));
}

/// [`paint_row`] by a closure that tells the painter what it does to find the node of a column.
pub(super) fn paint_row_reporting<S: ScreenPrecision, D: DepthWidth, H: Shading, P: Painter<S, H>>(
    painter: &mut P,
    faces: &impl FaceTable<S, D, H>,
    at: [i32; 2],
    columns: Range<i32>,
    mut node_of: impl FnMut(&mut P, i32) -> u16,
) {
    let [_, row] = at;
    let paint = |painter: &mut P, node: u16, start: i32, end: i32| {
        if node == NONE {
            return;
        }
        if let Some((face, _)) = face_from_row(faces, node, at) {
            painter.span(&face, row, [start, end]);
        }
    };
    let (mut start, mut seen) = (columns.start, NONE);
    for column in columns.clone() {
        let node = node_of(painter, column);
        if node != seen {
            paint(painter, seen, start, column);
            (start, seen) = (column, node);
        }
    }
    paint(painter, seen, start, columns.end);
}

/// [`paint_row`] of nodes in a table, from a column on.
pub(super) fn paint_nodes<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    painter: &mut impl Painter<S, H>,
    faces: &impl FaceTable<S, D, H>,
    at: [i32; 2],
    column: i32,
    nodes: &[u16],
) {
    let mut rest = nodes.iter();
    paint_row(painter, faces, at, column..column + nodes.len() as i32, |_| {
        rest.next().copied().unwrap_or(NONE)
    });
}
