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
//! are seen: the line is hidden elsewhere. Cost: a comparison of rectangles a pair of faces, and a look at all faces
//! an intersection.
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
        parts::{PartedLine, at},
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
                if let Some(found) = intersection.and_then(|other| intersection_of(table, &face, &other)) {
                    line(found);
                }
            }
        }
    }
}

/// The line in which two faces penetrate each other; `None` where they do not, or are of one model and have a corner in common.
///
/// Its ends are rounded: where the line runs along a side of one of the faces, it may lie beside it, behind the face that has the
/// side too and is less steep. The line is raised to the depth of that face.
pub(super) fn intersection_of<S, D, T>(table: &T, one: &LineFace, other: &LineFace) -> Option<PartedLine>
where
    S: ScreenPrecision,
    D: DepthWidth,
    T: LineTable<S, D>,
{
    if one.model == other.model && common_corners(one, other) > 0 {
        return None;
    }
    let ends = junction::<D>([one.corners, other.corners])?;
    let behind = [one, other].map(|face| behind_neighbours(table, face, ends));
    let raised = ends.map(|end| LinePoint {
        // Depths have 24 bits.
        depth: (end.depth + behind.into_iter().fold(0, i32::max)).min((1 << 24) - 1),
        ..end
    });
    Some(PartedLine {
        model: one.model.min(other.model),
        edge: None,
        ends: raised,
        kind: PartKind::Intersection,
    })
}

/// How many corners of one face are also corners of the other one, with the same position and depth on the screen.
fn common_corners(one: &LineFace, other: &LineFace) -> usize {
    one.corners
        .iter()
        .filter(|corner| other.corners.contains(corner))
        .count()
}

/// By how many units of depth a line that lies in a face has to be raised so that none of the face's neighbours, which have a side
/// of it, hides the line where its rounded ends put it over a neighbour. Neighbours that hide more of the line than what is within
/// a unit of the face do not count.
fn behind_neighbours<S, D, T>(table: &T, face: &LineFace, line: [LinePoint; 2]) -> i32
where
    S: ScreenPrecision,
    D: DepthWidth,
    T: LineTable<S, D>,
{
    let Some(plane) = HidingFace::new(face.corners) else {
        return 0;
    };
    let neighbours = table
        .faces()
        .filter(|other| other.is_seen && other.model == face.model && common_corners(face, other) == 2);
    let behind = neighbours.filter_map(|other| {
        let other = HidingFace::new(other.corners)?;
        let hidden = other.hidden::<D>(line)?.map(|parameter| at(&line, parameter));
        let is_beside = hidden.iter().all(|point| plane.is_beside(*point));
        is_beside.then(|| hidden.map(|point| other.units_behind(point)))
    });
    behind.flatten().fold(0, i32::max)
}
