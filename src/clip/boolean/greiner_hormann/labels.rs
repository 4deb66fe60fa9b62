//! The second phase: on which sides of each piece the result lies.
//!
//! What is inside is followed along a contour, as Greiner and Hormann do: one test where it starts, then only what its
//! vertices say. Foster, Hormann and Popa's labels are read off the order of directions around a vertex: of the other
//! ends there, those on the positive side of the passing contour toggle the inside of their polygon. An edge that
//! crosses has one end there and toggles; one that bounces has both or none. One that comes to run along the same line
//! is on neither side: it parts the two sides of the common pieces, and when it leaves, that decides which it was. So
//! crossings are delayed by themselves, and touching contours of one polygon need no rule of their own.

use crate::{
    clip::boolean::greiner_hormann::{
        direction::Direction,
        operation::Operation,
        vertices::{Label, Origin, Place, Polygons, Vertex, Vertices},
    },
    geometry::SubPixel,
};

/// Labels every piece.
///
/// Cost: the orientation of each contour's first corner to all edges that its ray meets, and at every vertex two
/// orientations an end.
pub(crate) fn label<S: SubPixel>(table: &mut [Vertex<S>], operation: Operation) {
    for corner in 0..table.len() as Place {
        let vertex = table.at(corner);
        if !matches!(vertex.origin, Origin::Corner { .. }) {
            // Corners come first.
            return;
        }
        if vertex.label == Label::Unknown {
            label_contour(table, operation, corner);
        }
    }
}

fn label_contour<S: SubPixel>(table: &mut [Vertex<S>], operation: Operation, start: Place) {
    let mut inside = inside_at(table, start);
    let mut place = start;
    loop {
        let label = piece_label(table, operation, place, inside);
        table.change(place, |vertex| vertex.label = label);
        place = table.at(place).next;
        if place == start {
            return;
        }
        let vertex = table.at(place);
        if vertex.neighbour != place {
            let back = table.ending(vertex.previous).direction;
            inside = inside.toggled(toggles(table, place, table.direction(place), back));
        }
    }
}

/// The polygons that the positive side of the piece is inside of, at a corner. Even-odd rule.
fn inside_at<S: SubPixel>(table: &[Vertex<S>], corner: Place) -> Polygons {
    let point = table.at(corner).point;
    let at_left = (0..table.len() as Place)
        .map_while(|other| matches!(table.at(other).origin, Origin::Corner { .. }).then_some(other))
        .filter(|&other| table.segment(other).crosses_ray_to(point))
        .fold(Polygons::NEITHER, |inside, other| inside.toggled(table.owner(other)));
    // From the ray on to the piece, and across it and all that lie on it.
    let direction = table.direction(corner);
    at_left
        .toggled(toggles(table, corner, Direction::LEFT, direction))
        .toggled(common(table, corner, direction).0)
}

/// The polygons whose inside changes between two directions around a point, positive turn, without the two themselves.
fn toggles<S: SubPixel>(table: &[Vertex<S>], place: Place, from: Direction, to: Direction) -> Polygons {
    let mut all = Polygons::NEITHER;
    table.visit_ends(place, &mut |end| {
        if from.passes(end.direction, to) {
            all = all.toggled(table.owner(end.piece));
        }
    });
    all
}

/// The polygons whose inside changes across all pieces in one direction, and the first of these pieces.
fn common<S: SubPixel>(table: &[Vertex<S>], place: Place, direction: Direction) -> (Polygons, Place) {
    let (mut all, mut first) = (Polygons::NEITHER, Place::MAX);
    table.visit_ends(place, &mut |end| {
        if end.direction.is_along(direction) {
            all = all.toggled(table.owner(end.piece));
            first = first.min(end.piece);
        }
    });
    (all, first)
}

/// `inside` is what the positive side is inside of.
fn piece_label<S: SubPixel>(table: &[Vertex<S>], operation: Operation, piece: Place, inside: Polygons) -> Label {
    let (common, first) = common(table, piece, table.direction(piece));
    let beyond = inside.toggled(common);
    match (operation.keeps(inside), operation.keeps(beyond)) {
        // Of pieces on the same place, one stands for all.
        _ if first != piece => Label::Dropped,
        (true, false) => Label::Along,
        (false, true) => Label::Against,
        _ => Label::Dropped,
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use crate::geometry::{Sub8, SubPoint};

    /// As many corners as there are places, and no other vertex behind them.
    #[test]
    fn a_full_table_of_corners_is_labelled() {
        let corners = Place::MAX;
        // Teeth upwards, closed by the straight way back along their feet's line, below it at the last corner.
        let height = |place: Place| if place == corners - 1 { 9 } else { -i32::from(place % 2) };
        let vertex = |place: Place| {
            let (next, previous) = ((place + 1) % corners, place.checked_sub(1).unwrap_or(corners - 1));
            let origin = Origin::Corner {
                end: next,
                owner: Polygons::SUBJECT,
            };
            let point = SubPoint::<Sub8>::from_units(i32::from(place), height(place)).unwrap();
            Vertex {
                next,
                previous,
                neighbour: place,
                ..Vertex::new(point, origin, place)
            }
        };
        let mut table: std::vec::Vec<_> = (0..corners).map(vertex).collect();
        label(&mut table, Operation::Union);
        assert!(table.iter().all(|vertex| vertex.label == Label::Along));
    }
}
