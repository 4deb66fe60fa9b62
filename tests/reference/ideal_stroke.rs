//! The ideal stroke as a union of rectangles, wedges, caps and discs, in `i128` with 40 fractional bits.
//!
//! Written plainly and apart from the library: every dash becomes a path of its own, every path its list of convex
//! primitives. A pixel whose centre is nearer to an ideal outline than the stated roundings may go either way.

use zrow::draw::{LineCap, LineJoin};

/// Fractional bits of the reference.
pub const BITS: u32 = 40;

pub const ONE: i128 = 1 << BITS;

/// Four roundings to 1/65,536 pixel.
const TOLERANCE: i128 = 4 << (BITS - 16);

pub type Position = (i128, i128);

fn plus(a: Position, b: Position) -> Position {
    (a.0 + b.0, a.1 + b.1)
}

fn minus(a: Position, b: Position) -> Position {
    (a.0 - b.0, a.1 - b.1)
}

/// A vector times a number with `BITS` fractional bits.
fn times(a: Position, factor: i128) -> Position {
    ((a.0 * factor) >> BITS, (a.1 * factor) >> BITS)
}

fn cross(a: Position, b: Position) -> i128 {
    (a.0 * b.1 - a.1 * b.0) >> BITS
}

fn dot(a: Position, b: Position) -> i128 {
    (a.0 * b.0 + a.1 * b.1) >> BITS
}

fn length(a: Position) -> i128 {
    (a.0 * a.0 + a.1 * a.1).isqrt()
}

/// The unit vector from one position to another.
fn along(from: Position, to: Position) -> Position {
    let vector = minus(to, from);
    let length = length(vector);
    ((vector.0 << BITS) / length, (vector.1 << BITS) / length)
}

/// A quarter turn.
fn normal(direction: Position) -> Position {
    (-direction.1, direction.0)
}

#[derive(Debug, Clone)]
pub enum Primitive {
    /// Convex: where each edge begins, its unit vector, and which sense of rotation they have.
    Polygon(Vec<(Position, Position)>, i128),
    Disc {
        center: Position,
        radius: i128,
        exact: bool,
    },
}

#[derive(Debug, Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Location {
    Outside,
    Between,
    Inside,
}

impl Primitive {
    fn polygon(corners: &[Position]) -> Self {
        let count = corners.len();
        let edges = || (0..count).map(|index| (corners[index], corners[(index + 1) % count]));
        let area: i128 = edges()
            .map(|(from, to)| cross(minus(from, corners[0]), minus(to, corners[0])))
            .sum();
        let sides = edges().filter(|(from, to)| from != to);
        Self::Polygon(sides.map(|(from, to)| (from, along(from, to))).collect(), area.signum())
    }

    pub fn locate(&self, point: Position) -> Location {
        let margin = match self {
            Self::Polygon(edges, rotation) => {
                let side = |&(from, along)| cross(along, minus(point, from)) * rotation;
                edges.iter().map(side).min().unwrap_or(i128::MIN)
            }
            Self::Disc { center, radius, exact } => {
                let (x, y) = minus(point, *center);
                if *exact {
                    // On a tie, the left half.
                    let surplus = x * x + y * y - radius * radius;
                    return if surplus < 0 || surplus == 0 && x < 0 {
                        Location::Inside
                    } else {
                        Location::Outside
                    };
                }
                radius - length((x, y))
            }
        };
        match margin {
            _ if margin > TOLERANCE => Location::Inside,
            _ if margin < -TOLERANCE => Location::Outside,
            _ => Location::Between,
        }
    }
}

/// A style in the numbers of the reference.
#[derive(Debug, Clone)]
pub struct Style {
    pub width: u32,
    pub cap: LineCap,
    pub join: LineJoin,
    /// In 1/65,536 pixel, with the offset.
    pub dashes: Option<(Vec<u32>, i32)>,
}

impl Style {
    fn half(&self) -> i128 {
        i128::from(self.width) * ONE / 2
    }
}

