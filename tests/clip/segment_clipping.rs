//! All segment clippers against exact rationals in `i128`, and so against each other.

use proptest::prelude::*;
use zrow::{
    clip::Segments,
    geometry::{ConvexWindow, FixedPointWindow, Sub4, Sub8, SubPixel, SubPoint, Window},
};

use crate::{
    any_units::{AnyUnits, sub_point},
    common::{cases, config},
};

/// Coordinates and window in units: `(x, y)` and `[left, top, right, bottom]`, sides included.
type Position = (i32, i32);

type Sides = [i32; 4];

fn fixed_point_window<S: AnyUnits>([left, top, right, bottom]: Sides) -> FixedPointWindow<S> {
    FixedPointWindow::new(sub_point((left, top)), sub_point((right, bottom))).unwrap()
}

/// An exact point `(x, y) / denominator`, and how far along the segment it is: `along / denominator`.
#[derive(Clone, Copy)]
struct Exact {
    x: i128,
    y: i128,
    along: i128,
    denominator: i128,
}

impl Exact {
    fn nearest(&self) -> Position {
        let nearest = |numerator: i128| {
            let nearest = (2 * numerator + self.denominator).div_euclid(2 * self.denominator);
            i32::try_from(nearest).unwrap()
        };
        (nearest(self.x), nearest(self.y))
    }

    fn is_inside(&self, [left, top, right, bottom]: Sides) -> bool {
        let between = |first: i32, value: i128, last: i32| {
            i128::from(first) * self.denominator <= value && value <= i128::from(last) * self.denominator
        };
        between(left, self.x, right) && between(top, self.y, bottom)
    }
}

/// Both ends of the segment and every crossing with the line through a side.
fn candidates(from: Position, to: Position, [left, top, right, bottom]: Sides) -> Vec<Exact> {
    let (x, y) = (i128::from(from.0), i128::from(from.1));
    let (dx, dy) = (i128::from(to.0) - x, i128::from(to.1) - y);
    let at = |along: i128, denominator: i128| Exact {
        x: x * denominator + along * dx,
        y: y * denominator + along * dy,
        along,
        denominator,
    };
    let mut points = vec![at(0, 1), at(1, 1)];
    for (side, start, delta) in [(left, x, dx), (right, x, dx), (top, y, dy), (bottom, y, dy)] {
        let along = (i128::from(side) - start) * delta.signum();
        if delta != 0 && (0..=delta.abs()).contains(&along) {
            points.push(at(along, delta.abs()));
        }
    }
    points
}

/// The first and the last point of the segment that are in the window, by trying them all.
fn exact_clip(from: Position, to: Position, sides: Sides) -> Option<(Exact, Exact)> {
    let inside = || {
        candidates(from, to, sides)
            .into_iter()
            .filter(|point| point.is_inside(sides))
    };
    let order = |one: &Exact, other: &Exact| (one.along * other.denominator).cmp(&(other.along * one.denominator));
    Some((inside().min_by(order)?, inside().max_by(order)?))
}

/// Whether segment and window share a point: no axis and no side of the line separates them.
fn exact_meets(from: Position, to: Position, [left, top, right, bottom]: Sides) -> bool {
    let wide = i128::from;
    let side_of_line = |x: i32, y: i32| {
        (wide(to.0) - wide(from.0)) * (wide(y) - wide(from.1)) - (wide(to.1) - wide(from.1)) * (wide(x) - wide(from.0))
    };
    let corners = [(left, top), (right, top), (left, bottom), (right, bottom)];
    left <= right
        && top <= bottom
        && from.0.max(to.0) >= left
        && from.0.min(to.0) <= right
        && from.1.max(to.1) >= top
        && from.1.min(to.1) <= bottom
        && corners.iter().any(|&(x, y)| side_of_line(x, y) >= 0)
        && corners.iter().any(|&(x, y)| side_of_line(x, y) <= 0)
}

fn units<S: SubPixel>((start, end): (SubPoint<S>, SubPoint<S>)) -> (Position, Position) {
    ((start.x_units(), start.y_units()), (end.x_units(), end.y_units()))
}

type Segment<S> = (SubPoint<S>, SubPoint<S>);
type Clipper<S> = fn(SubPoint<S>, SubPoint<S>, &FixedPointWindow<S>) -> Option<Segment<S>>;

fn clippers<S: SubPixel>() -> Vec<(&'static str, Clipper<S>)> {
    macro_rules! clippers {
        ($([$name:ident] [$($clip:tt)+])+) => {
            vec![$((stringify!($name), $($clip)+ as Clipper<S>)),+]
        };
    }
    let mut clippers = zrow_methods::segments!(clippers);
    clippers.extend::<[(_, Clipper<S>); 2]>([
        ("convex window", |from, to, window| {
            clip_in_corners(from, to, window, false)
        }),
        ("convex window, reversed", |from, to, window| {
            clip_in_corners(from, to, window, true)
        }),
    ]);
    clippers
}

