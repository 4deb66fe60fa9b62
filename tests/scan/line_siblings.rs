//! The line algorithms against each other, against the exact nearest-pixel rule and against brute force, in `i128`.

use embedded_graphics::{prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{geometry::Window, scan::Lines};
use zrow_methods::registry::{Agrees, LINES};

use crate::common::{by_depth, cases, config};
use crate::reference::nearest_pixels::nearest;

type Sibling = fn(Point, Point, &Window) -> Vec<Point>;

macro_rules! sibling {
    ($line:ident) => {
        (|from, to, window| Lines::$line(from, to, window).collect()) as Sibling
    };
}

/// Those that draw the same pixels whatever the line.
fn exact_siblings() -> impl Iterator<Item = (&'static str, Sibling)> {
    let exact = |name: &str| {
        LINES
            .iter()
            .any(|line| line.name == name && line.agrees == Agrees::Always)
    };
    all_siblings().into_iter().filter(move |(name, _)| exact(name))
}

fn all_siblings() -> Vec<(&'static str, Sibling)> {
    macro_rules! siblings {
        ($([$name:ident] [$($line:tt)+])+) => {
            vec![$((
                stringify!($name),
                (|from, to, window| $($line)+(from, to, window).collect()) as Sibling,
            )),+]
        };
    }
    zrow_methods::lines!(siblings)
}

/// Row by row; a pixel that comes twice fails.
fn sorted(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by_key(|point| (point.y, point.x));
    assert!(points.windows(2).all(|pair| pair[0] != pair[1]), "a pixel came twice");
    points
}

/// Where the exact line is at a pixel's position on the major axis: numerator and denominator of the minor coordinate.
/// `None` beyond the ends of the line.
fn exact_minor(from: Point, to: Point, pixel: Point) -> Option<(i128, i128)> {
    let [x0, y0, x1, y1, x, y] = [from.x, from.y, to.x, to.y, pixel.x, pixel.y].map(i128::from);
    let (dx, dy) = (x1 - x0, y1 - y0);
    let (start, delta, minor_start, minor_delta, at) = if dx.abs() >= dy.abs() {
        (x0, dx, y0, dy, x)
    } else {
        (y0, dy, x0, dx, y)
    };
    if delta == 0 {
        return (at == start).then_some((minor_start, 1));
    }
    let way = (at - start) * delta.signum();
    let numerator = minor_start * delta.abs() + way * minor_delta;
    (0..=delta.abs()).contains(&way).then_some((numerator, delta.abs()))
}

fn minor(from: Point, to: Point, pixel: Point) -> i128 {
    let x_major = from.x.abs_diff(to.x) >= from.y.abs_diff(to.y);
    i128::from(if x_major { pixel.y } else { pixel.x })
}

fn is_exact(from: Point, to: Point, pixel: Point) -> bool {
    exact_minor(from, to, pixel)
        .is_some_and(|(numerator, denominator)| nearest(numerator, denominator) == minor(from, to, pixel))
}

fn is_tie(from: Point, to: Point, pixel: Point) -> bool {
    exact_minor(from, to, pixel)
        .is_some_and(|(numerator, denominator)| (2 * numerator).rem_euclid(2 * denominator) == denominator)
}

fn window_of(left: i32, top: i32, width: u32, height: u32) -> Window {
    Rectangle::new(Point::new(left, top), Size::new(width, height)).into()
}

fn window() -> Window {
    window_of(-3, 5, 64, 48)
}

fn points_of(window: &Window) -> rectangle_points::Points {
    rectangle_points::of(window)
}

mod rectangle_points {
    use embedded_graphics::{prelude::*, primitives::rectangle};
    use zrow::geometry::Window;

    pub type Points = rectangle::Points;

    pub fn of(window: &Window) -> Points {
        window.to_rectangle().points()
    }
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => -20..80i32,
        2 => -3000..3000i32,
        1 => any::<i32>(),
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, i32::MAX, i32::MAX - 1, -8191, 8191, -4, -3, 60, 61, 4, 5, 52, 53]),
    ]
}

fn point() -> impl Strategy<Value = Point> {
    (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y))
}

