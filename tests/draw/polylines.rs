//! One-pixel polylines: the union of their lines, wherever they are moved to.

use std::collections::BTreeSet;

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Rgb565},
    prelude::*,
    primitives::{self, Polyline, Rectangle},
};
use proptest::prelude::*;
use zrow::draw::{DrawOn, PrimitiveStyle};

use crate::common::{cases, config, encloses, painted};
use crate::reference::nearest_pixels::nearest;

type Vertex = (i128, i128);

/// Every pixel of the line inside the window, ties to the larger coordinate.
fn add_line((x0, y0): Vertex, (x1, y1): Vertex, window: Rectangle, pixels: &mut BTreeSet<(i32, i32)>) {
    let (dx, dy) = (x1 - x0, y1 - y0);
    let (rows, columns) = (window.rows(), window.columns());
    let mut add = |x: i128, y: i128| {
        if i128::from(columns.start) <= x
            && x < i128::from(columns.end)
            && i128::from(rows.start) <= y
            && y < i128::from(rows.end)
        {
            pixels.insert((y as i32, x as i32));
        }
    };
    if dx == 0 && dy == 0 {
        add(x0, y0);
    } else if dx.abs() >= dy.abs() {
        for x in columns
            .clone()
            .map(i128::from)
            .filter(|x| (x0.min(x1)..=x0.max(x1)).contains(x))
        {
            add(x, y0 + nearest((x - x0) * dy * dx.signum(), dx.abs()));
        }
    } else {
        for y in rows
            .clone()
            .map(i128::from)
            .filter(|y| (y0.min(y1)..=y0.max(y1)).contains(y))
        {
            add(x0 + nearest((y - y0) * dx * dy.signum(), dy.abs()), y);
        }
    }
}

fn reference(vertices: &[Point], translate: Point, window: Rectangle) -> Vec<Point> {
    let moved = |point: Point| {
        (
            i128::from(point.x) + i128::from(translate.x),
            i128::from(point.y) + i128::from(translate.y),
        )
    };
    let mut pixels = BTreeSet::new();
    for pair in vertices.windows(2) {
        add_line(moved(pair[0]), moved(pair[1]), window, &mut pixels);
    }
    pixels.into_iter().map(|(y, x)| Point::new(x, y)).collect()
}

fn check(vertices: &[Point], translate: Point, window: Rectangle) {
    let polyline = Polyline { translate, vertices }.into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1));
    let drawn = painted(window, |band| {
        let Ok(()) = polyline.draw_on(band);
    });
    assert_eq!(
        drawn,
        reference(vertices, translate, window),
        "{vertices:?} moved by {translate}"
    );
    let bounds = polyline.bounding_box();
    assert!(
        drawn.iter().all(|&point| encloses(&bounds, point)),
        "{vertices:?} in {bounds:?}"
    );
}

fn window() -> Rectangle {
    Rectangle::new(Point::new(-3, 5), Size::new(48, 40))
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        5 => -10..60i32,
        1 => -3000..3000i32,
        1 => any::<i32>(),
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, i32::MAX, i32::MAX - 1, -4, -3, 44, 45, 4, 5]),
    ]
}

fn point() -> impl Strategy<Value = Point> {
    (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y))
}

proptest! {
    #![proptest_config(config(cases(2_000, 2_000)))]

    #[test]
    fn polylines_are_the_union_of_their_lines(vertices in prop::collection::vec(point(), 0..6)) {
        check(&vertices, Point::zero(), window());
    }

    #[test]
    fn moved_polylines_do_not_wrap(vertices in prop::collection::vec(point(), 2..5), translate in point()) {
        check(&vertices, translate, window());
    }

    #[test]
    fn polylines_moved_into_sight_are_exact(corners in prop::collection::vec((-50..50i32, -50..50i32), 2..5), x in any::<i32>(), y in any::<i32>()) {
        let centre = Point::new(x, y).component_max(Point::new(i32::MIN + 50, i32::MIN + 50)).component_min(Point::new(i32::MAX - 50, i32::MAX - 50));
        let vertices: Vec<Point> = corners.iter().map(|&(dx, dy)| centre + Point::new(dx, dy)).collect();
        let translate = Point::new(20_i32.saturating_sub(centre.x), 20_i32.saturating_sub(centre.y));
        check(&vertices, translate, window());
    }

    #[test]
    fn vertices_are_drawn_once(start in (20..40i32, 20..40i32), steps in prop::collection::vec((0..6i32, -5..6i32), 1..6)) {
        // Rightwards lines meet in their vertices only; the display panics on a pixel drawn twice.
        let mut vertices = vec![Point::new(start.0 - 20, start.1)];
        for (dx, dy) in steps {
            let last = *vertices.last().unwrap();
            vertices.push(last + Point::new(dx + 6, dy));
        }
        let mut display = MockDisplay::new();
        display.set_allow_out_of_bounds_drawing(true);
        Polyline::new(&vertices).into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1)).draw(&mut display).unwrap();
    }
}

#[test]
fn the_longest_polylines_are_exact() {
    let ends = [i32::MIN, 0, i32::MAX];
    let corners: Vec<Point> = ends
        .iter()
        .flat_map(|&x| ends.iter().map(move |&y| Point::new(x, y)))
        .collect();
    for &from in &corners {
        for &to in &corners {
            for &translate in &corners {
                check(&[from, to], translate, window());
                check(&[from, to, from], translate, window());
            }
        }
    }
}

#[test]
fn few_or_equal_vertices_draw_what_embedded_graphics_draws() {
    let lists: [&[Point]; 5] = [
        &[],
        &[Point::new(3, 4)],
        &[Point::new(3, 4); 3],
        &[Point::new(3, 4), Point::new(3, 4), Point::new(8, 5)],
        &[Point::new(2, 5), Point::new(5, 2), Point::new(10, 5), Point::new(15, 2)],
    ];
    for vertices in lists {
        let mut expected = MockDisplay::new();
        Polyline::new(vertices)
            .into_styled(primitives::PrimitiveStyle::with_stroke(BinaryColor::On, 1))
            .draw(&mut expected)
            .unwrap();
        let mut display = MockDisplay::new();
        Polyline::new(vertices)
            .into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1))
            .draw(&mut display)
            .unwrap();
        display.assert_eq(&expected);
    }
}
