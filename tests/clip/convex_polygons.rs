//! Polygons against any convex window, by every clipper of the registry, against exact rationals.

use heapless::Vec as Bounded;
use proptest::prelude::*;
use zrow::geometry::{ConvexWindow, Sub4, Sub8, SubPixel, SubPoint, TooSmall};

use crate::{
    any_units::AnyUnits,
    common::{cases, config},
    convex_windows::{any_position, any_window, position, sub_points, window_within},
    reference::convex_parts::{Exact, Position, area, exact_polygon, rounded},
};

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

/// Turned so that it starts with its smallest sequence.
fn turned(positions: &[Position]) -> Vec<Position> {
    let turn = |start: usize| [&positions[start..], &positions[..start]].concat();
    (0..positions.len()).map(turn).min().unwrap_or_default()
}

fn polygon_within(low: i32, high: i32) -> impl Strategy<Value = Vec<Position>> {
    prop::collection::vec((low..=high, low..=high), 3..12)
}

proptest! {
    #![proptest_config(config(cases(4_000, 4_000)))]

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
                    assert_eq!(error, TooSmall::Corners(whole.len()));
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
            Err(TooSmall::WindowSides(needed)) => assert!((3..=corners.len()).contains(&needed)),
            Err(error) => panic!("{error}"),
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
