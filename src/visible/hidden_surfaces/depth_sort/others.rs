//! The faces that parts of faces are compared with in a row.

use crate::{
    geometry::Window,
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        active_face::ActiveFace, depth_plane::DepthPlane, face_table::FaceTable, hidden_surfaces::placed::face_from_row,
    },
};

use super::{
    pairs::{Extents, Relation, comes_first},
    planes_in_row::PlanesInRow,
    waiting::{MOST_CONDITIONS, PartConditions},
};

/// A face in a row, which another face is compared with.
#[derive(Copy, Clone)]
struct Other {
    /// The other face and this one.
    nodes: [u16; 2],
    row: i32,
    plane: DepthPlane,
    /// No columns where the face does not cover the row.
    span: [i32; 2],
    /// Whether the other face is seen where both are as near.
    is_first: bool,
}

/// The faces that were asked for last, set up for the row in which they were.
pub(super) struct Others {
    faces: [Other; MOST_CONDITIONS],
    /// The one that is overwritten next.
    oldest: usize,
}

/// A face in the current row, columns of that row, and the row.
pub(super) type InRow<'f, S, H> = (&'f ActiveFace<S, H>, [i32; 2], i32);

impl Others {
    /// No faces.
    pub(super) const fn new() -> Self {
        let none = Other {
            nodes: [0; 2],
            row: i32::MIN,
            plane: DepthPlane::ZERO,
            span: [0; 2],
            is_first: false,
        };
        Self {
            faces: [none; MOST_CONDITIONS],
            oldest: 0,
        }
    }

    /// Whether all conditions of a face hold at the first of some columns, and the first column after it where that may be
    /// different.
    pub(super) fn conditions_hold<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        window: &Window,
        conditions: &PartConditions,
        (face, [column, end], row): InRow<'_, S, H>,
        pixels: &mut u32,
    ) -> (bool, i32) {
        let mut until = end;
        for condition in conditions.iter() {
            let in_row = (face, [column, end], row);
            let (relation, end) = self.relation(faces, window, condition.other, in_row, pixels);
            if (relation == Some(Relation::InFront)) != condition.is_in_front {
                return (false, end);
            }
            until = until.min(end);
        }
        (true, until)
    }

    /// Whether a face is in front of the one of a node at the first of some columns, or behind it; `None` where that one does
    /// not cover the pixel. Also returns the first column after it where that may be different.
    pub(super) fn relation<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        window: &Window,
        node: u16,
        (face, [column, end], row): InRow<'_, S, H>,
        pixels: &mut u32,
    ) -> (Option<Relation>, i32) {
        let other = self.find(faces, [face.node, node], [window.left, row]);
        let [start, other_end] = other.span;
        if column < start {
            return (None, start.min(end));
        }
        if column >= other_end {
            return (None, end);
        }
        let planes = PlanesInRow::new([&face.plane, &other.plane], row, other.is_first);
        let (is_in_front, until) = planes.run::<D>([column, end.min(other_end)], pixels);
        let relation = if is_in_front {
            Relation::InFront
        } else {
            Relation::Behind
        };
        (Some(relation), until)
    }

    /// The second of two faces in a row, set up if it is not there; columns count from a column.
    fn find<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        nodes: [u16; 2],
        at: [i32; 2],
    ) -> Other {
        let [_, row] = at;
        let is_there = |other: &&Other| other.nodes == nodes && other.row == row;
        if let Some(other) = self.faces.iter().find(is_there) {
            return *other;
        }
        let other = Other::new(faces, nodes, at);
        if let Some(slot) = self.faces.get_mut(self.oldest) {
            *slot = other;
        }
        self.oldest = (self.oldest + 1) % MOST_CONDITIONS;
        other
    }
}

impl Other {
    fn new<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        faces: &impl FaceTable<S, D, H>,
        nodes: [u16; 2],
        at: [i32; 2],
    ) -> Self {
        let [_, row] = at;
        let [face, other] = nodes.map(|node| Extents::of(faces, node));
        let is_first = face
            .zip(other)
            .is_some_and(|(face, other)| comes_first(faces, &face, &other));
        let placed = face_from_row(faces, nodes[1], at).filter(|(_, first_row)| *first_row == row);
        let (plane, span) = match &placed {
            Some((face, _)) => (face.plane, face.span()),
            None => (DepthPlane::ZERO, [0; 2]),
        };
        Self {
            nodes,
            row,
            plane,
            span,
            is_first,
        }
    }
}