/// The primitives of a stroke; `None` where a rounding could decide what is one.
pub fn primitives(vertices: &[Position], closed: bool, style: &Style) -> Option<Vec<Primitive>> {
    let mut path: Vec<Position> = vertices.to_vec();
    path.dedup();
    while closed && path.len() > 1 && path.first() == path.last() {
        path.pop();
    }
    if path.is_empty() {
        return Some(Vec::new());
    }
    let total: u64 = style
        .dashes
        .iter()
        .flat_map(|(lengths, _)| lengths)
        .map(|&length| u64::from(length))
        .sum();
    if total == 0 {
        return solid(&path, closed, style, true);
    }
    dashed(&path, closed, style)
}

/// Each dash as a path of its own.
fn dashed(path: &[Position], closed: bool, style: &Style) -> Option<Vec<Primitive>> {
    let (lengths, offset) = style.dashes.as_ref().unwrap();
    let mut lengths: Vec<i128> = lengths
        .iter()
        .map(|&length| i128::from(length) << (BITS - 16))
        .collect();
    if lengths.len() % 2 == 1 {
        lengths = [lengths.clone(), lengths].concat();
    }
    let cycle: i128 = lengths.iter().sum();
    let mut stations = vec![(0, path[0])];
    for index in 1..path.len() + usize::from(closed && path.len() > 1) {
        let (before, from) = stations[index - 1];
        let to = path[index % path.len()];
        stations.push((before + length(minus(to, from)), to));
    }
    let end = stations.last().unwrap().0;
    // Dashes in distances from the beginning; rounding may not decide on which side of a vertex one begins or ends.
    let mut begin = -(i128::from(*offset) << (BITS - 16)).rem_euclid(cycle);
    let mut dashes = Vec::new();
    for index in 0.. {
        if begin > end {
            break;
        }
        let dash = (begin, begin + lengths[index % lengths.len()]);
        begin = dash.1;
        let near = |distance: i128| {
            stations
                .iter()
                .skip(1)
                .any(|station| (station.0 - distance).abs() < ONE / 1000)
        };
        if near(dash.1) {
            return None;
        }
        let has_begun = dash.0 >= 0 || dash.1 > 0;
        if index % 2 == 0 && has_begun && dash.0 < end.max(1) {
            dashes.push((dash.0.max(0), dash.1.min(end), dash.1 > end));
        }
    }
    let at = |distance: i128| {
        let next = stations.iter().position(|station| station.0 >= distance).unwrap();
        let (behind, to) = stations[next];
        if behind == distance {
            return to;
        }
        let (before, from) = stations[next - 1];
        plus(from, times(along(from, to), distance - before))
    };
    let points = |&(from, to, _): &(i128, i128, bool)| {
        let between = stations
            .iter()
            .filter(|station| from < station.0 && station.0 < to)
            .map(|station| station.1);
        let mut points = vec![at(from)];
        points.extend(between);
        points.push(at(to));
        points
    };
    // The dash at the first vertex that the last one goes on in.
    let runs_on = closed && dashes.last().is_some_and(|dash| dash.2);
    let first = dashes
        .iter()
        .position(|dash| dash.0 == 0 && dash.1 > 0)
        .filter(|_| runs_on);
    let mut primitives = Vec::new();
    let mut paths: Vec<(Vec<Position>, i128)> = dashes.iter().map(|dash| (points(dash), dash.0)).collect();
    if let Some(first) = first {
        let (points, _) = paths.remove(first);
        if first == paths.len() {
            // It is the last one, too.
            primitives.extend(solid(path, true, style, true)?);
        } else {
            paths.last_mut().unwrap().0.extend(points.into_iter().skip(1));
        }
    }
    for (path, begin) in &paths {
        if path.len() == 2 && path[0] == path[1] {
            // A dash without length lies along its segment.
            let next = stations.iter().position(|station| station.0 > *begin).unwrap_or(0);
            let direction = if next == 0 {
                (ONE, 0)
            } else {
                along(stations[next - 1].1, stations[next].1)
            };
            add_cap(&mut primitives, path[0], direction, style, false);
            add_cap(&mut primitives, path[0], minus((0, 0), direction), style, false);
            continue;
        }
        primitives.extend(solid(path, false, style, false)?);
    }
    Some(primitives)
}

