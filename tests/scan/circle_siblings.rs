//! Thin circles and ellipses against each other and against the nearest-pixel rule, pixel by pixel, in `i128`.

use std::collections::BTreeSet;

use embedded_graphics::{prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    geometry::{InputError, Window},
    scan::Conics,
};
use zrow_methods::registry::{Agrees, Algorithm, CIRCLES, ELLIPSES};

use crate::common::{by_depth, cases, config};

// ---- The references: each pixel is asked by itself ----

/// Whether `y` is the integer nearest to `b / a sqrt(a^2 - x^2)`: the exact height is between `y - 1/2` and `y + 1/2`.
fn is_nearest(x: i128, y: i128, a: i128, b: i128) -> bool {
    if x > a || y > b {
        return false;
    }
    if a == 0 {
        return y == b;
    }
    let square = 4 * b * b * (a * a - x * x);
    let below = |doubled: i128| a * a * doubled * doubled;
    let above_lower_half = y == 0 || square > below(2 * y - 1);
    assert!(y == 0 || square != below(2 * y - 1), "a tie at column {x} of {a} x {b}");
    above_lower_half && square < below(2 * y + 1)
}

/// Whether a column's pixel belongs: the ellipse in its middle, or the pixel, is on the flat side of the diagonal.
fn is_flat(x: i128, y: i128, a: i128, b: i128) -> bool {
    let exact = x * x * (a * a + b * b) <= a * a * a * a;
    exact || b * b * x <= a * a * y
}

fn on_ellipse(center: Point, radii: Size, pixel: Point) -> bool {
    let x = (i128::from(pixel.x) - i128::from(center.x)).abs();
    let y = (i128::from(pixel.y) - i128::from(center.y)).abs();
    let (a, b) = (i128::from(radii.width), i128::from(radii.height));
    let of_column = is_nearest(x, y, a, b) && is_flat(x, y, a, b);
    let of_row = is_nearest(y, x, b, a) && is_flat(y, x, b, a);
    of_column || of_row
}

/// The octant from the top to the diagonal has the columns x <= y.
fn on_circle(center: Point, radius: u32, pixel: Point) -> bool {
    let dx = (i128::from(pixel.x) - i128::from(center.x)).abs();
    let dy = (i128::from(pixel.y) - i128::from(center.y)).abs();
    let radius = i128::from(radius);
    is_nearest(dx.min(dy), dx.max(dy), radius, radius)
}

/// Whether a point of the ellipse, moved by up to 1/64 pixel, is in the closed square around a pixel: of the square, enlarged by
/// that much, one corner is inside the ellipse and one outside.
fn is_passed(center: Point, radii: Size, pixel: Point) -> bool {
    // In 1/64 pixels.
    let distance = |at: i32, center: i32| 64 * (i128::from(at) - i128::from(center)).abs();
    let (x, y) = (distance(pixel.x, center.x), distance(pixel.y, center.y));
    let (a, b) = (64 * i128::from(radii.width), 64 * i128::from(radii.height));
    let side = |x: i128, y: i128| b * b * x * x + a * a * y * y - a * a * b * b;
    let near = |at: i128| (at - 33).max(0);
    side(near(x), near(y)) <= 0 && side(x + 33, y + 33) >= 0 && near(x) <= a && near(y) <= b
}

// ---- The algorithms ----

type Circle = fn(Point, u32, &Window) -> Result<Vec<Point>, InputError>;

type Ellipse = fn(Point, Size, &Window) -> Result<Vec<Point>, InputError>;

/// Collects the pixels of an outline.
macro_rules! outline {
    ($($draw:tt)+) => {
        |center, size, window| $($draw)+(center, size, window).map(|points| points.collect())
    };
}

/// Name and function of those algorithms of a registered family that have the pixels of its default for every radius.
fn exact<F: Copy>(family: &'static [Algorithm], functions: &[F]) -> Vec<(&'static str, F)> {
    let each = family.iter().zip(functions);
    let exact = each.filter(|(algorithm, _)| algorithm.agrees == Agrees::Always);
    exact.map(|(algorithm, function)| (algorithm.name, *function)).collect()
}

/// Name and function of the circles with the nearest pixels.
fn exact_circles() -> Vec<(&'static str, Circle)> {
    macro_rules! circles {
        ($([$name:ident] [$($draw:tt)+])+) => {
            exact::<Circle>(CIRCLES, &[$(outline!($($draw)+)),+])
        };
    }
    zrow_methods::circles!(circles)
}

