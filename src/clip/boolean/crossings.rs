//! The first phase: corners become vertices, and so does every point where two edges meet.

use core::cmp::Ordering;

use heapless::VecView;

use crate::{
    clip::{
        boolean::{
            operation::Operation,
            segment::{ExactSegment, Extent, Meeting},
            vertices::{Full, Origin, Polygons, Vertex, VertexIndex, Vertices, insert},
        },
        convex::convex_crossing::Fraction,
    },
    geometry::{InputError, SubPixel, SubPoint, TooSmall},
};

/// Makes vertices of two polygons and of all points where their edges meet, for one operation; those that cannot count for its
/// result are left out.
///
/// # Errors
/// [`InputError::OutOfDomain`]; [`InputError::TooSmall`] with a number of vertices that would do.
pub(crate) fn build<S: SubPixel>(
    vertices: &mut VecView<Vertex<S>>,
    subject: &[&[SubPoint<S>]],
    clip: &[&[SubPoint<S>]],
    operation: Operation,
) -> Result<(), InputError> {
    vertices.clear();
    check_domain(subject)?;
    check_domain(clip)?;
    let are_disjoint = !extent(subject).meets(&extent(clip));
    let (subject, clip): (&[&[_]], &[&[_]]) = match operation {
        Operation::Intersection if are_disjoint => return Ok(()),
        Operation::Difference if are_disjoint => (subject, &[]),
        _ => (subject, clip),
    };
    if add_vertices(vertices, subject, clip).is_err() {
        vertices.clear();
        return Err(InputError::TooSmall(TooSmall::ContourVertices(vertices_needed(
            subject, clip,
        ))));
    }
    Ok(())
}

fn check_domain<S: SubPixel>(contours: &[&[SubPoint<S>]]) -> Result<(), InputError> {
    contours
        .iter()
        .copied()
        .flatten()
        .try_for_each(|point| SubPoint::<S>::from_units(point.x_units(), point.y_units()).map(|_| ()))
}

fn extent<S: SubPixel>(contours: &[&[SubPoint<S>]]) -> Extent {
    Extent::of(contours.iter().copied().flatten().copied())
}

fn add_vertices<S: SubPixel>(
    vertices: &mut VecView<Vertex<S>>,
    subject: &[&[SubPoint<S>]],
    clip: &[&[SubPoint<S>]],
) -> Result<(), Full> {
    for contour in subject {
        add_contour(vertices, contour, Polygons::SUBJECT)?;
    }
    for contour in clip {
        add_contour(vertices, contour, Polygons::CLIP)?;
    }
    add_meetings(vertices)
}

/// One for each corner, and those that every two edges add where they meet.
fn vertices_needed<S: SubPixel>(subject: &[&[SubPoint<S>]], clip: &[&[SubPoint<S>]]) -> usize {
    let edges = || subject.iter().chain(clip).flat_map(|contour| edges(contour));
    let most = usize::from(VertexIndex::MAX);
    let corners = edges().take(most + 1).count();
    if corners > most {
        return corners;
    }
    // Two vertices for every two of 2^16 edges fit 32 bits.
    edges().enumerate().fold(corners, |needed, (index, first)| {
        let meetings = edges()
            .skip(index + 1)
            .map(|second| Meeting::of(&first, &second).vertices());
        needed + meetings.sum::<usize>()
    })
}

/// The edges of a contour that have a length, in order.
fn edges<S: SubPixel>(contour: &[SubPoint<S>]) -> impl Iterator<Item = ExactSegment<S>> + Clone {
    let ends = contour.iter().cycle().skip(1);
    contour
        .iter()
        .zip(ends)
        .filter(|(start, end)| start != end)
        .map(|(&start, &end)| ExactSegment { start, end })
}

