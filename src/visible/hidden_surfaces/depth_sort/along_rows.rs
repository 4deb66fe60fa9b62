//! Two faces row by row: whether one of them is in front of the other one, by stored depths.

use crate::{
    geometry::Window,
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{active_face::ActiveFace, face_table::FaceTable, hidden_surfaces::placed::face_from_row},
};

use super::{
    others::Others,
    pairs::{Extents, Relation},
    planes_in_row::PlanesInRow,
    waiting::PartConditions,
};

/// Where an entry of the list is in front of another one.
#[derive(Debug, Copy, Clone, Default)]
struct Found {
    is_in_front: bool,
    is_behind: bool,
}

impl Found {
    fn relation(self) -> Relation {
        match (self.is_in_front, self.is_behind) {
            (true, true) => Relation::Penetrates,
            (true, false) => Relation::InFront,
            (false, _) => Relation::Behind,
        }
    }
}

/// Whether an entry is in front of another one in pixels of a window that both have, in each row of their faces. `is_first` says
/// that the first one is seen where both are as near. Adds to the number of pixels that are compared one by one.
pub(super) fn relation_along_rows<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    window: &Window,
    pair: [(&Extents<'_, S, D>, PartConditions); 2],
    is_first: bool,
    pixels: &mut u32,
) -> Relation {
    let [(face, conditions), (other, of_other)] = pair;
    let [[top, bottom], [other_top, other_bottom]] = [face, other].map(Extents::rows);
    let (top, bottom) = (
        top.max(other_top).max(window.top),
        bottom.min(other_bottom).min(window.bottom),
    );
    let [face, other] = [face, other].map(|face| face_from_row(faces, face.node, [window.left, top]));
    let (Some((mut face, _)), Some((mut other, _))) = (face, other) else {
        return Relation::Behind;
    };
    let (mut others, mut found) = (Others::new(), Found::default());
    for row in top..bottom {
        let [mut column, end] = common_columns([&face, &other], window);
        let planes = PlanesInRow::new([&face.plane, &other.plane], row, is_first);
        while column < end {
            let (is_in_front, mut until) = planes.run::<D>([column, end], pixels);
            let mut are_there = true;
            for (face, conditions) in [(&face, &conditions), (&other, &of_other)] {
                let in_row = (face, [column, until], row);
                let (is_there, end) = others.conditions_hold(faces, window, conditions, in_row, pixels);
                are_there &= is_there;
                until = end;
            }
            found.is_in_front |= are_there && is_in_front;
            found.is_behind |= are_there && !is_in_front;
            if found.relation() == Relation::Penetrates {
                return Relation::Penetrates;
            }
            column = until;
        }
        face.next_span();
        other.next_span();
        if !(face.leave_row(row) && other.leave_row(row)) {
            break;
        }
    }
    found.relation()
}

/// The columns of a window that two faces both cover in a row.
fn common_columns<S: ScreenPrecision, H: Shading>(faces: [&ActiveFace<S, H>; 2], window: &Window) -> [i32; 2] {
    let width = window.width() as i32;
    let [[start, end], [other_start, other_end]] = faces.map(ActiveFace::span);
    [start.max(other_start).max(0), end.min(other_end).min(width)]
}
