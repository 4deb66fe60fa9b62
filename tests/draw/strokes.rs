//! Wide strokes against the ideal rectangles and wedges in floating point, each pixel drawn once.
//!
//! The corners of a stroke are rounded to 1/65,536 pixel, so a pixel whose centre is nearer than that to the ideal outline
//! may go either way; every other pixel may not.

use std::collections::BTreeSet;

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        self, Line, Polyline, Primitive, PrimitiveStyleBuilder, Rectangle, Styled, StyledDimensions, StyledDrawable,
        Triangle,
    },
};
use proptest::prelude::*;
use zrow::{
    draw::{DrawOn, FillRule, Polygon, PrimitiveStyle, StrokeAlignment},
    geometry::{Sub8, SubPoint},
};

use crate::common::{
    by_depth, cases, config, encloses,
    numbers::{far, near},
    painted, picture,
};
use crate::reference::nearest_pixels::walked_run;

/// Rounding of both ends of a side and of a cut, in pixels.
const TOLERANCE: f64 = 4.0 / 65_536.0;

type Position = (f64, f64);

fn plus(a: Position, b: Position, factor: f64) -> Position {
    (a.0 + b.0 * factor, a.1 + b.1 * factor)
}

fn cross(a: Position, b: Position) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

/// The convex polygons of a stroke; `None` where a corner is at the very limit of a miter join.
fn pieces(vertices: &[Position], closed: bool, half: f64) -> Option<Vec<Vec<Position>>> {
    let mut path: Vec<Position> = vertices.to_vec();
    path.dedup();
    if closed {
        while path.len() > 1 && path.first() == path.last() {
            path.pop();
        }
    }
    let mut pieces = Vec::new();
    if path.len() == 1 {
        let (x, y) = path[0];
        pieces.push(vec![
            (x - 0.5, y - half),
            (x + 0.5, y - half),
            (x + 0.5, y + half),
            (x - 0.5, y + half),
        ]);
        return Some(pieces);
    }
    let count = path.len();
    let segments: Vec<(Position, Position)> = (0..count)
        .filter(|&index| closed || index + 1 < count)
        .map(|index| (path[index], path[(index + 1) % count]))
        .collect();
    let along = |&(from, to): &(Position, Position)| {
        let (x, y) = (to.0 - from.0, to.1 - from.1);
        let length = x.hypot(y);
        (x / length, y / length)
    };
    for (index, segment) in segments.iter().enumerate() {
        let direction = along(segment);
        let normal = (-direction.1, direction.0);
        let (mut from, mut to) = *segment;
        if !closed && index == 0 {
            from = plus(from, direction, -0.5);
        }
        if !closed && index + 1 == segments.len() {
            to = plus(to, direction, 0.5);
        }
        pieces.push(vec![
            plus(from, normal, half),
            plus(to, normal, half),
            plus(to, normal, -half),
            plus(from, normal, -half),
        ]);
        if index == 0 && !closed {
            continue;
        }
        let before = along(&segments[(index + segments.len() - 1) % segments.len()]);
        let turn = cross(before, direction);
        let cosine = before.0 * direction.0 + before.1 * direction.1;
        if turn.abs() < 1e-12 {
            continue;
        }
        let side = -turn.signum() * half;
        let corner = segment.0;
        let one = (-before.1 * side, before.0 * side);
        let other = (-direction.1 * side, direction.0 * side);
        if (1.0 + cosine - 0.125).abs() < 1e-6 {
            return None;
        }
        let mut wedge = vec![corner, plus(corner, one, 1.0)];
        if 1.0 + cosine > 0.125 {
            let sum = (one.0 + other.0, one.1 + other.1);
            wedge.push(plus(corner, sum, 1.0 / (1.0 + cosine)));
        }
        wedge.push(plus(corner, other, 1.0));
        pieces.push(wedge);
    }
    Some(pieces)
}