/// Adds the corners of a contour.
fn add_contour<S: SubPixel>(
    table: &mut VecView<Vertex<S>>,
    contour: &[SubPoint<S>],
    owner: Polygons,
) -> Result<(), Full> {
    let first = VertexIndex::try_from(table.len()).map_err(|_| Full)?;
    let mut previous = None;
    for edge in edges(contour) {
        let index = VertexIndex::try_from(table.len()).map_err(|_| Full)?;
        // The last edge ends at the first corner.
        let corner = Origin::Corner { end: first, owner };
        insert(table, Vertex::new(edge.start, corner, index), previous)?;
        if let Some(previous) = previous {
            let corner = Origin::Corner { end: index, owner };
            table.change(previous, |vertex| vertex.origin = corner);
        }
        previous = Some(index);
    }
    Ok(())
}

/// Adds a vertex to every edge where another one meets it, and makes neighbours of all vertices at the same point.
///
/// Cost: a comparison of extents for every two edges, four orientations where these meet.
fn add_meetings<S: SubPixel>(table: &mut VecView<Vertex<S>>) -> Result<(), Full> {
    // All of them are corners still, and they fit.
    let corners = table.len() as VertexIndex;
    for first in 0..corners {
        let first_edge = table.segment(first);
        let extent = first_edge.extent();
        for second in first + 1..corners {
            let second_edge = table.segment(second);
            if extent.meets(&second_edge.extent()) {
                let meeting = Meeting::of(&first_edge, &second_edge);
                add_meeting(table, meeting, (first, &first_edge), (second, &second_edge))?;
            }
        }
    }
    Ok(())
}

fn add_meeting<S: SubPixel>(
    table: &mut VecView<Vertex<S>>,
    meeting: Meeting,
    (first, first_edge): (VertexIndex, &ExactSegment<S>),
    (second, second_edge): (VertexIndex, &ExactSegment<S>),
) -> Result<(), Full> {
    if meeting.crossing {
        let fraction = first_edge.fraction_of_crossing(second_edge);
        let point = first_edge.point_at(fraction);
        let on_first = Vertex::new(point, Origin::Crossing { by: second }, first);
        let on_first = add_on_edge(table, on_first, fraction)?;
        let fraction = second_edge.fraction_of_crossing(first_edge);
        let on_second = Vertex::new(point, Origin::Crossing { by: first }, second);
        let on_second = add_on_edge(table, on_second, fraction)?;
        table.link(on_first, on_second);
    }
    if meeting.same_start {
        table.link(first, second);
    }
    if meeting.first_touches {
        add_touch(table, first_edge.start, first, second)?;
    }
    if meeting.second_touches {
        add_touch(table, second_edge.start, second, first)?;
    }
    Ok(())
}

/// Adds a vertex to the edge that a corner lies on.
fn add_touch<S: SubPixel>(
    table: &mut VecView<Vertex<S>>,
    point: SubPoint<S>,
    corner: VertexIndex,
    edge: VertexIndex,
) -> Result<(), Full> {
    let fraction = table.segment(edge).fraction_of_point(point);
    let on_edge = add_on_edge(table, Vertex::new(point, Origin::Touch, edge), fraction)?;
    table.link(on_edge, corner);
    Ok(())
}

/// Adds a vertex to its edge in the order along that; where there is one at the same point, that is it.
fn add_on_edge<S: SubPixel>(
    table: &mut VecView<Vertex<S>>,
    vertex: Vertex<S>,
    fraction: Fraction,
) -> Result<VertexIndex, Full> {
    let edge = table.segment(vertex.edge);
    let mut previous = vertex.edge;
    loop {
        let index = table.at(previous).next;
        let next = table.at(index);
        let there = match next.origin {
            Origin::Corner { .. } => break,
            Origin::Touch => edge.fraction_of_point(next.point),
            Origin::Crossing { by } => edge.fraction_of_crossing(&table.segment(by)),
        };
        match there.compare::<S>(&fraction) {
            Ordering::Less => previous = index,
            Ordering::Equal => return Ok(index),
            Ordering::Greater => break,
        }
    }
    insert(table, vertex, Some(previous))
}
