//! Rows in which no face hides another: their faces are painted in any order.
//!
//! ```text
//!     front faces of a convex solid           two solids: from this row on faces have columns in common
//!
//!     .....aaaaabbbbbcccc.....                ...aaaabbbb....ccccdd...
//!     ...aaaaaaabbbbbbccccc...                ...aaaaabbbccccccdddd...   <- the rest of the window is sorted
//!     ..aaaaaaddddddddeeecccc.                ..aaaaaaabccccceeeeedd..
//! ```
//!
//! The active faces are kept in the order of columns, as the depth row keeps them in rows that need no depths: one comparison
//! for each span says whether it begins before the one to its left has ended.
//!
//! Guarantees: of the rows before the one that is returned each face has its pixels, and no two faces have one in common. Cost:
//! that of the depth row in rows without depths.

use crate::{
    clip::convex::CutAttributes,
    geometry::Window,
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        active_faces::ActiveList,
        face_table::{FaceTable, NONE},
        painter::Painter,
    },
};

/// Paints the rows of a window from the top, up to the first one in which faces have a column in common. Returns that row, or
/// the one below the window.
pub(super) fn paint_disjoint_rows<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    window: &Window,
    painter: &mut impl Painter<S, H>,
) -> i32 {
    // Attributes that are divided by the depth need planes, which faces in the order of columns do not have. Rows of looks with
    // holes or translucent faces are not in that order.
    if H::Attributes::NEED_DEPTH || H::BLENDS || H::HAS_HOLES {
        return window.top;
    }
    let Some(list) = painter.active() else {
        return window.top;
    };
    // A list that has no room for all faces of some row.
    if list.needs_passes() || window.top >= window.bottom {
        return window.top;
    }
    bring_to_row(list, faces, [window.left, window.top]);
    let mut row = window.top;
    let next_row = loop {
        if !paint_row(faces, row, painter) {
            // Some faces were stepped to the next row, others were not.
            break i32::MIN;
        }
        row += 1;
        if row == window.bottom {
            break row;
        }
        if let Some(list) = painter.active() {
            begin_faces(list, faces, row);
        }
    };
    if let Some(list) = painter.active() {
        list.next_row = next_row;
    }
    row
}

/// Paints a row in which the active list is. `false` where faces have a column in common: some were painted then.
fn paint_row<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    row: i32,
    painter: &mut impl Painter<S, H>,
) -> bool {
    if painter.disjoint_row(row) {
        return true;
    }
    // Thin spans may have changed places without overlapping: in an order that begins with this row, they do not.
    if let Some(list) = painter.active() {
        list.enter_in_order(faces, row);
    }
    painter.disjoint_row(row)
}

/// Brings the active list to a row that begins at a column, with faces in the order of columns.
fn bring_to_row<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    list: &mut ActiveList<S, H>,
    faces: &impl FaceTable<S, D, H>,
    [left, row]: [i32; 2],
) {
    if list.disjoint && list.next_row == row && list.first_column == left {
        begin_faces(list, faces, row);
    } else {
        list.first_column = left;
        list.enter_in_order(faces, row);
    }
}

/// Adds the faces that begin in a row to an active list in the order of columns.
#[inline]
fn begin_faces<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    list: &mut ActiveList<S, H>,
    faces: &impl FaceTable<S, D, H>,
    row: i32,
) {
    let first = faces.first_in_row(row);
    if first != NONE {
        list.begin_faces(faces, first, true);
    }
}
