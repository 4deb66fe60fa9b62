//! What a convex window leaves of segments and polygons: exact rationals in `i128`, written plainly.

/// Coordinates in units.
pub type Position = (i32, i32);

/// The exact point `(x, y) / w`, in lowest terms, with a positive `w`.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Exact {
    pub x: i128,
    pub y: i128,
    pub w: i128,
}

impl From<Position> for Exact {
    fn from((x, y): Position) -> Self {
        Self {
            x: x.into(),
            y: y.into(),
            w: 1,
        }
    }
}

impl Exact {
    /// The point of the segment where a value is 0 that is `from_value` and `to_value` at its ends.
    ///
    /// The values are over the points' denominators.
    pub fn at_zero(from: Self, from_value: i128, to: Self, to_value: i128) -> Self {
        let sign = (from.w * to_value - to.w * from_value).signum();
        let mix = |from: i128, to: i128| sign * (from * to_value - to * from_value);
        let (x, y, w) = (mix(from.x, to.x), mix(from.y, to.y), mix(from.w, to.w));
        let divisor = greatest_common_divisor(greatest_common_divisor(x, y), w);
        Self {
            x: x / divisor,
            y: y / divisor,
            w: w / divisor,
        }
    }

    pub fn nearest(&self) -> Position {
        let nearest = |numerator: i128| {
            let nearest = (2 * numerator + self.w).div_euclid(2 * self.w);
            i32::try_from(nearest).unwrap()
        };
        (nearest(self.x), nearest(self.y))
    }
}

fn greatest_common_divisor(one: i128, other: i128) -> i128 {
    let (mut one, mut other) = (one.abs(), other.abs());
    while other != 0 {
        (one, other) = (other, one % other);
    }
    one.max(1)
}

/// Twice the signed area in units times `1 << 20`; every edge is at most one of these off.
pub fn area(corners: &[Exact]) -> i128 {
    let nexts = corners.iter().cycle().skip(1);
    let cross = |(one, next): (&Exact, &Exact)| {
        let numerator = one.x * next.y - next.x * one.y;
        (numerator << 20).div_euclid(one.w * next.w)
    };
    corners.iter().zip(nexts).map(cross).sum()
}

/// The straight line through two corners; what is kept lies to the right of it, as the screen shows it.
#[derive(Debug, Copy, Clone)]
pub struct Side {
    pub start: Position,
    pub end: Position,
}

impl Side {
    /// How far inside a point is, over its denominator.
    pub fn value(&self, point: Exact) -> i128 {
        let [x, y, end_x, end_y] = [self.start.0, self.start.1, self.end.0, self.end.1].map(i128::from);
        (end_x - x) * (point.y - y * point.w) - (end_y - y) * (point.x - x * point.w)
    }
}

/// The sides of a window, whose orientation is made clockwise first.
pub fn sides(window: &[Position]) -> Vec<Side> {
    let exact: Vec<Exact> = window.iter().map(|&corner| corner.into()).collect();
    let is_clockwise = area(&exact) > 0;
    let ends = window.iter().cycle().skip(1);
    window
        .iter()
        .zip(ends)
        .map(|(&start, &end)| {
            if is_clockwise {
                Side { start, end }
            } else {
                Side { start: end, end: start }
            }
        })
        .collect()
}

/// The first and the last exact point of a segment in the window.
pub fn exact_segment(from: Position, to: Position, window: &[Position]) -> Option<(Exact, Exact)> {
    exact_part(from, to, &sides(window))
}

/// The first and the last exact point of a segment inside all sides: every crossing and both ends are tried.
pub fn exact_part(from: Position, to: Position, sides: &[Side]) -> Option<(Exact, Exact)> {
    let (from, to) = (Exact::from(from), Exact::from(to));
    let mut candidates = vec![from, to];
    for side in sides {
        let (start, end) = (side.value(from), side.value(to));
        if (start < 0) != (end < 0) {
            candidates.push(Exact::at_zero(from, start, to, end));
        }
    }
    // Along the larger difference, in the direction of the segment.
    let is_flat = (to.x - from.x).abs() >= (to.y - from.y).abs();
    let direction = if is_flat { to.x - from.x } else { to.y - from.y };
    // Whole units first, and then what is left of one: the product of a numerator and a denominator may not fit.
    let order = |one: &Exact, other: &Exact| {
        let along = |point: &Exact| direction.signum() * if is_flat { point.x } else { point.y };
        let rest = |point: &Exact| along(point).rem_euclid(point.w);
        let units = along(one).div_euclid(one.w).cmp(&along(other).div_euclid(other.w));
        units.then_with(|| (rest(one) * other.w).cmp(&(rest(other) * one.w)))
    };
    candidates.retain(|&point| sides.iter().all(|side| side.value(point) >= 0));
    let first = candidates.iter().copied().min_by(order)?;
    Some((first, candidates.into_iter().max_by(order)?))
}

/// Textbook clipping of a list of corners, side after side, without any rounding.
pub fn exact_polygon(polygon: &[Position], window: &[Position]) -> Vec<Exact> {
    let mut corners: Vec<Exact> = polygon.iter().map(|&corner| corner.into()).collect();
    for side in sides(window) {
        let mut kept = Vec::new();
        for (index, &corner) in corners.iter().enumerate() {
            let before = corners[(index + corners.len() - 1) % corners.len()];
            let (start, end) = (side.value(before), side.value(corner));
            if (start < 0) != (end < 0) {
                kept.push(Exact::at_zero(before, start, corner, end));
            }
            if end >= 0 {
                kept.push(corner);
            }
        }
        corners = kept;
    }
    corners
}

/// Corners rounded once, without those that repeat the one before; none where fewer than three are left.
pub fn rounded(corners: &[Exact]) -> Vec<Position> {
    let mut positions: Vec<Position> = corners.iter().map(Exact::nearest).collect();
    positions.dedup();
    if positions.len() > 1 && positions.first() == positions.last() {
        positions.pop();
    }
    if positions.len() < 3 {
        positions.clear();
    }
    positions
}