/// How far a point is inside a convex polygon; negative outside.
fn margin(polygon: &[Position], point: Position) -> f64 {
    let area: f64 = (0..polygon.len())
        .map(|index| cross(polygon[index], polygon[(index + 1) % polygon.len()]))
        .sum();
    (0..polygon.len())
        .map(|index| {
            let (from, to) = (polygon[index], polygon[(index + 1) % polygon.len()]);
            let (dx, dy) = (to.0 - from.0, to.1 - from.1);
            let length = dx.hypot(dy);
            if length < 1e-9 {
                return f64::INFINITY;
            }
            cross((dx, dy), (point.0 - from.0, point.1 - from.1)) / length * area.signum()
        })
        .fold(f64::INFINITY, f64::min)
}

#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Location {
    Inside,
    Outside,
    Between,
}

fn location(pieces: &[Vec<Position>], point: Point) -> Location {
    let point = (f64::from(point.x), f64::from(point.y));
    let margin = pieces
        .iter()
        .map(|piece| margin(piece, point))
        .fold(f64::NEG_INFINITY, f64::max);
    if margin > TOLERANCE {
        Location::Inside
    } else if margin < -TOLERANCE {
        Location::Outside
    } else {
        Location::Between
    }
}

fn ideal(points: &[Point], offset: (i64, i64)) -> Vec<Position> {
    points
        .iter()
        .map(|point| {
            (
                (i64::from(point.x) + offset.0) as f64,
                (i64::from(point.y) + offset.1) as f64,
            )
        })
        .collect()
}

const FILL: Rgb565 = Rgb565::GREEN;
const STROKE: Rgb565 = Rgb565::RED;

fn style(width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Rgb565> {
    PrimitiveStyleBuilder::new()
        .stroke_color(STROKE)
        .stroke_width(width)
        .stroke_alignment(alignment)
        .fill_color(FILL)
        .build()
        .into()
}

fn screen() -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(64, 64))
}

/// The picture on a display that panics on a pixel drawn twice; the same in bands and in columns, and all in its bounds.
fn drawn<S>(shape: S, style: PrimitiveStyle<Rgb565>) -> MockDisplay<Rgb565>
where
    S: Primitive
        + Clone
        + StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>
        + StyledDimensions<PrimitiveStyle<Rgb565>>,
    Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
{
    let styled = shape.into_styled(style);
    let bounds = styled.bounding_box();
    let mut display = MockDisplay::new();
    styled.draw(&mut display).unwrap();
    let all: BTreeSet<(i32, i32)> = screen()
        .points()
        .filter(|&point| display.get_pixel(point).is_some())
        .map(|point| (point.x, point.y))
        .collect();
    for &(x, y) in &all {
        assert!(encloses(&bounds, Point::new(x, y)), "({x}, {y}) outside {bounds:?}");
    }
    let mut parts = BTreeSet::new();
    let windows = (0..8).map(|band| Rectangle::new(Point::new(0, 3 * band), Size::new(64, 3)));
    let columns = (0..4).map(|column| Rectangle::new(Point::new(16 * column, 24), Size::new(16, 40)));
    for window in windows.chain(columns) {
        parts.extend(
            painted(window, |band| {
                let Ok(()) = styled.draw_on(band);
            })
            .into_iter()
            .map(|point| (point.x, point.y)),
        );
    }
    assert_eq!(parts, all, "in parts");
    display
}

/// Compares and returns how many pixels could have gone either way.
fn check(display: &MockDisplay<Rgb565>, expected: impl Fn(Point) -> Option<Option<Rgb565>>) -> usize {
    let mut free = 0;
    for point in screen().points() {
        match expected(point) {
            Some(color) => assert_eq!(display.get_pixel(point), color, "at {point}\n{display:?}"),
            None => free += 1,
        }
    }
    free
}

