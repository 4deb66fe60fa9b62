//! Whether contours of a glyph cross, overlap or touch: then its area is not the sum of signed areas.
//!
//! Curves are cut into 16 lines each, whose ends are exact in a fraction of a unit, and every two lines are compared. Contours
//! that have no point in common may still lie in each other: the winding numbers on both sides of each of them must be 0 and one
//! other number, 1 or -1, which is the same for all.

use crate::quadratics::Point;

/// Lines of a curve.
const LINES: i64 = 16;
/// What a unit is multiplied by, so that ends of lines are whole numbers: the middle between two points, and the square of the
/// lines of a curve.
const FINE: i64 = 2 * LINES * LINES;

type Position = [i64; 2];

/// Whether a line of some contour has a point in common with one that is not its neighbour, or contours lie in each other in such
/// a way that windings add up.
pub fn cross_or_overlap(contours: &[Vec<Point>]) -> bool {
    let contours: Vec<Vec<Position>> = contours.iter().map(|contour| corners(contour)).collect();
    let lines: Vec<(usize, usize, [Position; 2])> = contours
        .iter()
        .enumerate()
        .flat_map(|(number, contour)| {
            let next = contour.iter().cycle().skip(1);
            let lines = contour.iter().zip(next).enumerate();
            lines.map(move |(index, (&from, &to))| (number, index, [from, to]))
        })
        .collect();
    let meet = lines.iter().enumerate().any(|(at, &(number, index, line))| {
        lines[at + 1..].iter().any(|&(other_number, other_index, other)| {
            let last = contours[number].len() - 1;
            let are_neighbours =
                number == other_number && (other_index == index + 1 || (index, other_index) == (0, last));
            !are_neighbours && touch(line, other)
        })
    });
    meet || !windings_are_one(&contours)
}

/// The ends of the lines of a contour, without repetitions.
fn corners(contour: &[Point]) -> Vec<Position> {
    let at = |point: &Point| [i64::from(point.x), i64::from(point.y)];
    let mut explicit: Vec<(Position, bool)> = Vec::new();
    for point in contour.iter().chain(contour.first()) {
        if let (Some(&(before, false)), false) = (explicit.last(), point.is_on_contour) {
            let middle = [0, 1].map(|axis| before[axis] / 2 + at(point)[axis]);
            explicit.push((middle, true));
        }
        explicit.push((at(point).map(|axis| 2 * axis), point.is_on_contour));
    }
    let mut corners = Vec::new();
    let mut points = explicit.iter();
    let Some(&(first, _)) = points.next() else {
        return corners;
    };
    let mut from = first;
    while let Some(&(point, is_on)) = points.next() {
        if is_on {
            corners.push(point.map(|axis| axis * FINE / 2));
            from = point;
            continue;
        }
        let Some(&(to, _)) = points.next() else { break };
        for line in 1..=LINES {
            let rest = LINES - line;
            let axis = |axis: usize| from[axis] * rest * rest + 2 * point[axis] * line * rest + to[axis] * line * line;
            corners.push([axis(0), axis(1)]);
        }
        from = to;
    }
    corners.dedup();
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    corners
}

/// On which side of a line a point lies: positive on the left.
fn side([from, to]: [Position; 2], point: Position) -> i64 {
    let cross = (to[0] - from[0]) * (point[1] - from[1]) - (to[1] - from[1]) * (point[0] - from[0]);
    cross.signum()
}

/// Whether two lines have a point in common.
fn touch(line: [Position; 2], other: [Position; 2]) -> bool {
    let is_apart = |axis: usize| {
        let ends = |line: [Position; 2]| (line[0][axis].min(line[1][axis]), line[0][axis].max(line[1][axis]));
        let ((start, end), (other_start, other_end)) = (ends(line), ends(other));
        end < other_start || other_end < start
    };
    !is_apart(0)
        && !is_apart(1)
        && side(line, other[0]) * side(line, other[1]) <= 0
        && side(other, line[0]) * side(other, line[1]) <= 0
}