/// Name and function of the ellipses with the nearest pixels.
fn exact_ellipses() -> Vec<(&'static str, Ellipse)> {
    macro_rules! ellipses {
        ($([$name:ident] [$($draw:tt)+])+) => {
            exact::<Ellipse>(ELLIPSES, &[$(outline!($($draw)+)),+])
        };
    }
    zrow_methods::ellipses!(ellipses)
}

/// The largest radii, as their errors name them.
const MAX_CIRCLE: u32 = i32::MAX as u32;

const MAX_ELLIPSE: u32 = (1 << 19) - 1;
const MAX_PARAMETRIC: u32 = (1 << 15) - 1;

const PARAMETRIC_CIRCLE: Circle = outline!(Conics::parametric_circle);
const PARAMETRIC_ELLIPSE: Ellipse = outline!(Conics::parametric_ellipse);

const ALL: Window = Window {
    left: i32::MIN,
    top: i32::MIN,
    right: i32::MAX,
    bottom: i32::MAX,
};

/// Row by row; a pixel that comes twice fails.
fn sorted(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by_key(|point| (point.y, point.x));
    assert!(points.windows(2).all(|pair| pair[0] != pair[1]), "a pixel came twice");
    points
}

fn window_of(left: i32, top: i32, width: u32, height: u32) -> Window {
    Rectangle::new(Point::new(left, top), Size::new(width, height)).into()
}

fn pixels_where(window: &Window, belongs: impl Fn(Point) -> bool) -> Vec<Point> {
    let pixels = window.to_rectangle().points();
    pixels.filter(|&pixel| belongs(pixel)).collect()
}

fn check_circles(center: Point, radius: u32, window: Window) {
    let expected = pixels_where(&window, |pixel| on_circle(center, radius, pixel));
    for (name, circle) in exact_circles() {
        let drawn = sorted(circle(center, radius, &window).unwrap());
        assert_eq!(drawn, expected, "{name}: radius {radius} about {center} in {window:?}");
    }
}

fn check_ellipses(center: Point, radii: Size, window: Window) {
    let expected = pixels_where(&window, |pixel| on_ellipse(center, radii, pixel));
    for (name, ellipse) in exact_ellipses() {
        let drawn = sorted(ellipse(center, radii, &window).unwrap());
        assert_eq!(drawn, expected, "{name}: {radii} about {center} in {window:?}");
    }
}

fn whole(radii: Size) -> Window {
    let corner = Point::new(-1 - radii.width as i32, -1 - radii.height as i32);
    window_of(corner.x, corner.y, 2 * radii.width + 3, 2 * radii.height + 3)
}

/// 8-connected, and symmetric about both axes.
fn assert_connected(points: &[Point], context: &str) {
    let pixels: BTreeSet<(i32, i32)> = points.iter().map(|point| (point.x, point.y)).collect();
    let mut reached = BTreeSet::new();
    let mut open = vec![(points[0].x, points[0].y)];
    while let Some((x, y)) = open.pop() {
        if !pixels.contains(&(x, y)) || !reached.insert((x, y)) {
            continue;
        }
        for mirrored in [(-x, y), (x, -y)] {
            assert!(pixels.contains(&mirrored), "{mirrored:?} of {context}");
        }
        open.extend((-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy))));
    }
    assert!(reached == pixels, "{context} is in one piece");
}

/// Nowhere between the axes a pixel between two that touch at a corner.
fn assert_thin(points: &[Point], context: &str) {
    let pixels: BTreeSet<(i32, i32)> = points.iter().map(|point| (point.x, point.y)).collect();
    for &(x, y) in pixels.iter().filter(|(x, y)| *x > 0 && *y > 0) {
        let is_corner = pixels.contains(&(x - 1, y)) && pixels.contains(&(x, y - 1));
        let is_inner = pixels.contains(&(x + 1, y)) && pixels.contains(&(x, y + 1));
        assert!(!(is_corner || is_inner), "({x}, {y}) of {context}");
    }
}

fn check_parametric(radii: Size, window: Window, drawn: Vec<Point>) {
    let drawn = sorted(drawn);
    for &pixel in &drawn {
        assert!(is_passed(Point::zero(), radii, pixel), "{pixel} of {radii}");
        assert!(window.contains(pixel));
    }
    assert_connected(&drawn, &format!("{radii}"));
    assert_thin(&drawn, &format!("{radii}"));
    // The four points on the axes.
    let (a, b) = (radii.width as i32, radii.height as i32);
    for end in [(a, 0), (-a, 0), (0, b), (0, -b)] {
        assert!(drawn.contains(&Point::new(end.0, end.1)), "{end:?} of {radii}");
    }
}

// ---- Every small one ----