fn check_path<S>(shape: S, vertices: &[Position], width: u32) -> usize
where
    S: Primitive
        + Clone
        + StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>
        + StyledDimensions<PrimitiveStyle<Rgb565>>,
    Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
{
    let Some(pieces) = pieces(vertices, false, f64::from(width) / 2.0) else {
        return 0;
    };
    let display = drawn(shape, style(width, StrokeAlignment::Center));
    check(&display, |point| match location(&pieces, point) {
        Location::Inside => Some(Some(STROKE)),
        Location::Outside => Some(None),
        Location::Between => None,
    })
}

/// What the stroke of a triangle goes along: its corners, closed; without an area the two that are furthest apart.
fn outline(mut vertices: [Point; 3]) -> (Vec<Point>, bool) {
    let [a, b, c] = vertices;
    let product = |one: Point, other: Point| i128::from(one.x - a.x) * i128::from(other.y - a.y);
    if product(b, c) != product(c, b) {
        return (vertices.to_vec(), true);
    }
    vertices.sort_by_key(|vertex| (vertex.y, vertex.x));
    (vec![vertices[0], vertices[2]], false)
}

/// Whether a pixel belongs to a filled triangle: one of three lines that are walked downwards, or between two.
fn triangle_contains(mut vertices: [Point; 3], point: Point) -> bool {
    vertices.sort_by_key(|vertex| (vertex.y, vertex.x));
    let [a, b, c] = vertices;
    let runs: Vec<(i128, i128)> = [(a, b), (a, c), (b, c)]
        .iter()
        .filter_map(|&(from, to)| walked_run(from, to, point.y))
        .collect();
    let x = i128::from(point.x);
    runs.iter().any(|run| run.0 <= x) && runs.iter().any(|run| x <= run.1)
}

fn alignment() -> impl Strategy<Value = StrokeAlignment> {
    prop::sample::select(vec![
        StrokeAlignment::Inside,
        StrokeAlignment::Center,
        StrokeAlignment::Outside,
    ])
}

proptest! {
    #![proptest_config(config(cases(10, 90)))]

    #[test]
    fn lines_are_exact(from in near(), to in near(), width in 2..24u32) {
        let free = check_path(Line::new(from, to), &ideal(&[from, to], (0, 0)), width);
        prop_assume!(from.x != to.x && from.y != to.y);
        prop_assert!(free < 64, "{free}");
    }

    #[test]
    fn lines_from_afar_are_exact(from in far(), to in far(), width in 2..24u32) {
        check_path(Line::new(from, to), &ideal(&[from, to], (0, 0)), width);
    }

    #[test]
    fn polylines_are_exact(vertices in prop::collection::vec(near(), 2..7), width in 2..16u32, x in -9..9i32, y in -9..9i32) {
        let polyline = Polyline { translate: Point::new(x, y), vertices: &vertices };
        check_path(polyline, &ideal(&vertices, (x.into(), y.into())), width);
    }

    #[test]
    fn polylines_from_afar_are_exact(vertices in prop::collection::vec(far(), 2..6), width in 2..16u32) {
        check_path(Polyline::new(&vertices), &ideal(&vertices, (0, 0)), width);
    }

    #[test]
    fn triangles_are_exact(a in near(), b in near(), c in near(), width in 2..14u32, alignment in alignment()) {
        let vertices = [a, b, c];
        let half = match alignment {
            StrokeAlignment::Center => f64::from(width) / 2.0,
            StrokeAlignment::Inside => f64::from(width) - 0.5,
            StrokeAlignment::Outside => f64::from(width) + 0.5,
        };
        let (outline, closed) = outline(vertices);
        let Some(pieces) = pieces(&ideal(&outline, (0, 0)), closed, half) else { return Ok(()) };
        let display = drawn(Triangle::new(a, b, c), style(width, alignment));
        check(&display, |point| {
            let filled = triangle_contains(vertices, point);
            // Without an area, what is stroked inside is all of it.
            if !closed && alignment == StrokeAlignment::Inside {
                return Some(filled.then_some(STROKE));
            }
            expected(location(&pieces, point), filled, alignment)
        });
    }

    #[test]
    fn polygons_are_exact(contours in prop::collection::vec(prop::collection::vec((-2000..20_000i32, -2000..20_000i32), 1..6), 1..3), width in 1..12u32, alignment in alignment(), rule in prop::sample::select(vec![FillRule::EvenOdd, FillRule::NonZero])) {
        let half = if alignment == StrokeAlignment::Center { f64::from(width) / 2.0 } else { f64::from(width) };
        let mut all = Vec::new();
        for contour in &contours {
            let vertices: Vec<Position> = contour.iter().map(|&(x, y)| (f64::from(x) / 256.0, f64::from(y) / 256.0)).collect();
            let Some(pieces) = pieces(&vertices, true, half) else { return Ok(()) };
            all.extend(pieces);
        }
        let points: Vec<Vec<SubPoint<Sub8>>> = contours.iter().map(|contour| contour.iter().map(|&(x, y)| SubPoint::from_units(x, y).unwrap()).collect()).collect();
        let slices: Vec<&[SubPoint<Sub8>]> = points.iter().map(Vec::as_slice).collect();
        let polygon = Polygon::new(&slices, rule).prepare::<12, 12>().unwrap();
        let display = drawn(&polygon, style(width, alignment));
        check(&display, |point| {
            let mut winding = 0;
            for contour in &contours {
                for (index, &from) in contour.iter().enumerate() {
                    let to = contour[(index + 1) % contour.len()];
                    let (direction, top, bottom) = if from.1 < to.1 { (1, from, to) } else { (-1, to, from) };
                    let (x, y) = (i64::from(point.x) * 256, i64::from(point.y) * 256);
                    let (x0, y0, x1, y1) = (i64::from(top.0), i64::from(top.1), i64::from(bottom.0), i64::from(bottom.1));
                    if y0 <= y && y < y1 && (x - x0) * (y1 - y0) >= (y - y0) * (x1 - x0) {
                        winding += direction;
                    }
                }
            }
            let filled = match rule {
                FillRule::EvenOdd => winding % 2 != 0,
                FillRule::NonZero => winding != 0,
            };
            expected(location(&all, point), filled, alignment)
        });
    }

}

