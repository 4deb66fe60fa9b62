//! Cyrus-Beck and Sutherland-Hodgman against any convex window: exact rationals in `i128`, written plainly.

use heapless::Vec as Bounded;
use proptest::prelude::*;
use zrow::{
    clip::ParametricSegment,
    geometry::{ConvexWindow, InputError, Sub4, Sub8, SubPixel, SubPoint, Table, TooSmall},
};

use crate::{
    any_units::{AnyUnits, sub_point},
    common::config,
};

/// Coordinates in units.
type Position = (i32, i32);

fn sub_points<S: AnyUnits>(positions: &[Position]) -> Vec<SubPoint<S>> {
    positions.iter().map(|&position| sub_point(position)).collect()
}

fn position<S: SubPixel>(point: SubPoint<S>) -> Position {
    (point.x_units(), point.y_units())
}

/// The exact point `(x, y) / w`, in lowest terms, with a positive `w`.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
struct Exact {
    x: i128,
    y: i128,
    w: i128,
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
    fn at_zero(from: Self, from_value: i128, to: Self, to_value: i128) -> Self {
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

    fn nearest(&self) -> Position {
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
fn area(corners: &[Exact]) -> i128 {
    let nexts = corners.iter().cycle().skip(1);
    let cross = |(one, next): (&Exact, &Exact)| {
        let numerator = one.x * next.y - next.x * one.y;
        (numerator << 20).div_euclid(one.w * next.w)
    };
    corners.iter().zip(nexts).map(cross).sum()
}

/// The straight line through two corners; what is kept lies to the right of it, as the screen shows it.
#[derive(Debug, Copy, Clone)]
struct Side {
    start: Position,
    end: Position,
}

impl Side {
    /// How far inside a point is, over its denominator.
    fn value(&self, point: Exact) -> i128 {
        let [x, y, end_x, end_y] = [self.start.0, self.start.1, self.end.0, self.end.1].map(i128::from);
        (end_x - x) * (point.y - y * point.w) - (end_y - y) * (point.x - x * point.w)
    }
}

/// The sides of a window, whose orientation is made clockwise first.
fn sides(window: &[Position]) -> Vec<Side> {
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
fn exact_segment(from: Position, to: Position, window: &[Position]) -> Option<(Exact, Exact)> {
    exact_part(from, to, &sides(window))
}

/// The first and the last exact point of a segment inside all sides: every crossing and both ends are tried.
fn exact_part(from: Position, to: Position, sides: &[Side]) -> Option<(Exact, Exact)> {
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
    let order = |one: &Exact, other: &Exact| {
        let along = |point: &Exact| if is_flat { point.x } else { point.y };
        (direction.signum() * along(one) * other.w).cmp(&(direction.signum() * along(other) * one.w))
    };
    candidates.retain(|&point| sides.iter().all(|side| side.value(point) >= 0));
    let first = candidates.iter().copied().min_by(order)?;
    Some((first, candidates.into_iter().max_by(order)?))
}

/// Textbook clipping of a list of corners, side after side, without any rounding.
fn exact_polygon(polygon: &[Position], window: &[Position]) -> Vec<Exact> {
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
fn rounded(corners: &[Exact]) -> Vec<Position> {
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

/// Turned so that it starts with its smallest sequence.
fn turned(positions: &[Position]) -> Vec<Position> {
    let turn = |start: usize| [&positions[start..], &positions[..start]].concat();
    (0..positions.len()).map(turn).min().unwrap_or_default()
}

/// The corners of the convex hull, clockwise on the screen, without straight ones.
fn hull(points: &[Position]) -> Vec<Position> {
    let mut points = points.to_vec();
    points.sort_unstable();
    points.dedup();
    let turn = |a: Position, b: Position, c: Position| {
        let wide = i64::from;
        (wide(b.0) - wide(a.0)) * (wide(c.1) - wide(a.1)) - (wide(b.1) - wide(a.1)) * (wide(c.0) - wide(a.0))
    };
    let half = |points: &mut dyn Iterator<Item = Position>| {
        let mut chain: Vec<Position> = Vec::new();
        for point in points {
            while chain.len() >= 2 && turn(chain[chain.len() - 2], chain[chain.len() - 1], point) <= 0 {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut corners = half(&mut points.iter().copied());
    corners.extend(half(&mut points.iter().rev().copied()));
    corners
}

/// The part of a segment in a window, by every clipper that the registry has: all of them agree.
fn clip_in_window<S: SubPixel>(
    from: SubPoint<S>,
    to: SubPoint<S>,
    window: &ConvexWindow<'_, S>,
) -> Option<ParametricSegment<S>> {
    macro_rules! clip_by_each {
        ($([$name:ident] [$($clip:tt)+])+) => {
            [$((stringify!($name), $($clip)+(from, to, window))),+]
        };
    }
    let [(_, first), others @ ..] = zrow_methods::convex_segments!(clip_by_each);
    for (name, other) in others {
        assert_eq!(other, first, "{name}");
    }
    first
}

/// The corners of a polygon that lie in a window, by every clipper that the registry has: all of them agree.
fn clip_corners<S: SubPixel, const CORNERS: usize, const SIDES: usize>(
    polygon: &[SubPoint<S>],
    window: &ConvexWindow<'_, S>,
) -> Result<Bounded<SubPoint<S>, CORNERS>, TooSmall> {
    macro_rules! clip_by_each {
        ($([$name:ident] [$($clip:tt)+])+) => {
            [$((stringify!($name), $($clip)+::<CORNERS, SIDES>(window, polygon))),+]
        };
    }
    let [(_, first), others @ ..] = zrow_methods::convex_polygons!(clip_by_each);
    for (name, other) in others {
        assert_eq!(other, first, "{name}");
    }
    first
}

/// The part of a segment in a window, and its ends rounded inwards.
fn clip_segment<S: AnyUnits>(from: Position, to: Position, window: &[Position]) -> Option<(Position, Position)> {
    let corners = sub_points::<S>(window);
    let window = ConvexWindow::new(&corners).unwrap();
    let (start, end) = clip_in_window(sub_point(from), sub_point(to), &window)?.ends_within(&window);
    Some((position(start), position(end)))
}

/// The unit that stands for an exact point of a closed window, and whether it lies inside, by trying those around it.
///
/// The nearest one inside; of equally near ones that furthest from the side on which the point is, and then that with the
/// larger coordinates. Where none is inside, the nearest one beyond that side.
fn inner_unit(point: Exact, window: &[Position]) -> (Position, bool) {
    let sides = sides(window);
    let around = |numerator: i128| {
        let low = numerator.div_euclid(point.w);
        low..=low + i128::from(numerator.rem_euclid(point.w) != 0)
    };
    let units = around(point.x).flat_map(|x| around(point.y).map(move |y| (x, y)));
    let rank = |&(x, y): &(i128, i128)| {
        let unit = Exact { x, y, w: 1 };
        let is_outside = sides.iter().any(|side| side.value(unit) < 0);
        let square = (point.x - x * point.w).pow(2) + (point.y - y * point.w).pow(2);
        let crossed = sides.iter().filter(|side| side.value(point) == 0);
        let depth: i128 = crossed.map(|side| side.value(unit)).sum();
        (is_outside, is_outside && depth >= 0, square, -depth, -x, -y)
    };
    let (x, y) = units.min_by_key(rank).unwrap();
    ((x as i32, y as i32), !rank(&(x, y)).0)
}

/// Without rounding, and rounded inwards: both orders of the ends and both orientations of the window; again, where both
/// rounded ends are inside.
///
/// Returns whether they are.
fn check_segment<S: AnyUnits>(from: Position, to: Position, window: &[Position]) -> bool {
    let exact = exact_segment(from, to, window);
    let units = exact.map(|(first, last)| (inner_unit(first, window), inner_unit(last, window)));
    let are_inside = units.is_none_or(|(first, last)| first.1 && last.1);
    let expected = units.map(|(first, last)| (first.0, last.0));
    let swapped = expected.map(|(first, last)| (last, first));
    check_exactly::<S>(from, to, &[window.to_vec()]);
    let mut reversed = window.to_vec();
    reversed.reverse();
    for window in [window, &reversed] {
        let context = format!("{from:?} to {to:?} in {window:?}");
        assert_eq!(clip_segment::<S>(from, to, window), expected, "{context}");
        assert_eq!(clip_segment::<S>(to, from, window), swapped, "swapped, {context}");
        if let (Some((first, last)), true) = (expected, are_inside) {
            let again = clip_segment::<S>(first, last, window);
            assert_eq!(again, expected, "again, {context}");
        }
    }
    are_inside
}

/// What windows leave of a segment, one after the other, without rounding.
fn clip_exactly<S: AnyUnits>(from: Position, to: Position, windows: &[Vec<Position>]) -> Option<ParametricSegment<S>> {
    let mut part = None;
    for window in windows {
        let corners = sub_points::<S>(window);
        let window = ConvexWindow::new(&corners).unwrap();
        part = Some(match part {
            None => clip_in_window(sub_point(from), sub_point(to), &window)?,
            Some(part) => ParametricSegment::clip(&part, &window)?,
        });
    }
    part
}

/// Accepted as exact arithmetic does, the nearest units, any order of windows and ends, mirrored at the diagonal, and the
/// same when clipped again.
fn check_exactly<S: AnyUnits>(from: Position, to: Position, windows: &[Vec<Position>]) {
    let context = format!("{from:?} to {to:?} in {windows:?}");
    let sides: Vec<Side> = windows.iter().flat_map(|window| sides(window)).collect();
    let expected = exact_part(from, to, &sides).map(|(first, last)| (first.nearest(), last.nearest()));
    let ends = |part: &ParametricSegment<S>| (position(part.ends().0), position(part.ends().1));
    let once = clip_exactly::<S>(from, to, windows);
    assert_eq!(once.as_ref().map(ends), expected, "{context}");

    let swapped = clip_exactly::<S>(to, from, windows);
    let swapped_back = swapped.as_ref().map(ends).map(|(first, last)| (last, first));
    assert_eq!(swapped_back, expected, "swapped, {context}");

    let turn = |(x, y): Position| (y, x);
    let turned_windows: Vec<Vec<Position>> = windows
        .iter()
        .map(|window| window.iter().copied().map(turn).collect())
        .collect();
    let turned = clip_exactly::<S>(turn(from), turn(to), &turned_windows);
    let turned_back = turned.as_ref().map(ends).map(|(first, last)| (turn(first), turn(last)));
    assert_eq!(turned_back, expected, "mirrored, {context}");

    let mut turned_around: Vec<Vec<Position>> = windows.to_vec();
    turned_around.reverse();
    turned_around.iter_mut().for_each(|window| window.reverse());
    assert_eq!(
        clip_exactly::<S>(from, to, &turned_around),
        once,
        "another order, {context}"
    );
    if let Some(part) = once {
        let twice = [windows, windows].concat();
        assert_eq!(clip_exactly::<S>(from, to, &twice), once, "again, {context}");
        for window in windows {
            let corners = sub_points::<S>(window);
            assert_eq!(
                part.clip(&ConvexWindow::new(&corners).unwrap()),
                once,
                "again, {context}"
            );
        }
    }
}

fn clip_polygon<S: AnyUnits>(polygon: &[Position], window: &[Position]) -> Vec<Position> {
    let (polygon, corners) = (sub_points::<S>(polygon), sub_points::<S>(window));
    let window = ConvexWindow::new(&corners).unwrap();
    let clipped = clip_corners::<S, 64, 16>(&polygon, &window).unwrap();
    clipped.into_iter().map(position).collect()
}

/// Checks one polygon and returns what is left of it.
fn check_polygon<S: AnyUnits>(polygon: &[Position], window: &[Position]) -> Vec<Position> {
    let context = format!("{polygon:?} in {window:?}");
    let exact = exact_polygon(polygon, window);
    let clipped = clip_polygon::<S>(polygon, window);
    assert_eq!(turned(&clipped), turned(&rounded(&exact)), "{context}");

    let mirrored: Vec<Position> = polygon.iter().map(|&(x, y)| (y, x)).collect();
    let mirrored_window: Vec<Position> = window.iter().map(|&(x, y)| (y, x)).collect();
    let mirrored = clip_polygon::<S>(&mirrored, &mirrored_window);
    let mirrored: Vec<Position> = mirrored.into_iter().map(|(x, y)| (y, x)).collect();
    assert_eq!(turned(&clipped), turned(&mirrored), "mirrored, {context}");

    // By triangles, which is independent of how parts are joined.
    let expected: i128 = (2..polygon.len())
        .map(|last| area(&exact_polygon(&[polygon[0], polygon[last - 1], polygon[last]], window)))
        .sum();
    assert_area(&clipped, &exact, expected, &context);
    clipped
}

/// The bound that the rounding of each corner by half a unit in x and y gives: half the sizes of all edges between the rounded
/// corners, and a quarter for each corner of the exact result.
fn assert_area(clipped: &[Position], exact: &[Exact], expected: i128, context: &str) {
    let mut corners = exact.to_vec();
    corners.dedup();
    let positions: Vec<Position> = corners.iter().map(Exact::nearest).collect();
    let nexts = positions.iter().cycle().skip(1);
    let length: i128 = positions
        .iter()
        .zip(nexts)
        .map(|(one, next)| i128::from(one.0.abs_diff(next.0)) + i128::from(one.1.abs_diff(next.1)))
        .sum();
    // Twice the areas, and rounded down for each edge of what they are added up from.
    let bound = ((2 * length + corners.len() as i128) << 19) + 200;
    let clipped: Vec<Exact> = clipped.iter().map(|&corner| corner.into()).collect();
    let error = (area(&clipped) - expected).abs();
    assert!(error <= bound, "area off by {error} of {bound}, {context}");
}

fn coordinate<S: AnyUnits>() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => -60..260i32,
        3 => S::MIN_UNITS..=S::MAX_UNITS,
        1 => S::LOWEST..=S::HIGHEST,
        1 => prop::sample::select(vec![S::LOWEST, S::HIGHEST, S::MIN_UNITS, S::MAX_UNITS, 0, -1]),
    ]
}

fn any_position<S: AnyUnits>() -> impl Strategy<Value = Position> {
    (coordinate::<S>(), coordinate::<S>())
}

/// A convex window with corners in a square; either orientation.
fn window_within(low: i32, high: i32) -> impl Strategy<Value = Vec<Position>> {
    (prop::collection::vec((low..=high, low..=high), 3..12), any::<bool>())
        .prop_map(|(points, is_reversed)| {
            let mut corners = hull(&points);
            if is_reversed {
                corners.reverse();
            }
            corners
        })
        .prop_filter("no area", |corners| corners.len() >= 3)
}

fn any_window<S: AnyUnits>() -> impl Strategy<Value = Vec<Position>> {
    prop_oneof![
        3 => window_within(-20, 220),
        1 => window_within(0, 6),
        1 => window_within(S::MIN_UNITS, S::MAX_UNITS),
    ]
}

fn polygon_within(low: i32, high: i32) -> impl Strategy<Value = Vec<Position>> {
    prop::collection::vec((low..=high, low..=high), 3..12)
}

proptest! {
    #![proptest_config(config(4000))]

    #[test]
    fn segments_are_exact(
        from4 in any_position::<Sub4>(), to4 in any_position::<Sub4>(), window4 in any_window::<Sub4>(),
        from8 in any_position::<Sub8>(), to8 in any_position::<Sub8>(), window8 in any_window::<Sub8>(),
    ) {
        check_segment::<Sub4>(from4, to4, &window4);
        check_segment::<Sub8>(from8, to8, &window8);
    }

    #[test]
    fn segments_in_several_windows_are_exact(
        from in (-60..260i32, -60..260i32), to in (-60..260i32, -60..260i32),
        windows4 in prop::collection::vec(window_within(-20, 220), 1..4),
        long_from in any_position::<Sub8>(), long_to in any_position::<Sub8>(),
        windows8 in prop::collection::vec(any_window::<Sub8>(), 1..4),
    ) {
        check_exactly::<Sub4>(from, to, &windows4);
        check_exactly::<Sub8>(long_from, long_to, &windows8);
    }

    /// Windows that share corners and sides: equal positions are fractions of other numbers.
    #[test]
    fn segments_in_windows_on_a_coarse_grid_are_exact(
        from in (-3..8i32, -3..8i32), to in (-3..8i32, -3..8i32),
        windows in prop::collection::vec(window_within(0, 5), 1..5),
    ) {
        check_exactly::<Sub4>(from, to, &windows);
        check_exactly::<Sub8>(from, to, &windows);
    }

    #[test]
    fn segments_through_a_corner_and_one_unit_beside_are_exact(
        window in window_within(-300, 300),
        corner in 0..12usize,
        direction in (-90..90i32, -90..90i32),
        steps in (0..12i32, 0..12i32),
        shift in (-1..=1i32, -1..=1i32),
    ) {
        let (x, y) = window[corner % window.len()];
        let (x, y) = (x + shift.0, y + shift.1);
        let from = (x - steps.0 * direction.0, y - steps.0 * direction.1);
        let to = (x + steps.1 * direction.0, y + steps.1 * direction.1);
        check_segment::<Sub4>(from, to, &window);
        check_segment::<Sub8>(from, to, &window);
    }

    /// Nearly parallel to a side and within some units of it: a unit outside would be cut again far away from there.
    #[test]
    fn segments_along_a_side_are_exact(
        window in prop_oneof![window_within(-300, 300), window_within(-9_000, 9_000)],
        side in 0..12usize,
        (before, after) in (0..4i32, 0..4i32),
        shifts in ((-4..=4i32, -4..=4i32), (-4..=4i32, -4..=4i32)),
    ) {
        let ((start_x, start_y), (end_x, end_y)) = (window[side % window.len()], window[(side + 1) % window.len()]);
        let (x, y) = ((end_x - start_x) / 4, (end_y - start_y) / 4);
        let from = (start_x - before * x + shifts.0.0, start_y - before * y + shifts.0.1);
        let to = (end_x + after * x + shifts.1.0, end_y + after * y + shifts.1.1);
        check_segment::<Sub8>(from, to, &window);
        if from.0.abs().max(from.1.abs()).max(to.0.abs()).max(to.1.abs()) < 16_000 {
            check_segment::<Sub4>(from, to, &window);
        }
    }

    /// Far from sharp corners and slivers: both ends are inside, without an exception.
    #[test]
    fn segments_clipped_again_stay_as_they_are(
        from in (-2_000..2_000i32, -2_000..2_000i32),
        to in (-2_000..2_000i32, -2_000..2_000i32),
        (x, y) in (-900..-300i32, -900..-300i32),
        shifts in prop::collection::vec(-250..=250i32, 4),
    ) {
        let corners = [(shifts[0], y), (-x, shifts[1]), (shifts[2], -y), (x, shifts[3])];
        prop_assert!(check_segment::<Sub4>(from, to, &corners));
        prop_assert!(check_segment::<Sub8>(from, to, &corners));
    }

    /// At x = 0, at y = 0 and at the diagonal. Sides that are upright or diagonal may leave ties that a mirror turns.
    #[test]
    fn mirrored_segments_are_mirrored(
        from in (-400..400i32, -400..400i32),
        to in (-400..400i32, -400..400i32),
        window in window_within(-200, 200),
    ) {
        let slopes = window.iter().zip(window.iter().cycle().skip(1)).map(|(start, end)| {
            (start.0.abs_diff(end.0), start.1.abs_diff(end.1))
        });
        prop_assume!(slopes.into_iter().all(|(x, y)| x != 0 && y != 0 && x != y));
        prop_assume!(check_segment::<Sub4>(from, to, &window));
        let clipped = clip_segment::<Sub4>(from, to, &window);
        for mirror in [|(x, y): Position| (-x, y), |(x, y): Position| (x, -y), |(x, y): Position| (y, x)] {
            let window: Vec<Position> = window.iter().copied().map(mirror).collect();
            let mirrored = clip_segment::<Sub4>(mirror(from), mirror(to), &window);
            prop_assert_eq!(mirrored, clipped.map(|(first, last)| (mirror(first), mirror(last))));
        }
    }

    /// Concave, self-crossing, with spikes: corners anywhere.
    #[test]
    fn polygons_are_exact(polygon in polygon_within(-500, 900), window in window_within(-100, 500)) {
        check_polygon::<Sub4>(&polygon, &window);
        check_polygon::<Sub8>(&polygon, &window);
    }

    /// Corners on sides, sides on sides, corners on corners.
    #[test]
    fn polygons_on_a_coarse_grid_are_exact(polygon in polygon_within(-1, 5), window in window_within(0, 4)) {
        check_polygon::<Sub4>(&polygon, &window);
        check_polygon::<Sub8>(&polygon, &window);
    }

    #[test]
    fn the_exact_capacity_is_named(polygon in polygon_within(-60, 90), window in window_within(-10, 50)) {
        let (polygon, corners) = (sub_points::<Sub4>(&polygon), sub_points::<Sub4>(&window));
        let window = ConvexWindow::new(&corners).unwrap();
        let whole = clip_corners::<_, 64, 16>(&polygon, &window).unwrap();
        fn check<const CORNERS: usize>(
            polygon: &[SubPoint<Sub4>],
            window: &ConvexWindow<'_, Sub4>,
            whole: &Bounded<SubPoint<Sub4>, 64>,
        ) {
            match clip_corners::<_, CORNERS, 16>(polygon, window) {
                Ok(part) => assert_eq!(part[..], whole[..]),
                Err(error) => {
                    assert!(whole.len() > CORNERS);
                    assert_eq!(error, TooSmall { table: Table::Corners, needed: whole.len() });
                }
            }
        }
        check::<0>(&polygon, &window, &whole);
        check::<1>(&polygon, &window, &whole);
        check::<3>(&polygon, &window, &whole);
        check::<4>(&polygon, &window, &whole);
        check::<6>(&polygon, &window, &whole);
        match clip_corners::<_, 64, 2>(&polygon, &window) {
            Ok(part) => assert_eq!(part, whole),
            Err(TooSmall { table, needed }) => {
                assert_eq!(table, Table::WindowSides);
                assert!((3..=corners.len()).contains(&needed));
            }
        }
    }

    #[test]
    fn an_upright_window_clips_once(polygon in polygon_within(-500, 900)) {
        let window = [(0, 0), (400, 0), (400, 300), (0, 300)];
        let once = clip_polygon::<Sub4>(&polygon, &window);
        prop_assert_eq!(&clip_polygon::<Sub4>(&once, &window), &once);
    }

    /// Whatever the type holds: no overflow, and what is left lies within the bounds of the window.
    #[test]
    fn polygons_of_any_size_end_in_the_window(
        polygon in prop::collection::vec(any_position::<Sub8>(), 0..8),
        window in any_window::<Sub8>(),
    ) {
        for (x, y) in clip_polygon::<Sub8>(&polygon, &window) {
            prop_assert!(window.iter().any(|corner| corner.0 <= x) && window.iter().any(|corner| corner.0 >= x));
            prop_assert!(window.iter().any(|corner| corner.1 <= y) && window.iter().any(|corner| corner.1 >= y));
        }
    }

    #[test]
    fn a_hull_is_a_window_and_a_dented_one_is_not(window in window_within(-300, 300), corner in 0..12usize) {
        let corner = corner % window.len();
        let mut twice = window.clone();
        twice.extend(&window);
        prop_assert_eq!(ConvexWindow::new(&sub_points::<Sub4>(&twice)).err(), Some(InputError::CrossingSides));
        let mut repeated = window.clone();
        repeated.insert(corner, window[corner]);
        let error = ConvexWindow::new(&sub_points::<Sub4>(&repeated)).err();
        prop_assert_eq!(error, Some(InputError::StraightCorner { corner }));
    }
}

#[test]
fn every_short_segment_is_exact() {
    for window in [
        vec![(0, 0), (4, 1), (1, 4)],
        vec![(0, 2), (2, 0), (4, 2), (2, 4)],
        vec![(1, 0), (4, 0), (5, 3), (3, 5), (0, 2)],
    ] {
        let positions = || (-2..=6).flat_map(|x| (-2..=6).map(move |y| (x, y)));
        for from in positions() {
            for to in positions() {
                check_segment::<Sub4>(from, to, &window);
            }
        }
    }
}

#[test]
fn the_longest_segments_are_exact() {
    fn check_extremes<S: AnyUnits>() {
        let values = [S::LOWEST, S::MIN_UNITS, -1, 0, 1, S::MAX_UNITS, S::HIGHEST];
        let positions = || values.into_iter().flat_map(|x| values.into_iter().map(move |y| (x, y)));
        let (low, high) = (S::MIN_UNITS, S::MAX_UNITS);
        for window in [
            vec![(low, low), (high, low + 1), (high, high), (low, high)],
            vec![(low, 0), (0, low), (high, 1), (1, high)],
            vec![(-5, 3), (77, 90), (2, 91)],
        ] {
            for from in positions() {
                for to in positions() {
                    check_segment::<S>(from, to, &window);
                }
            }
        }
    }
    check_extremes::<Sub4>();
    check_extremes::<Sub8>();
}

const SQUARE: [Position; 4] = [(0, 0), (80, 0), (80, 80), (0, 80)];

#[test]
fn a_polygon_clipped_to_itself_is_itself() {
    for window in [
        SQUARE.to_vec(),
        vec![(0, 2), (2, 0), (4, 2), (2, 4)],
        vec![(-7, 3), (90, -50), (140, 20), (33, 77)],
    ] {
        assert_eq!(check_polygon::<Sub8>(&window, &window), window);
    }
}

#[test]
fn a_polygon_around_the_window_is_the_window() {
    let around = [(-90, -90), (300, -90), (300, 300), (-90, 300)];
    assert_eq!(turned(&check_polygon::<Sub8>(&around, &SQUARE)), SQUARE);
}

/// Slivers of which rounding leaves fewer corners than they have, down to none: the area that is lost has the same bound.
#[test]
fn slivers_lose_no_more_area_than_the_bound() {
    let window = [(0, -500), (1000, -493), (1007, 500), (3, 497)];
    let (mut collapsed, mut thinned) = (0, 0);
    for start in -40..40 {
        for rise in 0..40 {
            // About a unit high in the window, or less.
            let sliver = [(-16_000, start), (16_000, start + rise), (16_000, start + rise + 1)];
            for corners in [sliver, sliver.map(|(x, y)| (y, x))] {
                let clipped = check_polygon::<Sub8>(&corners, &window);
                let exact = exact_polygon(&corners, &window);
                collapsed += usize::from(clipped.is_empty() && area(&exact) != 0);
                thinned += usize::from(!clipped.is_empty() && clipped.len() < exact.len());
            }
        }
    }
    assert!(collapsed > 800 && thinned > 3000, "{collapsed} {thinned}");
}

#[test]
fn what_only_touches_leaves_nothing() {
    // A shared side, a shared corner, a corner on a side.
    for polygon in [
        [(80, 0), (120, 0), (120, 80), (80, 80)],
        [(80, 80), (120, 80), (120, 120), (80, 120)],
        [(80, 40), (120, 20), (140, 40), (120, 60)],
    ] {
        let clipped = check_polygon::<Sub8>(&polygon, &SQUARE);
        let exact: Vec<Exact> = clipped.iter().map(|&corner| corner.into()).collect();
        assert_eq!(area(&exact), 0, "{polygon:?}");
    }
}

/// A `U` upside down whose legs are in the window: two parts, and a bridge along the upper side between them.
#[test]
fn parts_are_joined_by_a_bridge() {
    let polygon = [
        (10, -40),
        (70, -40),
        (70, 60),
        (50, 60),
        (50, -20),
        (30, -20),
        (30, 60),
        (10, 60),
    ];
    let clipped = check_polygon::<Sub8>(&polygon, &SQUARE);
    let expected = [
        (10, 0),
        (70, 0),
        (70, 60),
        (50, 60),
        (50, 0),
        (30, 0),
        (30, 60),
        (10, 60),
    ];
    assert_eq!(turned(&clipped), turned(&expected));
}

#[test]
fn a_polygon_that_reaches_around_leaves_a_bridge_at_most() {
    let around = [
        (-20, -20),
        (100, -20),
        (100, 100),
        (90, 100),
        (90, -10),
        (-10, -10),
        (-10, 100),
        (-20, 100),
    ];
    let clipped = check_polygon::<Sub8>(&around, &SQUARE);
    let exact: Vec<Exact> = clipped.iter().map(|&corner| corner.into()).collect();
    assert_eq!(area(&exact), 0);
}

#[test]
fn what_is_no_polygon_leaves_nothing() {
    for polygon in [
        vec![],
        vec![(5, 5)],
        vec![(5, 5), (20, 30)],
        vec![(5, 5); 7],
        vec![(-50, 40), (200, 41)],
    ] {
        assert_eq!(clip_polygon::<Sub4>(&polygon, &SQUARE), [], "{polygon:?}");
    }
}

/// Every cut of this sliver along the slanted side is far from both of its ends, and rounds by itself.
#[test]
fn no_cut_works_with_a_rounded_one() {
    let sliver = [(-16_000, -3), (16_000, 2), (16_000, 3)];
    let window = [(0, -100), (1000, -100), (1001, 100), (1, 99)];
    check_polygon::<Sub4>(&sliver, &window);
    check_polygon::<Sub8>(&sliver, &window);
}

/// The exception in rounding inwards: no unit around the exact ends lies in these windows, which are about a unit wide there.
#[test]
fn where_no_unit_is_inside_the_nearest_one_beyond_the_side_stays() {
    let check = |(from, to), window: &[Position], expected: (Position, Position), again| {
        assert!(!check_segment::<Sub4>(from, to, window));
        assert!(!check_segment::<Sub8>(from, to, window));
        let clipped = clip_segment::<Sub8>(from, to, window);
        assert_eq!(clipped, Some(expected));
        assert_eq!(clip_segment::<Sub8>(expected.0, expected.1, window), again);
    };
    // Along a sliver: cut again.
    let quadrangle = [(0, 16), (33, 20), (32, 21), (22, 25)];
    let (end, outside) = ((3, 17), (2, 16));
    check(((21, 56), (-8, -4)), &quadrangle, (end, outside), Some((end, end)));
    // Across a sharp corner: both ends are nearest to (15, 8), and of that nothing would be in the window.
    let (triangle, across) = ([(14, 7), (28, 24), (28, 27)], ((14, 8), (15, 8)));
    check(((-16, 30), (32, -4)), &triangle, across, Some(across));
}

/// Along x and along y.
fn is_within_a_unit(point: Exact, (x, y): Position) -> bool {
    let near = |exact: i128, unit: i32| (exact - i128::from(unit) * point.w).abs() <= point.w;
    near(point.x, x) && near(point.y, y)
}

/// What the module says of this triangle: every pair of units within one unit of the exact ends, the boundary included, is
/// dropped or cut off further away.
#[test]
fn no_rule_keeps_both_ends_near_in_every_window() {
    let (from, to, window) = ((6, 5), (-1, -1), [(0, 0), (5, 4), (6, 5)]);
    let (first, last) = exact_segment(from, to, &window).unwrap();
    assert_eq!((first, last), (Exact::from(from), Exact { x: 5, y: 4, w: 2 }));
    let near = |point: Exact| {
        let positions = (-2..9).flat_map(|x| (-2..9).map(move |y| (x, y)));
        positions.filter(move |&position| is_within_a_unit(point, position))
    };
    assert_eq!((near(first).count(), near(last).count()), (9, 6));
    for (one, other) in near(first).flat_map(|one| near(last).map(move |other| (one, other))) {
        let again = exact_segment(one, other, &window);
        assert!(again.is_none_or(|(first, last)| !is_within_a_unit(first, one) || !is_within_a_unit(last, other)));
    }
}

/// Triangles less than two units wide, and segments across and along them.
#[test]
fn slivers_are_seldom_lost_when_they_are_clipped_again() {
    let mut number = 1u32;
    let mut random = |from: i32, to: i32| {
        number = number.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        from + (number >> 8) as i32 % (to - from)
    };
    let (mut exceptions, mut changed, mut dropped) = (0, 0, 0);
    // What is not rounded is the same again in all of them, as `check_segment` sees to.
    for _ in 0..20_000 {
        let size = [6, 12, 60, 900][random(0, 4) as usize];
        let [one, other] = [0, 1].map(|_| (random(-size, size), random(-size, size)));
        let part = random(0, 16);
        let beside = |from: i32, to: i32, shift: i32| from + (to - from) * part / 16 + shift;
        let third = (
            beside(one.0, other.0, random(-2, 3)),
            beside(one.1, other.1, random(-2, 3)),
        );
        let window = hull(&[one, other, third]);
        if window.len() < 3 {
            continue;
        }
        let (from, to) = if random(0, 2) == 0 {
            let end =
                |random: &mut dyn FnMut(i32, i32) -> i32| (random(-2 * size, 2 * size), random(-2 * size, 2 * size));
            (end(&mut random), end(&mut random))
        } else {
            let end =
                |(x, y): Position, random: &mut dyn FnMut(i32, i32) -> i32| (x + random(-3, 4), y + random(-3, 4));
            (end(one, &mut random), end(other, &mut random))
        };
        if check_segment::<Sub8>(from, to, &window) {
            continue;
        }
        exceptions += 1;
        let once = clip_segment::<Sub8>(from, to, &window).unwrap();
        match clip_segment::<Sub8>(once.0, once.1, &window) {
            None => dropped += 1,
            Some(again) => changed += usize::from(again != once),
        }
    }
    assert!(
        exceptions > 1_000 && dropped * 100 < exceptions,
        "{dropped} of {exceptions}, {changed} changed"
    );
}
