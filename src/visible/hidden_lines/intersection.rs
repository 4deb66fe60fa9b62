//! The lines in which the faces of a list penetrate each other: edges that no mesh has.
//!
//! ```text
//!            /\                        Faces come with the nearest first: those that follow the first one that lies behind all of
//!           /  \                       a face cannot meet it. Of the others, those whose rectangles on the screen meet its own are
//!      ----x====x------                asked for their junction.
//!     |   /      \    |
//!     |__/________\___|
//!       /__________\
//! ```
//!
//! Guarantees: each two faces that penetrate each other are found once, but for two of one model that have a corner in common. Both
//! are seen: the line is hidden elsewhere. Cost: a comparison of rectangles a pair of faces.
//!
//! Source: that solids which penetrate need new edges: Roberts 1963, "Machine Perception of Three-Dimensional Solids".

use crate::{
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::{
        face_box::FaceBox,
        hiding::HidingFace,
        junction::junction,
        line_part::PartKind,
        line_table::{LineFace, LinePoint, LineTable},
        parts::PartedLine,
    },
};

/// Finds the lines in which faces of a list penetrate each other, the nearest ones of which come first.
pub(super) fn for_each_intersection<S, D, T>(table: &T, faces: &[FaceBox], mut line: impl FnMut(PartedLine))
where
    S: ScreenPrecision,
    D: DepthWidth,
    T: LineTable<S, D>,
{
    let mut rest = faces;
    while let [near, others @ ..] = rest {
        rest = others;
        let Some(face) = table.face(usize::from(near.index)) else {
            continue;
        };
        let [a, b, c] = face.corners.map(|corner| corner.depth);
        let farthest = a.min(b).min(c);
        for other in others {
            if other.nearest < farthest {
                // This face and all that follow lie behind all of the first one.
                break;
            }
            if near.meets_face(other) {
                let intersection = table.face(usize::from(other.index));
                if let Some(found) = intersection.and_then(|other| intersection_of::<D>(&face, &other)) {
                    line(found);
                }
            }
        }
    }
}

/// The line in which two faces penetrate each other, as near as it may be by the rounding of its ends; `None` where they do not,
/// or are of one model and have a corner in common.
pub(super) fn intersection_of<D: DepthWidth>(one: &LineFace, other: &LineFace) -> Option<PartedLine> {
    if one.model == other.model && one.corners.iter().any(|corner| other.corners.contains(corner)) {
        return None;
    }
    let ends = junction::<D>([one.corners, other.corners])?;
    // Where the line leaves one of them, it may lie beside it by a rounded unit, over a neighbour that is less steep.
    let steep = [one, other].map(|face| HidingFace::new(face.corners));
    let raised = ends.map(|end| {
        let depths = steep.iter().flatten().map(|face| face.nearest_around(end));
        LinePoint {
            depth: depths.fold(end.depth, i32::max),
            ..end
        }
    });
    Some(PartedLine {
        model: one.model.min(other.model),
        edge: None,
        ends: raised,
        kind: PartKind::Intersection,
    })
}