/// Clips against the convex window of the corners, by every clipper that the registry has. A window without an area has no
/// corners, and is left to the clippers of upright windows.
fn clip_in_corners<S: SubPixel>(
    from: SubPoint<S>,
    to: SubPoint<S>,
    window: &FixedPointWindow<S>,
    is_reversed: bool,
) -> Option<Segment<S>> {
    let (first, last) = (window.top_left(), window.bottom_right());
    if first.x >= last.x || first.y >= last.y {
        return Segments::liang_barsky(from, to, window);
    }
    let corner = |x, y| SubPoint { x, y };
    let mut corners = [first, corner(last.x, first.y), last, corner(first.x, last.y)];
    if is_reversed {
        corners.reverse();
    }
    let window = ConvexWindow::new(&corners).unwrap();
    macro_rules! clip_by_each {
        ($([$name:ident] [$($clip:tt)+])+) => {
            [$((stringify!($name), $($clip)+(from, to, &window))),+]
        };
    }
    let [(_, first), others @ ..] = zrow_methods::convex_segments!(clip_by_each);
    for (name, other) in others {
        assert_eq!(other, first, "{name}");
    }
    let clipped = first?;
    assert_eq!(clipped.clip(&window), Some(clipped));
    assert_eq!(clipped.ends(), clipped.ends_within(&window));
    Some(clipped.ends())
}

/// Checks one segment and returns what is left of it.
fn check<S: AnyUnits>(from: Position, to: Position, sides: Sides) -> Option<(Position, Position)> {
    let window = fixed_point_window::<S>(sides);
    let (start, end) = (sub_point::<S>(from), sub_point::<S>(to));

    let exact = exact_clip(from, to, sides);
    let context = || format!("{from:?} to {to:?} in {sides:?}");
    assert_eq!(
        exact.is_some(),
        exact_meets(from, to, sides),
        "references, {}",
        context()
    );
    let expected = exact.map(|(first, last)| (first.nearest(), last.nearest()));
    for (name, clip) in clippers::<S>() {
        let clipped = clip(start, end, &window);
        assert_eq!(clipped.map(units), expected, "{name}, {}", context());
        let swapped = clip(end, start, &window).map(|(start, end)| (end, start));
        assert_eq!(swapped, clipped, "{name} swapped, {}", context());
        if let Some((start, end)) = clipped {
            assert!(
                window.contains(&start) && window.contains(&end),
                "{name}, {}",
                context()
            );
            assert_eq!(clip(start, end, &window), clipped, "{name} again, {}", context());
        }
    }
    expected
}

/// Near the window, anywhere in the domain, and anything that the type holds.
fn coordinate<S: AnyUnits>() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => -60..260i32,
        3 => S::MIN_UNITS..=S::MAX_UNITS,
        1 => S::LOWEST..=S::HIGHEST,
        1 => prop::sample::select(vec![S::LOWEST, S::HIGHEST, S::MIN_UNITS, S::MAX_UNITS, 0, -1]),
    ]
}

fn position<S: AnyUnits>() -> impl Strategy<Value = Position> {
    (coordinate::<S>(), coordinate::<S>())
}

fn sides<S: AnyUnits>() -> impl Strategy<Value = Sides> {
    let sorted =
        |low: i32, high: i32| (low..=high, low..=high).prop_map(|(one, other)| (one.min(other), one.max(other)));
    let range =
        move |low: i32, high: i32| (sorted(low, high), sorted(low, high)).prop_map(|(x, y)| [x.0, y.0, x.1, y.1]);
    prop_oneof![
        3 => range(-20, 220),
        1 => range(S::MIN_UNITS, S::MAX_UNITS),
        1 => Just([S::MIN_UNITS, S::MIN_UNITS, S::MAX_UNITS, S::MAX_UNITS]),
    ]
}

/// A segment through a corner, from outside to outside; shifted by some units.
fn check_corner<S: AnyUnits>(
    sides: Sides,
    (corner, steps_before, steps_after): (usize, i32, i32),
    (dx, dy): (i32, i32),
    shift: i32,
) {
    let [left, top, right, bottom] = sides;
    // The direction that leaves the window on both sides of the corner.
    let ((x, y), (dx, dy)) = [
        ((left, top), (dx, -dy)),
        ((right, top), (dx, dy)),
        ((left, bottom), (dx, dy)),
        ((right, bottom), (dx, -dy)),
    ][corner];
    let from = (x - steps_before * dx + shift, y - steps_before * dy);
    let to = (x + steps_after * dx + shift, y + steps_after * dy);
    let clipped = check::<S>(from, to, sides);
    if shift == 0 {
        assert_eq!(clipped, Some(((x, y), (x, y))), "{from:?} to {to:?} in {sides:?}");
    } else {
        let inwards = (shift > 0) == (x == left);
        assert_eq!(clipped.is_some(), inwards, "{from:?} to {to:?} in {sides:?}");
    }
}

