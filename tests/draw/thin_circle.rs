//! The thin circle against the nearest-pixel rule, pixel by pixel.

use std::collections::BTreeSet;

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Rgb565},
    prelude::*,
    primitives::{PrimitiveStyleBuilder, Rectangle},
};
use proptest::prelude::*;
use zrow::draw::{DrawOn, PrimitiveStyle, ThinCircle};

use crate::common::{cases, config, painted};

/// Whether `y` is the integer nearest to the root of `r^2 - x^2`: the root is between `y - 1/2` and `y + 1/2`.
fn is_nearest(y: i128, radius: i128, x: i128) -> bool {
    let square = radius * radius - x * x;
    let above = 4 * square > (2 * y - 1) * (2 * y - 1) || y == 0;
    above && 4 * square < (2 * y + 1) * (2 * y + 1)
}

/// Whether a pixel is on the circle: an octant has the columns up to the diagonal, x <= y.
fn on_circle(center: Point, radius: u32, pixel: Point) -> bool {
    let dx = (i128::from(pixel.x) - i128::from(center.x)).abs();
    let dy = (i128::from(pixel.y) - i128::from(center.y)).abs();
    let (x, y, radius) = (dx.min(dy), dx.max(dy), i128::from(radius));
    x <= radius && is_nearest(y, radius, x)
}

fn drawn(center: Point, radius: u32, window: Rectangle) -> Vec<Point> {
    painted(window, |band| {
        ThinCircle::new(center, radius)
            .into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1))
            .draw_on(band)
            .unwrap();
    })
}

fn check(center: Point, radius: u32, window: Rectangle) {
    let expected: Vec<Point> = window
        .points()
        .filter(|&pixel| on_circle(center, radius, pixel))
        .collect();
    assert_eq!(
        drawn(center, radius, window),
        expected,
        "radius {radius} about {center} in {window:?}"
    );
}

fn whole(radius: u32) -> Rectangle {
    Rectangle::new(Point::new_equal(-1 - radius as i32), Size::new_equal(2 * radius + 3))
}

#[test]
fn small_circles_are_exact_symmetric_and_connected() {
    for radius in 0..=70 {
        check(Point::zero(), radius, whole(radius));
        let pixels: BTreeSet<(i32, i32)> = drawn(Point::zero(), radius, whole(radius))
            .iter()
            .map(|p| (p.x, p.y))
            .collect();
        let mut reached = BTreeSet::new();
        let mut open = vec![(0, radius as i32)];
        while let Some((x, y)) = open.pop() {
            if !pixels.contains(&(x, y)) || !reached.insert((x, y)) {
                continue;
            }
            for symmetric in [(-x, y), (x, -y), (y, x)] {
                assert!(pixels.contains(&symmetric), "{symmetric:?} of radius {radius}");
            }
            open.extend((-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy))));
        }
        assert_eq!(reached, pixels, "radius {radius} is in one piece");
    }
}

#[test]
fn each_pixel_is_drawn_once_and_the_fill_is_what_the_line_encloses() {
    let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
        .stroke_color(Rgb565::RED)
        .stroke_width(1)
        .fill_color(Rgb565::BLUE)
        .build()
        .into();
    for radius in 0..=31 {
        // Overdraw panics.
        let mut display = MockDisplay::new();
        ThinCircle::new(Point::new(32, 31), radius)
            .into_styled(style)
            .draw(&mut display)
            .unwrap();
        for y in 0..64 {
            let row: Vec<Option<Rgb565>> = (0..64).map(|x| display.get_pixel(Point::new(x, y))).collect();
            let line = |x: usize| row[x] == Some(Rgb565::RED);
            let (first, last) = ((0..64).find(|&x| line(x)), (0..64).rfind(|&x| line(x)));
            for (x, color) in row.iter().enumerate() {
                let between = first.is_some_and(|first| x > first) && last.is_some_and(|last| x < last);
                assert_eq!(color.is_some(), between || line(x), "radius {radius}, {x}, {y}");
            }
        }
    }
}

proptest! {
    #![proptest_config(config(cases(3_000, 3_000)))]

    #[test]
    fn circles_of_any_radius_are_exact_in_a_window(
        radius in prop_oneof![0..200u32, 0..100_000u32, 0..=i32::MAX as u32, Just(i32::MAX as u32)],
        along in any::<u32>(),
        (right, below, steep) in any::<(bool, bool, bool)>(),
        (x, y) in (-20..60i64, -20..60i64),
        row in prop::option::of(0..40u32),
    ) {
        // A random point of the circle is moved to (x, y).
        let r = u128::from(radius);
        let dx = (u128::from(along) * r) >> 32;
        let dy = (r * r - dx * dx).isqrt() as i64;
        let dx = dx as i64;
        let (dx, dy) = if steep { (dy, dx) } else { (dx, dy) };
        let to = |offset: i64, distance: i64, mirrored: bool| {
            (offset + if mirrored { -distance } else { distance }).clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
        };
        let center = Point::new(to(x, dx, right), to(y, dy, below));
        let window = match row {
            Some(row) => Rectangle::new(Point::new(0, row as i32), Size::new(48, 1)),
            None => Rectangle::new(Point::zero(), Size::new(48, 40)),
        };
        check(center, radius, window);
    }
}

#[test]
fn the_largest_circles_are_exact_at_the_ends_of_the_number_range() {
    let coordinates = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    for x in coordinates {
        for y in coordinates {
            for radius in [i32::MAX as u32, i32::MAX as u32 - 1, 1 << 30, 46_341, 0] {
                check(
                    Point::new(x, y),
                    radius,
                    Rectangle::new(Point::new(-4, -4), Size::new(9, 9)),
                );
                check(
                    Point::new(x, y),
                    radius,
                    Rectangle::new(Point::new(i32::MIN, i32::MAX - 9), Size::new(9, 9)),
                );
            }
        }
    }
}

#[test]
fn the_box_and_moving_have_no_overflow() {
    let circle = ThinCircle::new(Point::new(i32::MAX, i32::MIN), u32::MAX);
    assert_eq!(
        circle.bounding_box(),
        Rectangle::new(Point::new(0, i32::MIN), Size::new(u32::MAX, 1 << 31))
    );
    assert_eq!(
        circle.translate(Point::new(1, -1)).center,
        Point::new(i32::MAX, i32::MIN)
    );
    let mut display = MockDisplay::new();
    ThinCircle::new(Point::new(2, 2), 1)
        .into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 9))
        .draw(&mut display)
        .unwrap();
    display.assert_pattern(&["     ", "  #  ", " # # ", "  #  "]);
}
