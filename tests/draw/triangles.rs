//! Triangles against three lines of exact pixels and all between them, and against embedded-graphics.

use std::collections::BTreeMap;

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Rgb565},
    prelude::*,
    primitives::{self, PrimitiveStyleBuilder, Rectangle, Triangle},
};
use proptest::prelude::*;
use zrow::draw::{DrawOn, PrimitiveStyle, StrokeAlignment};

use crate::common::{by_depth, cases, config, painted, picture};
use crate::reference::nearest_pixels::walked_run;

#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Part {
    Edge,
    Inside,
}

/// The lines of a filled triangle, from upper to lower corners.
fn downwards(mut vertices: [Point; 3]) -> [(Point, Point); 3] {
    vertices.sort_by_key(|vertex| (vertex.y, vertex.x));
    let [top, middle, bottom] = vertices;
    [(top, middle), (top, bottom), (middle, bottom)]
}

/// The lines of an outline, clockwise on the display. Without an area, they go down along the middle corner and return.
fn clockwise(vertices: [Point; 3]) -> [(Point, Point); 3] {
    let [a, b, c] = vertices;
    let delta = |from: Point, to: Point| {
        let [x, y] = [(from.x, to.x), (from.y, to.y)].map(|(from, to)| i128::from(to) - i128::from(from));
        (x, y)
    };
    let (one, other) = (delta(a, b), delta(a, c));
    let [a, b, c] = match (one.0 * other.1 - one.1 * other.0).signum() {
        1 => [a, b, c],
        -1 => [b, a, c],
        _ => {
            let mut sorted = vertices;
            sorted.sort_by_key(|vertex| (vertex.y, vertex.x));
            sorted
        }
    };
    [(a, b), (b, c), (c, a)]
}

