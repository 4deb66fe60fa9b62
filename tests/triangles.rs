//! Triangles against three lines of exact pixels and all between, and against embedded-graphics.

mod common;

use std::collections::BTreeMap;

use common::{config, exact::run, painted};
use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{self, Rectangle, Triangle},
};
use proptest::prelude::*;
use zrow::draw::{DrawOn, PrimitiveStyle, PrimitiveStyleBuilder, StrokeAlignment};

#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Part {
    Edge,
    Inside,
}

fn reference([a, b, c]: [Point; 3], window: Rectangle) -> BTreeMap<(i32, i32), Part> {
    let mut pixels = BTreeMap::new();
    for y in window.rows() {
        let runs: Vec<_> = [(a, b), (b, c), (c, a)]
            .iter()
            .filter_map(|&(from, to)| run(from, to, y))
            .collect();
        let (Some(left), Some(right)) = (runs.iter().map(|run| run.0).min(), runs.iter().map(|run| run.1).max()) else {
            continue;
        };
        for x in window.columns() {
            let column = i128::from(x);
            if runs.iter().any(|run| run.0 <= column && column <= run.1) {
                pixels.insert((y, x), Part::Edge);
            } else if left <= column && column <= right {
                pixels.insert((y, x), Part::Inside);
            }
        }
    }
    pixels
}

/// Whether an end-point order can decide a pixel of the line in embedded-graphics.
fn has_tie(from: Point, to: Point) -> bool {
    let delta = to - from;
    let (major, minor) = (delta.x.abs().max(delta.y.abs()), delta.x.abs().min(delta.y.abs()));
    let (mut a, mut b) = (major, minor);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    minor != 0 && major / a % 2 == 0
}

fn points(pixels: &BTreeMap<(i32, i32), Part>, part: Option<Part>) -> Vec<Point> {
    pixels
        .iter()
        .filter(|&(_, &at)| part.is_none_or(|part| part == at))
        .map(|(&(y, x), _)| Point::new(x, y))
        .collect()
}

fn drawn(vertices: [Point; 3], style: PrimitiveStyle<Rgb565>, window: Rectangle) -> Vec<Point> {
    let [a, b, c] = vertices;
    painted(window, |band| {
        let Ok(()) = Triangle::new(a, b, c).into_styled(style).draw_on(band);
    })
}

fn check(vertices: [Point; 3], window: Rectangle) {
    let expected = reference(vertices, window);
    let [a, b, c] = vertices;
    for order in [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
        let fill = drawn(order, PrimitiveStyle::with_fill(Rgb565::WHITE), window);
        assert_eq!(fill, points(&expected, None), "fill {order:?} in {window:?}");
    }
    let outline = drawn(vertices, PrimitiveStyle::with_stroke(Rgb565::WHITE, 1), window);
    assert_eq!(
        outline,
        points(&expected, Some(Part::Edge)),
        "outline {vertices:?} in {window:?}"
    );
    let inside = drawn(
        vertices,
        PrimitiveStyleBuilder::new()
            .stroke_width(1)
            .fill_color(Rgb565::WHITE)
            .build(),
        window,
    );
    assert_eq!(
        inside,
        points(&expected, Some(Part::Inside)),
        "inside {vertices:?} in {window:?}"
    );
}

fn window() -> Rectangle {
    Rectangle::new(Point::new(-3, 5), Size::new(40, 32))
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        5 => -10..60i32,
        2 => -3000..3000i32,
        1 => any::<i32>(),
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, i32::MAX, i32::MAX - 1, -8191, 8191, -1027, -1026, 1020, 1021, -4, -3, 36, 37, 4, 5]),
    ]
}

fn vertices() -> impl Strategy<Value = [Point; 3]> {
    let point = || (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y));
    [point(), point(), point()]
}

proptest! {
    #![proptest_config(config(1500))]

    #[test]
    fn triangles_are_exact_in_any_order(vertices in vertices()) {
        check(vertices, window());
    }

    #[test]
    fn triangles_are_exact_in_one_row(vertices in vertices(), y in 0..50i32) {
        check(vertices, Rectangle::new(Point::new(0, y), Size::new(40, 1)));
    }

    #[test]
    fn triangles_as_large_as_a_display_are_exact(corners in prop::array::uniform6(0..1030i32), y in 0..1030i32) {
        let [ax, ay, bx, by, cx, cy] = corners;
        let row = Rectangle::new(Point::new(0, y), Size::new(1030, 1));
        check([Point::new(ax, ay), Point::new(bx, by), Point::new(cx, cy)], row);
    }

    #[test]
    fn small_triangles_are_exact(corners in prop::array::uniform6(0..12i32)) {
        let [ax, ay, bx, by, cx, cy] = corners;
        let offset = Point::new(3, 9);
        check([Point::new(ax, ay) + offset, Point::new(bx, by) + offset, Point::new(cx, cy) + offset], window());
    }

    #[test]
    fn embedded_graphics_draws_the_same_where_no_tie_decides(corners in prop::array::uniform6(0..63i32), size in 0..3usize, alignment in 0..3usize) {
        let [ax, ay, bx, by, cx, cy] = corners.map(|corner| corner % [5, 16, 63][size]);
        let [a, b, c] = [Point::new(ax, ay), Point::new(bx, by), Point::new(cx, cy)];
        if has_tie(a, b) || has_tie(b, c) || has_tie(c, a) {
            return Ok(());
        }
        let alignment = [StrokeAlignment::Inside, StrokeAlignment::Center, StrokeAlignment::Outside][alignment];
        for (stroke, fill) in [(Some(Rgb565::RED), None), (None, Some(Rgb565::BLUE)), (Some(Rgb565::RED), Some(Rgb565::BLUE))] {
            for width in 0..2 {
                let mut theirs = primitives::PrimitiveStyle::<Rgb565>::new();
                theirs.stroke_color = stroke;
                theirs.fill_color = fill;
                theirs.stroke_width = width;
                theirs.stroke_alignment = alignment;
                // Without a stroke, embedded-graphics takes the fill of a triangle without area for its stroke.
                let is_flat = (b - a).x * (c - a).y == (b - a).y * (c - a).x;
                if width == 0 && alignment == StrokeAlignment::Inside && is_flat {
                    continue;
                }
                let ours = PrimitiveStyle::from(theirs);
                let mut expected = MockDisplay::new();
                Triangle::new(a, b, c).into_styled(theirs).draw(&mut expected).unwrap();
                let mut display = MockDisplay::new();
                Triangle::new(a, b, c).into_styled(ours).draw(&mut display).unwrap();
                prop_assert!(display.eq(&expected), "{a} {b} {c} {ours:?}\n{:?}\n{:?}", display, expected);
            }
        }
    }
}

#[test]
fn the_largest_triangles_are_exact() {
    let ends = [i32::MIN, 7, i32::MAX];
    let corners: Vec<Point> = ends
        .iter()
        .flat_map(|&x| ends.iter().map(move |&y| Point::new(x, y)))
        .collect();
    for &a in &corners {
        for &b in &corners {
            for &c in &corners {
                check([a, b, c], window());
            }
        }
    }
}

#[test]
fn a_flat_triangle_is_one_row() {
    let mut display = MockDisplay::new();
    Triangle::new(Point::new(4, 0), Point::new(1, 0), Point::new(2, 0))
        .into_styled(PrimitiveStyle::with_fill(Rgb565::RED))
        .draw(&mut display)
        .unwrap();
    let expected = MockDisplay::from_points((1..=4).map(|x| Point::new(x, 0)), Rgb565::RED);
    display.assert_eq(&expected);
}