/// Whether the winding numbers on both sides of all contours, which have no point in common, are 0 and one other number.
fn windings_are_one(contours: &[Vec<Position>]) -> bool {
    let mut windings: Vec<i64> = Vec::new();
    for (number, contour) in contours.iter().enumerate() {
        let Some(&point) = contour.first() else { continue };
        let others = contours.iter().enumerate().filter(|&(other, _)| other != number);
        let outside: i64 = others.map(|(_, other)| winding(other, point)).sum();
        let next = contour.iter().cycle().skip(1);
        let area: i128 = contour
            .iter()
            .zip(next)
            .map(|(from, to)| i128::from(from[0]) * i128::from(to[1]) - i128::from(from[1]) * i128::from(to[0]))
            .sum();
        windings.extend([outside, outside + area.signum() as i64]);
    }
    [1, -1]
        .into_iter()
        .any(|one| windings.iter().all(|&winding| winding == 0 || winding == one))
}

/// How often a contour goes around a point that is not on it.
fn winding(contour: &[Position], point: Position) -> i64 {
    let next = contour.iter().cycle().skip(1);
    let crossings = contour.iter().zip(next).map(|(&from, &to)| {
        let (starts_above, ends_above) = (from[1] > point[1], to[1] > point[1]);
        match (starts_above, ends_above, side([from, to], point)) {
            (false, true, 1) => 1,
            (true, false, -1) => -1,
            _ => 0,
        }
    });
    crossings.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contour(points: &[(i16, i16)]) -> Vec<Point> {
        let point = |&(x, y): &(i16, i16)| Point {
            x,
            y,
            is_on_contour: true,
        };
        points.iter().map(point).collect()
    }

    fn square(from: i16, to: i16) -> Vec<Point> {
        contour(&[(from, from), (to, from), (to, to), (from, to)])
    }

    fn reversed(mut contour: Vec<Point>) -> Vec<Point> {
        contour.reverse();
        contour
    }

    #[test]
    fn contours_that_add_up_or_meet_are_found() {
        let apart = contour(&[(200, 0), (300, 0), (300, 90)]);
        for (contours, expected) in [
            (vec![square(0, 100)], false),
            (vec![square(0, 100), reversed(square(20, 80))], false),
            (vec![square(0, 100), reversed(square(20, 80)), square(30, 40)], false),
            (vec![square(0, 100), apart.clone()], false),
            (vec![reversed(square(0, 100)), reversed(apart.clone())], false),
            // Windings of 2, and of 1 and -1.
            (vec![square(0, 100), square(20, 80)], true),
            (vec![square(0, 100), reversed(apart)], true),
            // They cross, touch in a corner, along a side.
            (vec![square(0, 100), square(50, 150)], true),
            (vec![square(0, 100), square(100, 150)], true),
            (
                vec![square(0, 100), contour(&[(100, 20), (150, 20), (150, 80), (100, 80)])],
                true,
            ),
            // A bow tie.
            (vec![contour(&[(0, 0), (100, 100), (100, 0), (0, 100)])], true),
            (vec![], false),
        ] {
            assert_eq!(cross_or_overlap(&contours), expected, "{contours:?}");
        }
    }

    /// A curve bulges into a square that its ends are outside of, and one does not.
    #[test]
    fn curves_are_curves() {
        for (bulge, expected) in [(150, true), (40, false), (90, false), (100, false), (110, true)] {
            let mut curve = contour(&[(0, -50), (50, bulge), (100, -50)]);
            curve[1].is_on_contour = false;
            // The middle of the curve is at half the height of its control point.
            let above = contour(&[(0, 27), (100, 27), (100, 60), (0, 60)]);
            assert_eq!(cross_or_overlap(&[reversed(curve), above]), expected, "{bulge}");
        }
    }
}
