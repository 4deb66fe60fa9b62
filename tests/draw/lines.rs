//! One-pixel lines against the exact nearest-pixel rule, in `i128`.

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Rgb565},
    prelude::*,
    primitives::{Line, Rectangle},
};
use proptest::prelude::*;
use zrow::draw::{DrawOn, PrimitiveStyle};

use crate::common::{cases, config, painted};

/// `floor(numerator / denominator + 1/2)`, the nearest integer with ties upwards.
fn nearest(numerator: i128, denominator: i128) -> i128 {
    (2 * numerator + denominator).div_euclid(2 * denominator)
}

/// Every pixel of the line inside `window`, by evaluating the exact line in each visible step of its major axis.
fn exact_line(from: Point, to: Point, window: Rectangle) -> Vec<Point> {
    let (x0, y0) = (i128::from(from.x), i128::from(from.y));
    let (dx, dy) = (i128::from(to.x) - x0, i128::from(to.y) - y0);
    let columns = window.columns();
    let rows = window.rows();
    let mut pixels = Vec::new();
    if dx.abs() >= dy.abs() {
        for x in columns {
            if x < from.x.min(to.x) || x > from.x.max(to.x) {
                continue;
            }
            let y = if dx == 0 {
                y0
            } else {
                y0 + nearest((i128::from(x) - x0) * dy * dx.signum(), dx.abs())
            };
            if y >= i128::from(rows.start) && y < i128::from(rows.end) {
                pixels.push(Point::new(x, y as i32));
            }
        }
    } else {
        for y in rows {
            if y < from.y.min(to.y) || y > from.y.max(to.y) {
                continue;
            }
            let x = x0 + nearest((i128::from(y) - y0) * dx * dy.signum(), dy.abs());
            if x >= i128::from(columns.start) && x < i128::from(columns.end) {
                pixels.push(Point::new(x as i32, y));
            }
        }
    }
    pixels.sort_by_key(|point| (point.y, point.x));
    pixels
}

fn drawn_line(from: Point, to: Point, window: Rectangle) -> Vec<Point> {
    let line = Line::new(from, to).into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1));
    painted(window, |band| {
        let Ok(()) = line.draw_on(band);
    })
}

fn check(from: Point, to: Point, window: Rectangle) {
    let expected = exact_line(from, to, window);
    assert_eq!(drawn_line(from, to, window), expected, "{from} to {to} in {window:?}");
    assert_eq!(drawn_line(to, from, window), expected, "{to} to {from} in {window:?}");
}

fn window() -> Rectangle {
    Rectangle::new(Point::new(-3, 5), Size::new(64, 48))
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

proptest! {
    #![proptest_config(config(cases(6_000, 6_000)))]

    #[test]
    fn lines_are_exact_in_either_order(from in point(), to in point()) {
        check(from, to, window());
    }

    #[test]
    fn lines_are_exact_in_one_row(from in point(), to in point(), y in 0..60i32) {
        check(from, to, Rectangle::new(Point::new(0, y), Size::new(64, 1)));
    }

    #[test]
    fn lines_through_a_window_corner_are_exact(dx in -9000..9000i32, dy in -9000..9000i32, corner in 0..4usize, shift in 0..3i32) {
        let window = window();
        let bottom_right = window.bottom_right().unwrap();
        let corner = [window.top_left, bottom_right, Point::new(window.top_left.x, bottom_right.y), Point::new(bottom_right.x, window.top_left.y)][corner];
        let (from, to) = (corner + Point::new(dx, dy), corner - Point::new(dx + shift - 1, dy));
        check(from, to, window);
    }
}

#[test]
fn all_octants_ties_and_short_lines() {
    for x in -9..=9 {
        for y in -9..=9 {
            let from = Point::new(20, 25);
            check(from, from + Point::new(x, y), window());
        }
    }
}

#[test]
fn the_flattest_slopes_are_exact() {
    for (dx, dy) in [(8191, 1), (8191, -1), (1, 8191), (-1, 8191), (16_382, 1)] {
        for shift in -2..3 {
            let middle = Point::new(28, 30 + shift);
            check(
                middle - Point::new(dx / 2, dy / 2),
                middle + Point::new(dx - dx / 2, dy - dy / 2),
                window(),
            );
        }
    }
}

#[test]
fn the_longest_lines_are_exact() {
    let ends = [i32::MIN, i32::MAX, 0];
    for from_x in ends {
        for from_y in ends {
            for to_x in ends {
                for to_y in ends {
                    check(Point::new(from_x, from_y), Point::new(to_x, to_y), window());
                }
            }
        }
    }
}

#[test]
fn a_line_half_a_pixel_outside_shows_its_nearest_pixels() {
    // Row 4 is outside; the line rises into row 5 by rounding in its second half.
    check(Point::new(0, 4), Point::new(10, 5), window());
    check(Point::new(-100, 4), Point::new(101, 5), window());
    check(Point::new(0, 53), Point::new(40, 52), window());
}

#[test]
fn a_tie_goes_to_the_larger_coordinate() {
    let mut display = MockDisplay::new();
    let style = PrimitiveStyle::with_stroke(BinaryColor::On, 1);
    Line::new(Point::new(0, 0), Point::new(4, 2))
        .into_styled(style)
        .draw(&mut display)
        .unwrap();
    Line::new(Point::new(6, 2), Point::new(10, 0))
        .into_styled(style)
        .draw(&mut display)
        .unwrap();
    display.assert_pattern(&["#         #", " ##     ## ", "   ## ##   "]);
}