#[test]
fn small_circles_have_the_nearest_pixels() {
    for radius in 0..=70 {
        check_circles(Point::zero(), radius, whole(Size::new_equal(radius)));
        let whole = whole(Size::new_equal(radius));
        let points: Vec<Point> = Conics::midpoint_circle(Point::zero(), radius, &whole)
            .unwrap()
            .collect();
        assert_connected(&points, &format!("radius {radius}"));
    }
}

#[test]
fn small_ellipses_have_the_nearest_pixels_in_one_piece() {
    for width in 0..=40 {
        for height in 0..=40 {
            let radii = Size::new(width, height);
            check_ellipses(Point::zero(), radii, whole(radii));
            let points: Vec<Point> = Conics::midpoint_ellipse(Point::zero(), radii, &whole(radii))
                .unwrap()
                .collect();
            assert_connected(&points, &format!("{radii}"));
        }
    }
}

#[test]
fn longer_ellipses_agree_are_connected_and_have_their_tips() {
    for width in (41..=260).step_by(by_depth(27, 9, 3)) {
        for height in [0, 1, 2, 3, 5, 11, 40, 77, 150, 255, 256, 260] {
            for radii in [Size::new(width, height), Size::new(height, width)] {
                let midpoint: Vec<Point> = Conics::midpoint_ellipse(Point::zero(), radii, &whole(radii))
                    .unwrap()
                    .collect();
                for (name, ellipse) in exact_ellipses() {
                    let pixels = ellipse(Point::zero(), radii, &whole(radii)).unwrap();
                    assert_eq!(pixels, midpoint, "{name}: {radii}");
                }
                assert_connected(&sorted(midpoint.clone()), &format!("{radii}"));
                assert!(midpoint.contains(&Point::new(radii.width as i32, 0)));
                assert!(midpoint.contains(&Point::new(0, radii.height as i32)));
                assert!(midpoint.iter().all(|&pixel| on_ellipse(Point::zero(), radii, pixel)));
            }
        }
    }
}

#[test]
fn an_ellipse_with_equal_axes_is_the_circle() {
    for radius in (0..400).chain([1_000, 32_767, 65_536]) {
        let radii = Size::new_equal(radius);
        let circle: Vec<Point> = Conics::midpoint_circle(Point::zero(), radius, &ALL).unwrap().collect();
        let ellipse: Vec<Point> = Conics::midpoint_ellipse(Point::zero(), radii, &ALL).unwrap().collect();
        assert_eq!(circle, ellipse, "radius {radius}");
    }
}

#[test]
fn parametric_circles_are_thin_connected_and_on_the_circle() {
    for radius in (0..=130)
        .step_by(by_depth(5, 1, 1))
        .chain([1_000, 4_095, 20_011].into_iter().step_by(by_depth(3, 1, 1)))
        .chain(32_767 - cases(0, 7)..=32_767)
    {
        let radii = Size::new_equal(radius);
        let drawn = PARAMETRIC_CIRCLE(Point::zero(), radius, &ALL).unwrap();
        let pixels: BTreeSet<(i32, i32)> = drawn.iter().map(|point| (point.x, point.y)).collect();
        assert!(pixels.iter().all(|&(x, y)| pixels.contains(&(y, x))), "radius {radius}");
        check_parametric(radii, ALL, drawn);
    }
}

#[test]
fn parametric_ellipses_are_thin_connected_and_on_the_ellipse() {
    for width in (0..=40).step_by(by_depth(8, 2, 1)).chain([100, 1_000, 32_767]) {
        for height in (0..=40).step_by(by_depth(4, 1, 1)).chain([99, 731, 32_766]) {
            if width + height < 200 || height % 7 == 4 {
                let radii = Size::new(width, height);
                let drawn = PARAMETRIC_ELLIPSE(Point::zero(), radii, &ALL).unwrap();
                check_parametric(radii, ALL, drawn);
            }
        }
    }
}

/// What the documentation says about how often the parametric circle has another pixel.
#[test]
fn a_parametric_circle_differs_by_neighbours() {
    let (mut all, mut differing) = (0, 0);
    for radius in 0..=200 {
        let [exact, sampled] = [outline!(Conics::bresenham_circle) as Circle, PARAMETRIC_CIRCLE].map(|circle| {
            let points = circle(Point::zero(), radius, &ALL).unwrap();
            points
                .into_iter()
                .map(|point| (point.x, point.y))
                .collect::<BTreeSet<_>>()
        });
        for &(x, y) in sampled.difference(&exact) {
            let beside = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
            assert!(
                beside.iter().any(|pixel| exact.contains(pixel)),
                "({x}, {y}) of {radius}"
            );
        }
        all += sampled.len();
        differing += sampled.difference(&exact).count();
    }
    let part = differing as f64 / all as f64;
    assert!((0.07..0.09).contains(&part), "{part}");
}