/// Mirrored at x = 0: ties go the other way, so the mirrored ends may differ by one unit.
fn check_mirrored<S: AnyUnits>(from: Position, to: Position, sides: Sides) {
    let [left, top, right, bottom] = sides;
    let clipped = check::<S>(from, to, sides);
    let mirrored = check::<S>((-from.0, from.1), (-to.0, to.1), [-right, top, -left, bottom]);
    assert_eq!(clipped.is_some(), mirrored.is_some());
    if let (Some((start, end)), Some((start_mirrored, end_mirrored))) = (clipped, mirrored) {
        for (one, other) in [(start, start_mirrored), (end, end_mirrored)] {
            assert_eq!(one.1, other.1);
            assert!((0..=1).contains(&(one.0 + other.0)), "{one:?} {other:?}");
        }
    }
}

proptest! {
    #![proptest_config(config(cases(6_000, 6_000)))]

    #[test]
    fn sub4_is_exact(from in position::<Sub4>(), to in position::<Sub4>(), sides in sides::<Sub4>()) {
        check::<Sub4>(from, to, sides);
    }

    #[test]
    fn sub8_is_exact(from in position::<Sub8>(), to in position::<Sub8>(), sides in sides::<Sub8>()) {
        check::<Sub8>(from, to, sides);
    }

    #[test]
    fn a_segment_through_a_corner_leaves_the_corner(
        corner in (0..4usize, 1..12i32, 1..12i32),
        direction in (1..90i32, 1..90i32),
        shift in -1..=1i32,
    ) {
        let sides = [-100, 50, 1900, 1700];
        check_corner::<Sub4>(sides, corner, direction, shift);
        check_corner::<Sub8>(sides, corner, direction, shift);
    }

    #[test]
    fn a_long_segment_through_a_corner_leaves_the_corner(
        corner in (0..4usize, 1..=7i32, 1..=7i32),
        direction in (1..200_000i32, 1..200_000i32),
        shift in -1..=1i32,
    ) {
        check_corner::<Sub8>([-400_000, -300_000, 500_000, 600_000], corner, direction, shift);
    }

    #[test]
    fn a_mirrored_segment_differs_by_a_tie_at_most(
        from in (-16_368..=16_368i32, -16_368..=16_368i32),
        to in (-400..=400i32, -400..=400i32),
        sides in sides::<Sub4>(),
    ) {
        let sides = sides.map(|side| side.max(-Sub4::MAX_UNITS));
        check_mirrored::<Sub4>(from, to, sides);
        check_mirrored::<Sub8>(from, to, sides);
    }
}

/// Ends on every corner and side, zero length, along a side, parallel to one: all of them in a small world.
#[test]
fn every_short_segment_is_exact() {
    for sides in [
        [0, 0, 4, 3],
        [0, 1, 4, 1],
        [2, 0, 2, 3],
        [1, 2, 1, 2],
        [3, 0, 1, 3],
        [0, 3, 4, 2],
    ] {
        let positions = || (-3..=7).flat_map(|x| (-3..=6).map(move |y| (x, y)));
        for from in positions() {
            for to in positions() {
                check::<Sub4>(from, to, sides);
            }
        }
    }
}

#[test]
fn the_longest_segments_are_exact() {
    fn check_extremes<S: AnyUnits>() {
        let values = [S::LOWEST, S::MIN_UNITS, -1, 0, 1, S::MAX_UNITS, S::HIGHEST];
        let positions = || values.into_iter().flat_map(|x| values.into_iter().map(move |y| (x, y)));
        for from in positions() {
            for to in positions() {
                check::<S>(from, to, [S::MIN_UNITS, S::MIN_UNITS, S::MAX_UNITS, S::MAX_UNITS]);
                check::<S>(from, to, [-5, 3, 77, 90]);
            }
        }
    }
    check_extremes::<Sub4>();
    check_extremes::<Sub8>();
}

#[test]
fn a_segment_over_a_display_keeps_what_is_on_it() {
    let pixels = Window {
        left: 0,
        top: 0,
        right: 128,
        bottom: 64,
    };
    let window = FixedPointWindow::<Sub4>::over_areas(&pixels).unwrap();
    // Diagonal, y = x + 10.5 px: in through the left edge of column 0, out through the lower edge of row 63.
    let from = SubPoint::from_units(-16 * 100, -16 * 89 - 8).unwrap();
    let to = SubPoint::from_units(16 * 100, 16 * 110 + 8).unwrap();
    let (start, end) = Segments::liang_barsky(from, to, &window).unwrap();
    assert_eq!(units((start, end)), ((-8, 160), (16 * 53, 16 * 63 + 8)));
}
