//! The lines in which faces penetrate each other: edges that no mesh has.
//!
//! ```text
//!            /\                        Two triangles that penetrate each other have one segment in common. At each of its
//!           /  \                       ends, a side of one of them pierces the other one. Where a side pierces a plane
//!      ----x====x------                follows from how far its ends are before and behind it, and whether it does so
//!     |   /      \    |                within the triangle from the part of the side that is in the triangle on the
//!     |__/________\___|                screen.
//!       /__________\
//! ```
//!
//! Guarantees: faces that have a side in common are pierced or not by the same rule, so that the line goes on from face to face,
//! to the unit. Two faces penetrate each other where each has corners before the plane of the other one and behind it, by more
//! than the tolerance of [hiding](super::hiding). Both are seen: the line is hidden elsewhere. Cost: a comparison of rectangles a
//! pair of faces, and six tests of sides for those that may penetrate each other.
//!
//! Source: that solids which penetrate need new edges: Roberts 1963, "Machine Perception of Three-Dimensional Solids"; the
//! intersection of two triangles by the sides that pierce them: Möller 1997, "A fast triangle-triangle intersection test".

use crate::{
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::{
        face_box::FaceBox,
        hiding::{HidingFace, narrowed, zero_between},
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
                if let Some(found) = intersection.and_then(|other| intersection_of::<D>(&face, &other)) {
                    line(found);
                }
            }
        }
    }
}

/// The line in which two faces penetrate each other.
fn intersection_of<D: DepthWidth>(one: &LineFace, other: &LineFace) -> Option<PartedLine> {
    if one.model == other.model && one.corners.iter().any(|corner| other.corners.contains(corner)) {
        return None;
    }
    let faces = [HidingFace::new(one.corners)?, HidingFace::new(other.corners)?];
    let [first, second] = &faces;
    if !first.is_crossed_by::<D>(&other.corners) || !second.is_crossed_by::<D>(&one.corners) {
        return None;
    }
    let mut ends = None;
    for (face, corners) in [(first, other.corners), (second, one.corners)] {
        let [a, b, c] = corners;
        for side in [[a, b], [b, c], [c, a]] {
            if let Some(point) = pierced(face, side) {
                ends = Some(match ends {
                    None => [point; 2],
                    Some(known) => farthest_apart(known, point),
                });
            }
        }
    }
    Some(PartedLine {
        model: one.model.min(other.model),
        edge: None,
        ends: ends?,
        kind: PartKind::Intersection,
    })
}

/// Where a side of another face pierces a face.
fn pierced(face: &HidingFace, ends: [LinePoint; 2]) -> Option<LinePoint> {
    // Both faces at the side get the same point.
    let [from, to] = ends;
    let ends = if key(from) <= key(to) { ends } else { [to, from] };
    let values = narrowed(ends.map(|end| face.behind(end)));
    let [first, second] = values;
    if (first < 0) == (second < 0) {
        return None;
    }
    let [start, end] = face.within(ends)?;
    let parameter = zero_between(values);
    (start <= parameter && parameter <= end).then(|| at(&ends, parameter))
}

/// Of two points that may be the same, and a third one, the two ends of their segment.
fn farthest_apart([start, end]: [LinePoint; 2], point: LinePoint) -> [LinePoint; 2] {
    // Below 2^24.
    let apart = |one: LinePoint, other: LinePoint| (one.x - other.x).abs() + (one.y - other.y).abs();
    if apart(start, point) > apart(start, end) {
        [start, point]
    } else if apart(point, end) > apart(start, end) {
        [point, end]
    } else {
        [start, end]
    }
}

/// In the order of which the ends of a side are taken.
const fn key(point: LinePoint) -> (i32, i32, i32) {
    (point.x, point.y, point.depth)
}