proptest! {
    #![proptest_config(config(cases(16, 160)))]

    /// More edges in a row than any table holds.
    #[test]
    fn tangles_lose_no_pixel(vertices in prop::collection::vec(near(), 40..90), width in 2..6u32) {
        check_path(Polyline::new(&vertices), &ideal(&vertices, (0, 0)), width);
    }
}

fn expected(stroke: Location, filled: bool, alignment: StrokeAlignment) -> Option<Option<Rgb565>> {
    let fill = filled.then_some(FILL);
    match (alignment, stroke) {
        (StrokeAlignment::Inside, _) if !filled => Some(None),
        (StrokeAlignment::Outside, _) if filled => Some(fill),
        (_, Location::Inside) => Some(Some(STROKE)),
        (_, Location::Outside) => Some(fill),
        (_, Location::Between) => None,
    }
}

/// Of even widths, embedded-graphics has one row or column more on the left side of the line as it is walked. zrow has it
/// above or to the left whatever the order of the end points, which is the same for lines to the right and upwards.
#[test]
fn upright_and_level_lines_are_those_of_embedded_graphics() {
    for width in 1..12 {
        for (from, to, is_even_width_equal) in [
            ((20, 30), (41, 30), true),
            ((20, 30), (20, 9), true),
            ((40, 30), (20, 30), false),
            ((20, 9), (20, 30), false),
            ((20, 30), (20, 31), false),
        ] {
            let line = Line::new(from.into(), to.into());
            let mut ours = MockDisplay::new();
            line.into_styled(PrimitiveStyle::with_stroke(STROKE, width))
                .draw(&mut ours)
                .unwrap();
            let is_equal = width % 2 == 1 || is_even_width_equal;
            let aside = match (is_equal, from.0 == to.0) {
                (true, _) => Point::zero(),
                (false, true) => Point::new(-1, 0),
                (false, false) => Point::new(0, -1),
            };
            let mut theirs = MockDisplay::new();
            line.translate(aside)
                .into_styled(primitives::PrimitiveStyle::with_stroke(STROKE, width))
                .draw(&mut theirs)
                .unwrap();
            ours.assert_eq(&theirs);
        }
    }
}