fn points_within(bound: i32) -> impl Strategy<Value = (Point, Point)> {
    let number =
        prop_oneof![3 => -bound..=bound, 1 => prop::sample::select(vec![-bound, 1 - bound, 0, bound - 1, bound])];
    [number.clone(), number.clone(), number.clone(), number]
        .prop_map(|[x0, y0, x1, y1]| (Point::new(x0, y0), Point::new(x1, y1)))
}

fn any_window() -> impl Strategy<Value = Window> {
    prop_oneof![
        Just(window()),
        (0..60i32).prop_map(|y| window_of(-3, y, 64, 1)),
        (-3..61i32).prop_map(|x| window_of(x, 5, 1, 48)),
        (-20..60i32, -20..60i32, 0..30u32, 0..30u32).prop_map(|(x, y, width, height)| window_of(x, y, width, height)),
    ]
}

const ALL: Window = Window {
    left: i32::MIN,
    top: i32::MIN,
    right: i32::MAX,
    bottom: i32::MAX,
};

proptest! {
    #![proptest_config(config(cases(300, 3_000)))]

    #[test]
    fn the_exact_siblings_draw_the_nearest_pixels(from in point(), to in point(), window in any_window()) {
        let expected: Vec<Point> = points_of(&window).filter(|&pixel| is_exact(from, to, pixel)).collect();
        for (name, line) in exact_siblings() {
            prop_assert_eq!(sorted(line(from, to, &window)), expected.clone(), "{}", name);
        }
    }

    /// In the middle of such lines a product of the smaller delta and the steps that were taken reaches 2^63, or another power of 2.
    #[test]
    fn windows_along_the_longest_lines_show_the_nearest_pixels([x0, y0, x1, y1] in any::<[i32; 4]>(), step in any::<u32>(), power in 58..64u32, (left, top) in (0..7i32, 0..5i32)) {
        let (from, to) = (Point::new(x0, y0), Point::new(x1, y1));
        let (dx, dy) = (i128::from(x1) - i128::from(x0), i128::from(y1) - i128::from(y0));
        let major = dx.abs().max(dy.abs()).max(1);
        let steps_to_power = (1 << power) / dx.abs().min(dy.abs()).max(1);
        for steps in [i128::from(step), steps_to_power, steps_to_power / 2].map(|steps| steps.min(major)) {
            let (x, y) = (i128::from(x0) + dx * steps / major, i128::from(y0) + dy * steps / major);
            let window = window_of((x as i32).saturating_sub(left), (y as i32).saturating_sub(top), 7, 5);
            let expected: Vec<Point> = points_of(&window).filter(|&pixel| is_exact(from, to, pixel)).collect();
            for (name, line) in exact_siblings() {
                prop_assert_eq!(sorted(line(from, to, &window)), expected.clone(), "{}", name);
            }
            check_supercover(from, to, window);
            for (name, line) in all_siblings() {
                prop_assert!(line(from, to, &window).iter().all(|&pixel| window.contains(pixel)), "{}", name);
            }
        }
    }

    #[test]
    fn clipped_is_unclipped_within_the_window(from in point(), to in point(), part in any_window()) {
        // A part of a window shows what the window shows there: for lines of any length.
        let part = part.intersection(&window());
        for (name, line) in all_siblings() {
            let whole = sorted(line(from, to, &window()));
            prop_assert!(whole.iter().all(|&pixel| window().contains(pixel)), "{}", name);
            let expected: Vec<Point> = whole.into_iter().filter(|&pixel| part.contains(pixel)).collect();
            prop_assert_eq!(sorted(line(from, to, &part)), expected, "{}", name);
        }
    }

    #[test]
    fn a_window_shows_a_part_of_the_whole_line((from, to) in points_within(3000), window in any_window()) {
        for (name, line) in all_siblings() {
            let whole = sorted(line(from, to, &ALL));
            let expected: Vec<Point> = whole.into_iter().filter(|&pixel| window.contains(pixel)).collect();
            prop_assert_eq!(sorted(line(from, to, &window)), expected, "{}", name);
        }
    }

    #[test]
    fn the_order_of_the_end_points_does_not_matter(from in point(), to in point()) {
        for (name, line) in all_siblings() {
            prop_assert_eq!(sorted(line(from, to, &window())), sorted(line(to, from, &window())), "{}", name);
        }
    }

    #[test]
    fn slope_intercept_is_exact_but_for_ties_up_to_1023((from, to) in points_within(1023)) {
        same_but_for_ties(sibling!(slope_intercept), from, to);
    }

    #[test]
    fn the_dda_in_floats_is_exact_up_to_1365_steps((from, to) in points_within(682), offset in point()) {
        prop_assert_eq!(sibling!(dda)(from, to, &ALL), sibling!(bresenham)(from, to, &ALL));
        // Wherever on the number range it lies.
        if let (Some(from), Some(to)) = (moved(from, offset), moved(to, offset)) {
            let start = Point::new(from.x.min(to.x), from.y.min(to.y));
            let window = window_of(start.x.saturating_add(20), start.y.saturating_add(10), 90, 50);
            prop_assert_eq!(sibling!(dda)(from, to, &window), sibling!(bresenham)(from, to, &window));
        }
    }

    #[test]
    fn longer_ddas_drift_no_further_than_stated(from in point(), to in point()) {
        let steps = i128::from(from.x.abs_diff(to.x).max(from.y.abs_diff(to.y)));
        // In 2^-25 pixel: what a step adds to the distance, and what the tie is moved by.
        let bounds: [(&str, Sibling, i128, i128); 2] = [
            ("dda", sibling!(dda), 3, 1 << 12),
            ("dda_fixed", sibling!(dda_fixed), 1 << 9, 1 << 9),
        ];
        // Ends beyond 2^24 are no numbers of an `f32`.
        let bounds = bounds.into_iter().skip(usize::from(steps > 1 << 24));
        for (name, line, drift, tie) in bounds {
            for pixel in line(from, to, &window()) {
                let (numerator, denominator) = exact_minor(from, to, pixel).unwrap();
                let off = (minor(from, to, pixel) * denominator - numerator).abs() << 25;
                let allowed = ((1 << 24) + steps * drift + tie) * denominator;
                prop_assert!(off <= allowed, "{} {}", name, pixel);
            }
        }
    }

    #[test]
    fn supercover_is_every_touched_cell(from in point(), to in point(), window in any_window()) {
        check_supercover(from, to, window);
    }

    #[test]
    fn supercover_meets_corners(cell in (-20..60i32, -20..60i32), (x, y) in (0..4i32, 0..4i32), (dx, dy) in (1..500i32, 1..500i32), mirrored in any::<bool>(), window in any_window()) {
        // Odd multiples of half of two odd deltas reach a corner.
        let (dx, dy) = (2 * dx + 1, if mirrored { -(2 * dy + 1) } else { 2 * dy + 1 });
        let from = Point::new(cell.0 - dx * x, cell.1 - dy * y);
        let to = from + Point::new(dx * (x + 1), dy * (x + 1));
        check_supercover(from, to, window);
    }

    #[test]
    fn supercover_marches_from_side_to_side((from, to) in points_within(300)) {
        let cells: Vec<Point> = Lines::supercover(from, to, &ALL).collect();
        prop_assert_eq!((cells.first(), cells.last()), (Some(&from), Some(&to)));
        for pair in cells.windows(2) {
            let step = pair[1] - pair[0];
            let through_corner = step.x.abs() == 1 && step.y.abs() == 1;
            prop_assert!(through_corner || step.x.abs() + step.y.abs() == 1, "{} {}", pair[0], pair[1]);
            // Never away from the end.
            prop_assert!(step.x * (to.x - from.x).signum() >= 0 || through_corner);
        }
    }

    /// Both pixels of a pattern come in one round there; a walk may begin between them.
    #[test]
    fn a_folded_double_step_has_the_pixels_of_the_stepped_one(from in point(), to in point(), window in any_window(), taken in 0..6usize) {
        let stepped = sibling!(double_step)(from, to, &window);
        let mut points = Lines::double_step(from, to, &window);
        let mut folded: Vec<Point> = points.by_ref().take(taken).collect();
        points.for_each(|point| folded.push(point));
        prop_assert_eq!(folded, stepped);
    }

    #[test]
    fn runs_have_one_of_two_lengths((from, to) in points_within(600)) {
        let runs: Vec<Window> = Lines::runs(from, to, &ALL).collect();
        let (dx, dy) = (from.x.abs_diff(to.x), from.y.abs_diff(to.y));
        let lengths: Vec<u32> = runs.iter().map(|run| {
            let (length, thickness) = if dx >= dy { (run.width(), run.height()) } else { (run.height(), run.width()) };
            assert_eq!(thickness, 1);
            length
        }).collect();
        let (major, minor) = (dx.max(dy), dx.min(dy));
        prop_assert_eq!(lengths.len() as u32, minor + 1);
        prop_assert_eq!(lengths.iter().sum::<u32>(), major + 1);
        for &length in lengths.iter().skip(1).take(lengths.len().saturating_sub(2)) {
            prop_assert!(length == major / minor || length == major / minor + 1);
        }
    }
}

