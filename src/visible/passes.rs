//! Rows that more faces cross than there are slots for: they are drawn in passes, each with as many faces as fit.
//!
//! ```text
//!     faces that cross the row     A B C   D E F   G          with three slots: three passes over one row of depths,
//!                                  pass 1  pass 2  pass 3     which is cleared once
//! ```
//!
//! The depth row takes faces in any order, so that it does not matter which of them are there at the same time. Where a
//! fragment is as near as the one that is there, faces of earlier passes are in no slot any more: all faces of the table are
//! asked which of them comes first in the order of the models.
//!
//! Guarantees: each face that crosses a row comes once, and of equally near fragments the picture has the first one.

use core::num::Wrapping;

use crate::{
    shade::{Planes, Shading},
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{
        active_face::{ActiveFace, NOTHING, Surroundings},
        attribute_planes::set_up_attributes,
        edge::row_after,
        face_table::{FaceTable, NONE, corners_from_top, set_up_rest},
        shaded_span::is_seen,
        sides::Sides,
    },
};

/// How far the rows of a frame are drawn, some of which more faces cross than the active list has slots for.
#[derive(Debug)]
pub(super) struct Passes {
    /// Whether the frame has rows with more faces than slots.
    pub(super) are_needed: bool,
    /// Rows of the frame that took more than one pass.
    pub(super) rows: u32,
    /// The row in which the next face of the row that is drawn begins, and that face.
    pub(super) next: (i32, u16),
    /// A row and how many faces cross it.
    crossing: (i32, Wrapping<u16>),
}

impl Passes {
    pub(super) const NONE: Self = Self {
        are_needed: false,
        rows: 0,
        next: (0, 0),
        crossing: (0, Wrapping(0)),
    };

    /// Begins a frame.
    pub(super) fn restart(&mut self, are_needed: bool) {
        *self = Self {
            are_needed,
            crossing: (i32::MIN, Wrapping(0)),
            ..Self::NONE
        };
    }

    /// Counts a row that takes more than one pass, modulo 2^32.
    #[inline]
    pub(super) fn count_row(&mut self) {
        self.rows = self.rows.wrapping_add(1);
    }

    /// How many faces cross a row. Cost: a sum over the rows above it, of which only the last is added where rows come in
    /// order.
    pub(super) fn crossing<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        row: i32,
    ) -> usize {
        let top = faces.viewport().top;
        let (counted, crossing) = self.crossing;
        let (first, mut crossing) = if (top..=row).contains(&counted) {
            (counted + 1, crossing)
        } else {
            (top, Wrapping(0))
        };
        for row in first..row + 1 {
            crossing += faces.change(row);
        }
        self.crossing = (row, crossing);
        crossing.0.into()
    }

    /// Faces from the first row on.
    pub(super) fn from_top<S: ScreenPrecision, D: DepthWidth, H: Shading>(faces: &impl FaceTable<S, D, H>) -> Self {
        let top = faces.viewport().top;
        Self {
            next: (top, faces.first_in_row(top)),
            ..Self::NONE
        }
    }

    /// The next face that crosses a row.
    pub(super) fn next_crossing<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        row: i32,
    ) -> Option<u16> {
        loop {
            let node = self.next_face(faces, row)?;
            // A face that is not drawn crosses no row.
            let crosses = |[a, b, c]: [&ScreenVertex<S, D>; 3]| {
                row < row_after::<S>(a.y_units().max(b.y_units()).max(c.y_units()))
            };
            if faces.face(node).is_some_and(|(corners, _)| crosses(corners)) {
                return Some(node);
            }
        }
    }

    /// The next face that begins in a row or above it.
    fn next_face<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        row: i32,
    ) -> Option<u16> {
        let (mut bucket, mut node) = self.next;
        while node == NONE {
            if bucket >= row {
                self.next = (bucket, NONE);
                return None;
            }
            bucket += 1;
            node = faces.first_in_row(bucket);
        }
        self.next = (bucket, faces.next(node));
        Some(node)
    }
}

/// What faces are set up for in a row that begins at a column: with depth planes.
pub(super) fn surroundings<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    first_column: i32,
) -> Surroundings<'_> {
    Surroundings {
        viewport: faces.viewport(),
        first_column,
        without_plane: false,
        sample: (),
    }
}

/// A face of the table that is in no slot, as it is in its first row.
#[cold]
#[inline(never)]
pub(super) fn face_in_first_row<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
    surroundings: &Surroundings<'_>,
) -> Option<ActiveFace<S, H>> {
    let ([a, b, c], word) = faces.face(node)?;
    let mut face = ActiveFace::EMPTY;
    (face.node, face.word) = (node, word);
    let left_over = if H::Attributes::VARY {
        set_up_attributes(
            &mut face,
            faces,
            [a, b, c],
            surroundings,
            ActiveFace::set_up_small_edges,
        )
    } else {
        face.set_up_small(a, b, c, surroundings)
    };
    if left_over != NOTHING {
        set_up_rest(&mut face, faces, left_over, surroundings);
    }
    face.set_translucent(faces.is_translucent(node));
    Some(face)
}

/// Hands over the faces of the table that cross a row, which begins at a column, as they are in it: those of them whose nodes
/// are asked for.
pub(super) fn for_each_crossing<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    [first_column, row]: [i32; 2],
    is_asked_for: &dyn Fn(u16) -> bool,
    visit: &mut dyn FnMut(&ActiveFace<S, H>),
) {
    let surroundings = surroundings(faces, first_column);
    let mut all = Passes::from_top(faces);
    while let Some(node) = all.next_crossing(faces, row) {
        let (true, Some(corners)) = (is_asked_for(node), corners_from_top(faces, node)) else {
            continue;
        };
        if let Some(mut face) = face_in_first_row(faces, node, &surroundings) {
            if face.enter(&Sides::of(corners, first_column), row) {
                visit(&face);
            }
        }
    }
}

/// Whether no other face of the table that has the same depth at a pixel which it covers comes before a face in the order of
/// the models; the parts of one face come in the order of the table.
#[cold]
#[inline(never)]
pub(super) fn comes_first_of_all<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    face: &ActiveFace<S, H>,
    first_column: i32,
    [column, row]: [i32; 2],
) -> bool {
    let surroundings = surroundings(faces, first_column);
    let depth = |face: &ActiveFace<S, H>| D::from_interpolated(face.plane.at(column - first_column, row).0);
    let order = i32::from(faces.order(face.node));
    let (mut all, mut is_behind) = (Passes::from_top(faces), false);
    while let Some(node) = all.next_crossing(faces, row) {
        is_behind |= node == face.node;
        if i32::from(faces.order(node)) >= order + i32::from(!is_behind) {
            continue;
        }
        let Some(other) = face_in_first_row(faces, node, &surroundings).filter(|other| depth(other) == depth(face))
        else {
            continue;
        };
        if is_seen(faces, &other, [column, row], first_column) {
            return false;
        }
    }
    true
}