#[test]
fn a_dot_is_as_high_as_the_stroke_is_wide() {
    let dot = [Point::new(3, 4); 3];
    let mut display = MockDisplay::new();
    Polyline::new(&dot)
        .into_styled(PrimitiveStyle::with_stroke(STROKE, 3))
        .draw(&mut display)
        .unwrap();
    display.assert_pattern(&["    ", "    ", "    ", "   R", "   R", "   R"]);
    let mut display = MockDisplay::new();
    Line::new(dot[0], dot[1])
        .into_styled(PrimitiveStyle::with_stroke(STROKE, 3))
        .draw(&mut display)
        .unwrap();
    display.assert_pattern(&["    ", "    ", "    ", "   R", "   R", "   R"]);
    let mut display = MockDisplay::<Rgb565>::new();
    Polyline::new(&dot[..1])
        .into_styled(PrimitiveStyle::with_stroke(STROKE, 3))
        .draw(&mut display)
        .unwrap();
    display.assert_eq(&MockDisplay::new());
}

#[test]
fn strokes_upon_one_another_are_one_stroke() {
    // More edges in one pixel than any table holds.
    for (from, to) in [((10, 5), (40, 50)), ((10, 50), (50, 45)), ((20, 5), (20, 60))] {
        let ends = [Point::from(from), Point::from(to)];
        let vertices: Vec<Point> = (0..60).map(|index| ends[index % 2]).collect();
        let once = painted(screen(), |band| {
            let Ok(()) = Polyline::new(&ends)
                .into_styled(PrimitiveStyle::with_stroke(STROKE, 4))
                .draw_on(band);
        });
        let mut display = MockDisplay::new();
        Polyline::new(&vertices)
            .into_styled(PrimitiveStyle::with_stroke(STROKE, 4))
            .draw(&mut display)
            .unwrap();
        display.assert_eq(&MockDisplay::from_points(once, STROKE));
    }
}

#[test]
fn corners_are_mitered_and_sharp_ones_bevelled() {
    let mut display = MockDisplay::new();
    Polyline::new(&[Point::new(2, 8), Point::new(2, 2), Point::new(8, 2)])
        .into_styled(PrimitiveStyle::with_stroke(STROKE, 3))
        .draw(&mut display)
        .unwrap();
    display.assert_pattern(&[
        "         ",
        " RRRRRRRR",
        " RRRRRRRR",
        " RRRRRRRR",
        " RRR     ",
        " RRR     ",
        " RRR     ",
        " RRR     ",
        " RRR     ",
    ]);
    // The tip of so sharp a corner would be nine widths away.
    let sharp = [Point::new(2, 20), Point::new(40, 23), Point::new(2, 26)];
    let sharp = Polyline::new(&sharp).into_styled(PrimitiveStyle::with_stroke(STROKE, 3));
    let drawn = painted(screen(), |band| {
        let Ok(()) = sharp.draw_on(band);
    });
    assert_eq!(drawn.iter().map(|point| point.x).max(), Some(40));
}

#[test]
fn the_widest_strokes_fill_the_screen() {
    for width in [4096, 100_000, u32::MAX] {
        for (from, to) in [
            ((-3000, 90), (3000, -80)),
            ((i32::MIN, 0), (i32::MAX, 0)),
            ((i32::MIN, i32::MAX), (i32::MAX, i32::MIN)),
        ] {
            let all = painted(screen(), |band| {
                let line = Line::new(from.into(), to.into());
                let Ok(()) = line
                    .into_styled(PrimitiveStyle::with_stroke(STROKE, width))
                    .draw_on(band);
            });
            assert_eq!(all.len(), 64 * 64);
        }
    }
}

