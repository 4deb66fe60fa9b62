//! The line in which two faces penetrate each other.
//!
//! Each face crosses the plane of the other one with two of its sides, and pierces it there. The four points lie on one line, that
//! of both planes, and what is between the middle two is in both faces.
//!
//! ```text
//!       one face       +-----------+           On the line of both planes:
//!                     /     1----2-+--3             1    2    3    4
//!                    /       ////  /    4           one: 1 to 3, the other: 2 to 4
//!                   +-----------+                   both: 2 to 3
//! ```
//!
//! Guarantees: two faces that have a side get the same point where it pierces a third one, so that the line goes on from face to
//! face, to the unit. Faces that touch within the tolerance with which faces hide have no line. Cost: how far six corners are from a
//! plane, and four points, two products of 64 bits each.
//!
//! Source: the overlap of two intervals on the line of both planes: Möller 1997, "A fast triangle-triangle intersection test".

use crate::{
    view::DepthWidth,
    visible::hidden_lines::{
        hiding::{HidingFace, narrowed, zero_between},
        line_table::LinePoint,
        parts::at,
    },
};

/// The ends of the line in which two faces penetrate each other, each given by its corners; `None` where they do not, or where all
/// corners of both are so near the plane of the other one that they touch within the tolerance.
pub(super) fn junction<D: DepthWidth>([one, other]: [[LinePoint; 3]; 2]) -> Option<[LinePoint; 2]> {
    let (plane, other_plane) = (HidingFace::new(one)?, HidingFace::new(other)?);
    let (behind, other_behind) = (
        one.map(|corner| other_plane.behind(corner)),
        other.map(|corner| plane.behind(corner)),
    );
    let (first, second) = (pierced(one, behind)?, pierced(other, other_behind)?);
    let touches = |behind: [i128; 3], face: &HidingFace| {
        let tolerance = face.tolerance::<D>();
        behind.iter().all(|behind| behind.abs() <= tolerance)
    };
    if touches(behind, &other_plane) && touches(other_behind, &plane) {
        return None;
    }
    common_part(first, second)
}

/// The two points where the sides of a face pierce a plane, given how far each corner is behind it; `None` where all corners
/// are on one side. A corner in the plane counts as behind it.
fn pierced(corners: [LinePoint; 3], behind: [i128; 3]) -> Option<[LinePoint; 2]> {
    let ([a, b, c], [at_a, at_b, at_c]) = (corners, behind);
    let mut points = [(a, at_a, b, at_b), (b, at_b, c, at_c), (c, at_c, a, at_a)]
        .into_iter()
        .filter(|(_, at_from, _, at_to)| (*at_from < 0) != (*at_to < 0))
        .map(|(from, at_from, to, at_to)| {
            // In one direction for both faces that have the side, so that both have the same point.
            if at_from < 0 {
                at(&[from, to], zero_between(narrowed([at_from, at_to])))
            } else {
                at(&[to, from], zero_between(narrowed([at_to, at_from])))
            }
        });
    Some([points.next()?, points.next()?])
}

/// What two parts of one line have in common, along the axis on which the longer one is longest.
fn common_part(one: [LinePoint; 2], other: [LinePoint; 2]) -> Option<[LinePoint; 2]> {
    let [[a, b], [c, d]] = [one, other];
    let width = (b.x - a.x).abs().max((d.x - c.x).abs());
    let height = (b.y - a.y).abs().max((d.y - c.y).abs());
    let along = |point: LinePoint| if width >= height { point.x } else { point.y };
    let ascending = |[from, to]: [LinePoint; 2]| {
        if along(from) <= along(to) {
            [from, to]
        } else {
            [to, from]
        }
    };
    let ([start, end], [other_start, other_end]) = (ascending(one), ascending(other));
    let start = if along(start) < along(other_start) {
        other_start
    } else {
        start
    };
    let end = if along(other_end) < along(end) { other_end } else { end };
    (along(start) < along(end)).then_some([start, end])
}