/// What a cap adds at the end of a segment in this direction.
fn add_cap(primitives: &mut Vec<Primitive>, at: Position, direction: Position, style: &Style, exact: bool) {
    let half = style.half();
    let extension = match style.cap {
        LineCap::Butt => return,
        LineCap::WholePixel => ONE / 2,
        LineCap::Square => half,
        LineCap::Round => {
            primitives.push(Primitive::Disc {
                center: at,
                radius: half,
                exact,
            });
            return;
        }
    };
    let (forward, side) = (times(direction, extension), times(normal(direction), half));
    primitives.push(rectangle(at, plus(at, forward), side));
}

fn rectangle(from: Position, to: Position, side: Position) -> Primitive {
    Primitive::polygon(&[plus(from, side), plus(to, side), minus(to, side), minus(from, side)])
}

/// The primitives of a path; `exact` where its vertices are.
fn solid(path: &[Position], closed: bool, style: &Style, exact: bool) -> Option<Vec<Primitive>> {
    let mut primitives = Vec::new();
    let half = style.half();
    let count = path.len();
    if count == 1 {
        for direction in [(ONE, 0), (-ONE, 0)] {
            add_cap(&mut primitives, path[0], direction, style, exact);
        }
        return Some(primitives);
    }
    let last = if closed { count } else { count - 1 };
    for index in 0..last {
        let (from, to) = (path[index], path[(index + 1) % count]);
        let direction = along(from, to);
        primitives.push(rectangle(from, to, times(normal(direction), half)));
        if index > 0 || closed {
            let before = along(path[(index + count - 1) % count], from);
            corner(&mut primitives, from, before, direction, style)?;
        }
    }
    if !closed {
        add_cap(&mut primitives, path[0], along(path[1], path[0]), style, exact);
        add_cap(
            &mut primitives,
            path[count - 1],
            along(path[count - 2], path[count - 1]),
            style,
            exact,
        );
    }
    Some(primitives)
}

fn corner(
    primitives: &mut Vec<Primitive>,
    at: Position,
    before: Position,
    after: Position,
    style: &Style,
) -> Option<()> {
    let half = style.half();
    let (sine, cosine) = (cross(before, after), dot(before, after));
    if sine.abs() < 1 << 8 && cosine > 0 {
        return Some(());
    }
    if style.join == LineJoin::Round {
        primitives.push(Primitive::Disc {
            center: at,
            radius: half,
            exact: true,
        });
        return Some(());
    }
    if sine.abs() < 1 << 8 {
        return Some(());
    }
    let side = -sine.signum() * half;
    let mut wedge = vec![at, plus(at, times(normal(before), side))];
    if let LineJoin::Miter { limit } = style.join {
        // The square of the ratio is 2 / (1 + cos); (1 + cos) / sin^2 = 1 / (1 - cos) is better where it is sharp.
        let one_and_cosine = if cosine < 0 {
            (sine * sine) / (ONE - cosine)
        } else {
            ONE + cosine
        };
        let limit = i128::from(limit.to_bits()) << (BITS - 8);
        let (square, ratio_square) = ((limit * limit) >> BITS, ((2 * ONE) << BITS) / one_and_cosine);
        if (square - ratio_square).abs() < ratio_square / 5000 {
            return None;
        }
        if square > ratio_square {
            // By Cramer's rule where it is sharp, along the sum of the normals where it is not.
            let tip = if cosine < 0 {
                let ((x0, y0), (x1, y1)) = (before, after);
                (((x0 - x1) * half) / sine.abs(), ((y0 - y1) * half) / sine.abs())
            } else {
                let (x, y) = plus(normal(before), normal(after));
                ((x * side) / one_and_cosine, (y * side) / one_and_cosine)
            };
            wedge.push(plus(at, tip));
        }
    }
    wedge.push(plus(at, times(normal(after), side)));
    primitives.push(Primitive::polygon(&wedge));
    Some(())
}

/// Positions of the reference from units of 1/256 pixel.
pub fn ideal(points: &[(i32, i32)]) -> Vec<Position> {
    let coordinate = |units: i32| i128::from(units) << (BITS - 8);
    points.iter().map(|&(x, y)| (coordinate(x), coordinate(y))).collect()
}