fn moved(point: Point, by: Point) -> Option<Point> {
    Some(Point::new(point.x.checked_add(by.x)?, point.y.checked_add(by.y)?))
}

/// Each pixel the exact one, or one of the two that are equally near.
fn same_but_for_ties(line: Sibling, from: Point, to: Point) {
    let points = line(from, to, &ALL);
    assert_eq!(
        points.len() as u32,
        1 + from.x.abs_diff(to.x).max(from.y.abs_diff(to.y))
    );
    for pixel in points {
        if is_tie(from, to, pixel) {
            let (numerator, denominator) = exact_minor(from, to, pixel).unwrap();
            let off = (minor(from, to, pixel) * denominator - numerator).abs();
            assert_eq!(2 * off, denominator, "{from} to {to} at {pixel}");
        } else {
            assert!(is_exact(from, to, pixel), "{from} to {to} at {pixel}");
        }
    }
}

/// Whether the closed segment and the closed square around a pixel have a point in common: no axis separates them.
fn touches(from: Point, to: Point, cell: Point) -> bool {
    // In half pixels.
    let [x0, y0, x1, y1, x, y] = [from.x, from.y, to.x, to.y, cell.x, cell.y].map(|at| 2 * i128::from(at));
    let apart = |first: i128, second: i128, at: i128| first.max(second) < at - 1 || first.min(second) > at + 1;
    if apart(x0, x1, x) || apart(y0, y1, y) {
        return false;
    }
    let sides = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        .map(|(dx, dy)| ((x1 - x0) * (y + dy - y0) - (y1 - y0) * (x + dx - x0)).signum());
    !sides.iter().all(|&side| side > 0) && !sides.iter().all(|&side| side < 0)
}