// ---- Windows, and numbers over their whole type ----

fn any_window() -> impl Strategy<Value = Window> {
    prop_oneof![
        Just(window_of(0, 0, 48, 40)),
        (0..40i32).prop_map(|y| window_of(0, y, 48, 1)),
        (0..48i32).prop_map(|x| window_of(x, 0, 1, 40)),
        (-20..60i32, -20..60i32, 0..30u32, 0..30u32).prop_map(|(x, y, width, height)| window_of(x, y, width, height)),
    ]
}

/// A center so that a point of the ellipse, at that fraction of the way along x, is at `(x, y)`.
fn center_for(radii: Size, along: u32, at: (i64, i64), mirrored: (bool, bool)) -> Point {
    let (a, b) = (u128::from(radii.width), u128::from(radii.height));
    let dx = (u128::from(along) * a) >> 32;
    let dy = if a == 0 {
        b
    } else {
        (b * b * (a * a - dx * dx) / (a * a)).isqrt()
    };
    let to = |offset: i64, distance: u128, mirrored: bool| {
        let distance = distance as i64;
        let center = offset + if mirrored { -distance } else { distance };
        center.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
    };
    Point::new(to(at.0, dx, mirrored.0), to(at.1, dy, mirrored.1))
}

fn any_radius(max: u32) -> impl Strategy<Value = u32> {
    prop_oneof![
        3 => 0..200u32.min(max),
        1 => 0..20_000u32.min(max),
        1 => 0..=max,
        1 => prop::sample::select(vec![0, 1, 2, max - 1, max]),
    ]
}

proptest! {
    #![proptest_config(config(cases(300, 3_000)))]

    #[test]
    fn circles_of_any_radius_have_the_nearest_pixels_in_a_window(
        radius in any_radius(MAX_CIRCLE),
        along in any::<u32>(),
        mirrored in any::<(bool, bool)>(),
        at in (-20..60i64, -20..60i64),
        window in any_window(),
    ) {
        check_circles(center_for(Size::new_equal(radius), along, at, mirrored), radius, window);
    }

    #[test]
    fn ellipses_of_any_size_have_the_nearest_pixels_in_a_window(
        radii in (any_radius(MAX_ELLIPSE), any_radius(MAX_ELLIPSE)),
        along in any::<u32>(),
        from_side in any::<bool>(),
        mirrored in any::<(bool, bool)>(),
        at in (-20..60i64, -20..60i64),
        window in any_window(),
    ) {
        let radii = Size::new(radii.0, radii.1);
        // From the side, tips of long ellipses are met as often as their flat parts.
        let center = if from_side {
            let center = center_for(Size::new(radii.height, radii.width), along, (at.1, at.0), mirrored);
            Point::new(center.y, center.x)
        } else {
            center_for(radii, along, at, mirrored)
        };
        check_ellipses(center, radii, window);
    }
}

proptest! {
    #![proptest_config(config(cases(50, 400)))]

    #[test]
    fn parametric_outlines_clipped_are_unclipped_within_the_window(
        radii in (any_radius(600), any_radius(600)),
        along in any::<u32>(),
        mirrored in any::<(bool, bool)>(),
        at in (-20..60i64, -20..60i64),
        window in any_window(),
    ) {
        let within = |mut points: Vec<Point>| { points.retain(|&point| window.contains(point)); points };
        let (radius, radii) = (radii.0, Size::new(radii.0, radii.1));
        let center = center_for(Size::new_equal(radius), along, at, mirrored);
        let circle = PARAMETRIC_CIRCLE;
        prop_assert_eq!(circle(center, radius, &window).unwrap(), within(circle(center, radius, &ALL).unwrap()));
        let center = center_for(radii, along, at, mirrored);
        let ellipse = PARAMETRIC_ELLIPSE;
        prop_assert_eq!(ellipse(center, radii, &window).unwrap(), within(ellipse(center, radii, &ALL).unwrap()));
    }
}

