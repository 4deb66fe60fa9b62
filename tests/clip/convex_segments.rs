//! Segments against any convex window, by every clipper of the registry: exactly, and rounded inwards.

use proptest::prelude::*;
use zrow::{
    clip::ParametricSegment,
    geometry::{ConvexWindow, Sub4, Sub8, SubPixel, SubPoint},
};

use crate::{
    any_units::{AnyUnits, sub_point},
    common::{cases, config},
    convex_windows::{any_position, any_window, hull, position, sub_points, window_within},
    reference::convex_parts::{Exact, Position, Side, exact_part, exact_segment, sides},
};

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

proptest! {
    #![proptest_config(config(cases(4_000, 4_000)))]

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

    /// An upright window around another one rounds as that with a corner more does, which no end is near: away from the side
    /// that cuts, which is a side of the inner window.
    #[test]
    fn an_upright_window_rounds_away_from_the_side_that_cuts(
        from in (0..=8i32, 0..=8i32), to in (0..=8i32, 0..=8i32),
        window in window_within(0, 8),
    ) {
        let clip = |outer: &[Position]| {
            let part = clip_exactly::<Sub4>(from, to, &[window.clone(), outer.to_vec()])?;
            let (start, end) = part.ends_within(&ConvexWindow::new(&sub_points(outer)).unwrap());
            Some((position(start), position(end)))
        };
        let upright = [(0, 0), (8, 0), (8, 8), (0, 8)];
        let with_a_corner_more = [(0, 0), (8, 0), (8, 8), (4, 9), (0, 8)];
        prop_assert_eq!(clip(&upright), clip(&with_a_corner_more));
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

/// Two crossings that lie far from both ends of a segment over nearly all of the number range.
#[test]
fn crossings_with_the_longest_numbers_are_exact() {
    let window = [
        (-1_419_389, -2_011_732),
        (1_699_841, -2_053_943),
        (956_397, 1_790_810),
        (-953_190, 1_650_757),
    ];
    check_exactly::<Sub8>((67, -1_602_788_689), (-44, i32::MAX), &[window.to_vec()]);
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