fn check_supercover(from: Point, to: Point, window: Window) {
    let expected: Vec<Point> = points_of(&window).filter(|&cell| touches(from, to, cell)).collect();
    assert_eq!(
        sorted(sibling!(supercover)(from, to, &window)),
        expected,
        "{from} to {to} in {window:?}"
    );
}

/// Lines of that many steps in all octants: mirrored and with the axes exchanged.
fn octants(major: i32, minor: i32) -> [(Point, Point); 4] {
    let from = Point::new(-7, 11);
    [(major, minor), (-major, minor), (minor, major), (-minor, major)].map(|(dx, dy)| (from, from + Point::new(dx, dy)))
}

#[test]
fn the_fixed_dda_is_exact_up_to_181_steps() {
    for major in 0..=181 {
        for minor in 0..=major {
            for (from, to) in octants(major, minor) {
                assert_eq!(
                    sibling!(dda_fixed)(from, to, &ALL),
                    sibling!(bresenham)(from, to, &ALL),
                    "{from} to {to}"
                );
            }
        }
    }
}

#[test]
fn the_fixed_dda_drifts_from_182_steps_on() {
    let differs = |major: i32| {
        (0..=major).any(|minor| {
            octants(major, minor)
                .into_iter()
                .any(|(from, to)| sibling!(dda_fixed)(from, to, &ALL) != sibling!(bresenham)(from, to, &ALL))
        })
    };
    assert!((182..260).any(differs));
}

#[test]
fn the_dda_in_floats_is_exact_at_its_bound_and_for_short_lines() {
    for major in (0..=130).chain(1355..=1365) {
        for minor in (0..=major).step_by(by_depth(5, 1, 1)) {
            for (from, to) in octants(major, minor) {
                assert!(
                    Lines::dda(from, to, &ALL).eq(Lines::bresenham(from, to, &ALL)),
                    "{from} to {to}"
                );
            }
        }
    }
}