#[test]
fn outlines_at_the_ends_of_the_number_range() {
    let coordinates = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    let windows = [
        window_of(-4, -4, 9, 9),
        window_of(i32::MIN, i32::MAX - 9, 9, 9),
        window_of(i32::MAX - 9, i32::MIN, 9, 9),
    ];
    for center in coordinates
        .into_iter()
        .flat_map(|x| coordinates.map(|y| Point::new(x, y)))
    {
        for window in windows {
            for radius in [i32::MAX as u32, i32::MAX as u32 - 1, 1 << 30, 46_341, 7, 0] {
                check_circles(center, radius, window);
            }
            for radius in [0, 7, 32_767] {
                let radii = Size::new(radius, 3);
                let circle = PARAMETRIC_CIRCLE(center, radius, &window).unwrap();
                let ellipse = PARAMETRIC_ELLIPSE(center, radii, &window).unwrap();
                for (points, radii) in [(circle, Size::new_equal(radius)), (ellipse, radii)] {
                    assert!(
                        points
                            .iter()
                            .all(|&point| window.contains(point) && is_passed(center, radii, point))
                    );
                }
            }
            for radii in [
                (524_287, 524_287),
                (524_287, 0),
                (0, 524_287),
                (524_287, 1),
                (6, 7),
                (0, 0),
            ] {
                check_ellipses(center, Size::new(radii.0, radii.1), window);
            }
        }
    }
}

/// Sums of the largest decision variables: overflow checks are on.
#[test]
fn the_largest_ellipses_are_walked_whole() {
    let most = MAX_ELLIPSE;
    for radii in [
        (most, most),
        (most, 1),
        (1, most),
        (most, most / 2),
        (most, 3_000),
        (200, most),
    ] {
        let radii = Size::new(radii.0, radii.1);
        let points = Conics::midpoint_ellipse(Point::zero(), radii, &ALL).unwrap();
        let mut last = None;
        for (number, point) in points.enumerate() {
            if number % 97 == 0 {
                assert!(on_ellipse(Point::zero(), radii, point), "{point} of {radii}");
            }
            last = Some(point);
        }
        assert!(last.is_some_and(|point| on_ellipse(Point::zero(), radii, point)));
    }
}

#[test]
fn the_largest_circles_start_without_waiting_for_the_rest() {
    // The parametric circle takes radii up to another number, which its error says.
    macro_rules! start_each {
        ($([$name:ident] [$($draw:tt)+])+) => { $(
            let most = match $($draw)+(Point::zero(), MAX_CIRCLE, &ALL).err() {
                Some(InputError::RadiusTooLarge { max }) => max,
                other => {
                    assert_eq!(other, None, stringify!($name));
                    MAX_CIRCLE
                }
            };
            let points = $($draw)+(Point::zero(), most, &ALL).unwrap();
            assert_eq!(points.take(9).count(), 9, stringify!($name));
        )+ };
    }
    zrow_methods::circles!(start_each);
}

#[test]
fn larger_radii_are_refused() {
    let exact = exact_circles()
        .into_iter()
        .map(|(name, circle)| (name, MAX_CIRCLE, circle));
    for (name, max, circle) in exact.chain([("parametric_circle", MAX_PARAMETRIC, PARAMETRIC_CIRCLE)]) {
        for radius in [max + 1, u32::MAX] {
            assert_eq!(
                circle(Point::zero(), radius, &ALL),
                Err(InputError::RadiusTooLarge { max }),
                "{name}"
            );
        }
        assert!(circle(Point::zero(), max, &window_of(5, 5, 9, 9)).is_ok(), "{name}");
    }
    let exact = exact_ellipses()
        .into_iter()
        .map(|(name, ellipse)| (name, MAX_ELLIPSE, ellipse));
    for (name, max, ellipse) in exact.chain([("parametric_ellipse", MAX_PARAMETRIC, PARAMETRIC_ELLIPSE)]) {
        for radii in [Size::new(max + 1, 0), Size::new(3, max + 1), Size::new_equal(u32::MAX)] {
            assert_eq!(
                ellipse(Point::zero(), radii, &ALL),
                Err(InputError::RadiusTooLarge { max }),
                "{name}"
            );
        }
        assert!(
            ellipse(Point::zero(), Size::new_equal(max), &window_of(5, 5, 9, 9)).is_ok(),
            "{name}"
        );
    }
}

#[test]
fn an_empty_window_shows_nothing() {
    for window in [
        Window::EMPTY,
        window_of(3, 0, 0, 9),
        Window {
            left: 5,
            right: -5,
            ..ALL
        },
    ] {
        for (name, circle) in exact_circles()
            .into_iter()
            .chain([("parametric_circle", PARAMETRIC_CIRCLE)])
        {
            assert_eq!(circle(Point::new(3, 3), 3, &window), Ok(vec![]), "{name}");
        }
        for (name, ellipse) in exact_ellipses()
            .into_iter()
            .chain([("parametric_ellipse", PARAMETRIC_ELLIPSE)])
        {
            assert_eq!(
                ellipse(Point::new(3, 3), Size::new(3, 2), &window),
                Ok(vec![]),
                "{name}"
            );
        }
    }
}
