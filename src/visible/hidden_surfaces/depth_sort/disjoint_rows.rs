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
    // A list that has no room for all faces of some row.
    if painter.active().is_none_or(|list| list.needs_passes()) {
        return window.top;
    }
    for row in window.top..window.bottom {
        if !paint_row(faces, [window.left, row], painter) {
            if let Some(list) = painter.active() {
                // Some faces were stepped to the next row, others were not.
                list.next_row = i32::MIN;
            }
            return row;
        }
    }
    window.bottom
}

/// Paints a row that begins at a column. `false` where faces have a column in common: some were painted then.
fn paint_row<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    at: [i32; 2],
    painter: &mut impl Painter<S, H>,
) -> bool {
    let [_, row] = at;
    if let Some(list) = painter.active() {
        bring_to_row(list, faces, at);
    }
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
        let first = faces.first_in_row(row);
        if first != NONE {
            list.begin_faces(faces, first, true);
        }
    } else {
        list.first_column = left;
        list.enter_in_order(faces, row);
    }
    list.next_row = row + 1;
}