#[test]
fn slope_intercept_is_exact_but_for_ties_at_its_bound() {
    for minor in (0..=2046).step_by(by_depth(31, 3, 1)) {
        for (x, y) in [(2046, minor), (minor, 2046)] {
            let from = Point::new(-1023, -1023);
            same_but_for_ties(sibling!(slope_intercept), from, from + Point::new(x, y));
            let from = Point::new(1023, -1023);
            same_but_for_ties(sibling!(slope_intercept), from, from + Point::new(-x, y));
            let from = Point::new(1023 - x, 1023 - y);
            same_but_for_ties(sibling!(slope_intercept), from, Point::new(1023, 1023));
        }
    }
}

#[test]
fn all_octants_ties_and_short_lines() {
    let from = Point::new(20, 25);
    for x in -9..=9 {
        for y in -9..=9 {
            let to = from + Point::new(x, y);
            for (name, line) in exact_siblings() {
                assert!(
                    line(from, to, &window())
                        .into_iter()
                        .all(|pixel| is_exact(from, to, pixel)),
                    "{name}"
                );
                assert_eq!(line(from, to, &window()).len() as i32, 1 + x.abs().max(y.abs()));
            }
            same_but_for_ties(sibling!(slope_intercept), from, to);
            check_supercover(from, to, window());
        }
    }
}

#[test]
fn a_diagonal_touches_the_cells_beside_its_corners() {
    let cells: Vec<Point> = Lines::supercover(Point::zero(), Point::new(2, 2), &ALL).collect();
    let expected = [(0, 0), (0, 1), (1, 0), (1, 1), (1, 2), (2, 1), (2, 2)];
    assert_eq!(cells, expected.map(|(x, y)| Point::new(x, y)));
}

#[test]
fn the_midpoint_line_goes_through_2_to_the_63() {
    let (from, to) = (
        Point::new(-1_146_393_543, -2_055_186_059),
        Point::new(611_149_651, 1_545_958_589),
    );
    let window = window_of(134_223_166, 568_752_876, 5, 3);
    let expected = sibling!(bresenham)(from, to, &window);
    assert_eq!((expected.len(), sibling!(midpoint)(from, to, &window)), (3, expected));
}

#[test]
fn the_longest_lines_are_drawn_by_all() {
    let ends = [i32::MIN, i32::MAX, 0];
    let corner_windows = [
        window_of(i32::MIN, i32::MIN, 9, 9),
        window_of(i32::MAX - 9, i32::MAX - 9, 9, 9),
        window_of(i32::MIN, i32::MAX - 9, 9, 9),
        window_of(-4, -4, 9, 9),
    ];
    let points = || ends.into_iter().flat_map(|x| ends.map(|y| Point::new(x, y)));
    for (from, to) in points().flat_map(|from| points().map(move |to| (from, to))) {
        for window in corner_windows {
            let expected: Vec<Point> = points_of(&window).filter(|&pixel| is_exact(from, to, pixel)).collect();
            for (name, line) in exact_siblings() {
                assert_eq!(sorted(line(from, to, &window)), expected, "{name}: {from} to {to}");
            }
            check_supercover(from, to, window);
            for (name, line) in all_siblings() {
                assert!(
                    line(from, to, &window).iter().all(|&pixel| window.contains(pixel)),
                    "{name}"
                );
            }
        }
        // The whole number range as a window: the first pixels come without waiting for the rest.
        macro_rules! first {
            ($([$name:ident] [$($line:tt)+])+) => {
                [$((stringify!($name), $($line)+(from, to, &ALL).take(3).count())),+]
            };
        }
        for (name, first) in zrow_methods::lines!(first) {
            // Column and row `i32::MAX` are in no window.
            let lies_there = (from.x == i32::MAX && to.x == i32::MAX) || (from.y == i32::MAX && to.y == i32::MAX);
            assert_eq!(first > 0, !lies_there, "{name}: {from} to {to}");
        }
    }
}

#[test]
fn an_empty_window_shows_nothing() {
    for (name, line) in all_siblings() {
        assert!(
            line(Point::new(-5, -5), Point::new(5, 5), &Window::EMPTY).is_empty(),
            "{name}"
        );
    }
}