/// The pixels of a triangle's three lines that are visible, and their colours.
fn colors_along_lines(triangle: Triangle, style: PrimitiveStyle<Rgb565>, window: Rectangle) -> Vec<(Point, Rgb565)> {
    let mut vertices = triangle.vertices;
    let colors = picture(window, |band| {
        let Ok(()) = triangle.into_styled(style).draw_on(band);
    });
    vertices.sort_by_key(|vertex| (vertex.y, vertex.x));
    let [a, b, c] = vertices;
    let is_on_line = |point: Point| {
        [(a, b), (a, c), (b, c)]
            .iter()
            .filter_map(|&(from, to)| walked_run(from, to, point.y))
            .any(|(first, last)| (first..=last).contains(&i128::from(point.x)))
    };
    window
        .points()
        .zip(colors)
        .filter(|&(point, _)| is_on_line(point))
        .collect()
}

proptest! {
    #![proptest_config(config(cases(200, 2_000)))]

    /// Triangles without an area, and long ones that are at most a few pixels thin, seen around each corner.
    #[test]
    fn a_wide_stroke_covers_the_lines_of_a_triangle(
        start in (-8192..8192i32, -8192..8192i32),
        direction in (-9..10i32, -9..10i32),
        steps in (-900..900i32, -900..900i32),
        aside in prop::sample::select(vec![(0, 0), (0, 0), (1, 0), (0, 1), (2, -1)]),
        width in 2..9u32,
        is_inside in any::<bool>(),
    ) {
        let start = Point::new(start.0, start.1);
        let corner = |steps: i32| start + Point::new(direction.0, direction.1) * steps;
        let triangle = Triangle::new(start, corner(steps.0), corner(steps.1) + Point::new(aside.0, aside.1));
        let alignment = if is_inside { StrokeAlignment::Inside } else { StrokeAlignment::Center };
        for vertex in triangle.vertices {
            let window = Rectangle::with_center(vertex, Size::new_equal(9));
            for (point, color) in colors_along_lines(triangle, style(width, alignment), window) {
                prop_assert_eq!(color, STROKE, "{} of {:?}, {} {:?}", point, triangle, width, alignment);
            }
        }
    }
}

#[test]
fn a_fill_does_not_show_at_the_ends_of_a_triangle_without_an_area() {
    let triangle = Triangle::new(Point::new(5, 10), Point::new(15, 0), Point::new(10, 5));
    let mut display = MockDisplay::new();
    let styled = triangle.into_styled(style(5, StrokeAlignment::Inside));
    styled.draw(&mut display).unwrap();
    let line = (0..=10).map(|step| Point::new(5 + step, 10 - step));
    display.assert_eq(&MockDisplay::from_points(line, STROKE));
}

#[test]
fn extreme_triangles_with_wide_strokes_do_not_wrap() {
    let ends = [i32::MIN, 9, i32::MAX];
    let corners: Vec<Point> = ends
        .iter()
        .flat_map(|&x| ends.iter().map(move |&y| Point::new(x, y)))
        .collect();
    for &a in &corners {
        for &b in &corners {
            for &c in corners.iter().step_by(by_depth(4, 1, 1)) {
                if (a.x, a.y) > (b.x, b.y) || (b.x, b.y) > (c.x, c.y) {
                    continue;
                }
                for alignment in [
                    StrokeAlignment::Inside,
                    StrokeAlignment::Center,
                    StrokeAlignment::Outside,
                ] {
                    let triangle = Triangle::new(a, b, c);
                    let colored = painted(screen(), |band| {
                        let Ok(()) = triangle.into_styled(style(3, alignment)).draw_on(band);
                    });
                    let filled = painted(screen(), |band| {
                        let Ok(()) = triangle.into_styled(PrimitiveStyle::with_fill(FILL)).draw_on(band);
                    });
                    match alignment {
                        StrokeAlignment::Inside => assert_eq!(colored, filled, "{triangle:?}"),
                        _ => assert!(filled.iter().all(|point| colored.contains(point)), "{triangle:?}"),
                    }
                }
            }
        }
    }
}