/// The pixels of three lines, and those between them in each row.
fn reference(lines: [(Point, Point); 3], window: Rectangle) -> BTreeMap<(i32, i32), Part> {
    let mut pixels = BTreeMap::new();
    for y in window.rows() {
        let runs: Vec<_> = lines.iter().filter_map(|&(from, to)| walked_run(from, to, y)).collect();
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
    let filled = reference(downwards(vertices), window);
    let outlined = reference(clockwise(vertices), window);
    let [a, b, c] = vertices;
    for order in [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
        let fill = drawn(order, PrimitiveStyle::with_fill(Rgb565::WHITE), window);
        assert_eq!(fill, points(&filled, None), "fill {order:?} in {window:?}");
        for part in [Part::Edge, Part::Inside] {
            assert_eq!(
                drawn(order, outline_style(part), window),
                points(&outlined, Some(part)),
                "{part:?} of the outline {order:?} in {window:?}"
            );
        }
    }
}

/// A stroke of one pixel, and a fill: one of them visible.
fn outline_style(visible: Part) -> PrimitiveStyle<Rgb565> {
    let style = PrimitiveStyleBuilder::new().stroke_width(1);
    let style = match visible {
        Part::Edge => style.stroke_color(Rgb565::WHITE),
        Part::Inside => style.fill_color(Rgb565::WHITE),
    };
    style.build().into()
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
    #![proptest_config(config(cases(150, 1_500)))]

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
}

const ALIGNMENTS: [StrokeAlignment; 3] = [
    StrokeAlignment::Inside,
    StrokeAlignment::Center,
    StrokeAlignment::Outside,
];

/// embedded-graphics' style.
fn their_style(
    width: u32,
    stroke_alignment: StrokeAlignment,
    stroke_color: Option<Rgb565>,
    fill_color: Option<Rgb565>,
) -> primitives::PrimitiveStyle<Rgb565> {
    let mut style = primitives::PrimitiveStyle::new();
    style.stroke_color = stroke_color;
    style.fill_color = fill_color;
    style.stroke_width = width;
    style.stroke_alignment = stroke_alignment;
    style
}

/// Compares all pixels from the origin to beyond the corners.
fn check_against_embedded_graphics(vertices: [Point; 3], style: primitives::PrimitiveStyle<Rgb565>) {
    let end = vertices.into_iter().fold(Point::zero(), Point::component_max);
    let area = Rectangle::with_corners(Point::zero(), end + Point::new(1, 1));
    let [a, b, c] = vertices;
    let theirs = picture(area, |band| {
        let Ok(()) = Triangle::new(a, b, c).into_styled(style).draw(band);
    });
    let ours = picture(area, |band| {
        let Ok(()) = Triangle::new(a, b, c)
            .into_styled(PrimitiveStyle::from(style))
            .draw(band);
    });
    for (point, (ours, theirs)) in area.points().zip(ours.into_iter().zip(theirs)) {
        assert_eq!(ours, theirs, "{point} of {vertices:?} in {style:?}");
    }
}

/// Up to 64 x 64 pixels, many of them small, so that ties, flat edges and triangles without an area are among them.
fn visible_vertices() -> impl Strategy<Value = [Point; 3]> {
    (prop::array::uniform6(0..64i32), 0..5usize).prop_map(|(corners, size)| {
        let [ax, ay, bx, by, cx, cy] = corners.map(|corner| corner % [4, 6, 12, 24, 64][size]);
        [Point::new(ax, ay), Point::new(bx, by), Point::new(cx, cy)]
    })
}

proptest! {
    #![proptest_config(config(cases(2_000, 20_000)))]

    #[test]
    fn embedded_graphics_draws_the_same(vertices in visible_vertices()) {
        let (red, blue) = (Some(Rgb565::RED), Some(Rgb565::BLUE));
        check_against_embedded_graphics(vertices, their_style(0, StrokeAlignment::Center, None, blue));
        for alignment in ALIGNMENTS {
            check_against_embedded_graphics(vertices, their_style(1, alignment, red, blue));
        }
    }
}

proptest! {
    #![proptest_config(config(cases(50, 500)))]

    #[test]
    fn mirrored_corners_fill_the_mirrored_pixels(vertices in visible_vertices()) {
        let area = Rectangle::new(Point::new(-63, 0), Size::new(127, 64));
        let style = PrimitiveStyle::with_fill(Rgb565::WHITE);
        let mut pixels = drawn(vertices, style, area);
        let mut mirrored = drawn(vertices.map(|vertex| Point::new(-vertex.x, vertex.y)), style, area);
        mirrored.iter_mut().for_each(|point| point.x = -point.x);
        pixels.sort_by_key(|point| (point.y, point.x));
        mirrored.sort_by_key(|point| (point.y, point.x));
        prop_assert_eq!(pixels, mirrored);
    }

    #[test]
    fn embedded_graphics_draws_the_same_in_every_style(vertices in visible_vertices()) {
        let [a, b, c] = vertices;
        let has_no_area = (b - a).x * (c - a).y == (b - a).y * (c - a).x;
        let colors = [None, Some(Rgb565::RED)].into_iter().flat_map(|stroke| [(stroke, None), (stroke, Some(Rgb565::BLUE))]);
        for (stroke, fill) in colors {
            for (alignment, width) in ALIGNMENTS.into_iter().flat_map(|alignment| [(alignment, 0), (alignment, 1)]) {
                // Without a stroke, it takes the fill of a triangle without an area for its stroke.
                if has_no_area && width == 0 && alignment == StrokeAlignment::Inside {
                    continue;
                }
                check_against_embedded_graphics(vertices, their_style(width, alignment, stroke, fill));
            }
        }
    }
}

#[test]
fn a_filled_triangle_is_its_own_mirror_image() {
    let mut display = MockDisplay::new();
    Triangle::new(Point::new(0, 4), Point::new(4, 4), Point::new(2, 0))
        .into_styled(PrimitiveStyle::with_fill(BinaryColor::On))
        .draw(&mut display)
        .unwrap();
    display.assert_pattern(&["  #  ", "  #  ", " ### ", " ### ", "#####"]);
}

#[test]
fn ties_of_an_outline_go_to_where_its_clockwise_lines_begin() {
    let mut display = MockDisplay::new();
    Triangle::new(Point::new(0, 4), Point::new(4, 4), Point::new(2, 0))
        .into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1))
        .draw(&mut display)
        .unwrap();
    display.assert_pattern(&["  #  ", " ##  ", " # # ", "#  # ", "#####"]);
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
            for &c in corners.iter().step_by(by_depth(4, 1, 1)) {
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
