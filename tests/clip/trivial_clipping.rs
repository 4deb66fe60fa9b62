//! Circles and rectangles against windows: every pixel asked, and embedded-graphics' own pixels.

use embedded_graphics::{
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
};
use proptest::prelude::*;
use zrow::{clip::Classification, geometry::Window};

use crate::common::{cases, config};

/// What the pixels of a shape, and of the window, say.
fn by_pixels(shape: &[Point], window: &Window) -> Classification {
    let visible = shape.iter().filter(|&&pixel| window.contains(pixel)).count();
    if visible == 0 {
        Classification::Nothing
    } else if visible == shape.len() {
        Classification::Whole
    } else if visible == (window.width() * window.height()) as usize {
        Classification::Fills
    } else {
        Classification::Part
    }
}

fn check_circle(circle: Circle, window: &Window) -> Classification {
    let style = PrimitiveStyle::with_fill(embedded_graphics::pixelcolor::BinaryColor::On);
    let pixels: Vec<Point> = circle.into_styled(style).pixels().map(|pixel| pixel.0).collect();
    let expected = by_pixels(&pixels, window);
    let found = Classification::circle_against_window(&circle, window);
    assert_eq!(found, expected, "{circle:?} in {window:?}");
    found
}

fn check_rectangle(rectangle: Rectangle, window: &Window) {
    let pixels: Vec<Point> = rectangle.points().collect();
    let expected = by_pixels(&pixels, window);
    let found = Classification::rectangle_against_window(&rectangle, window);
    assert_eq!(found, expected, "{rectangle:?} in {window:?}");

    let visible: Vec<Point> = pixels.into_iter().filter(|&pixel| window.contains(pixel)).collect();
    let part = window.clip_rectangle(&rectangle);
    let shown: Vec<Point> = part.iter().flat_map(|part| part.points()).collect();
    assert_eq!(shown, visible, "{rectangle:?} in {window:?}");
    if let Some(part) = part {
        assert_eq!(window.clip_rectangle(&part), Some(part));
    }
}

const WINDOW: Window = Window {
    left: 0,
    top: -1,
    right: 6,
    bottom: 3,
};

#[test]
fn every_small_circle_is_exact() {
    for diameter in 0..=16 {
        for x in -18..=8 {
            for y in -18..=5 {
                check_circle(Circle::new(Point::new(x, y), diameter), &WINDOW);
            }
        }
    }
}

#[test]
fn every_small_rectangle_is_exact() {
    for (width, height) in (0..=9).flat_map(|width| (0..=9).map(move |height| (width, height))) {
        for (x, y) in (-10..=7).flat_map(|x| (-10..=4).map(move |y| (x, y))) {
            check_rectangle(Rectangle::new(Point::new(x, y), Size::new(width, height)), &WINDOW);
        }
    }
}

proptest! {
    #![proptest_config(config(cases(1_500, 1_500)))]

    #[test]
    fn circles_are_exact(x in -90..90i32, y in -90..90i32, diameter in 0..120u32) {
        let window = Window { left: -10, top: 0, right: 30, bottom: 25 };
        check_circle(Circle::new(Point::new(x, y), diameter), &window);
    }

    /// Circles of any size against a window of one pixel: it is in the circle, or it is not.
    #[test]
    fn a_pixel_is_in_a_circle_of_any_size_or_not(
        x in any::<i32>(), y in any::<i32>(), diameter in any::<u32>(),
        column in -4_000_000_000..4_000_000_000i64, row in -4_000_000_000..4_000_000_000i64,
    ) {
        let coordinate = |value: i64| value.clamp(i32::MIN.into(), (i32::MAX - 1).into()) as i32;
        let (left, top) = (coordinate(column), coordinate(row));
        let window = Window { left, top, right: left + 1, bottom: top + 1 };
        let doubled = |at: i32, start: i32| {
            2 * (i128::from(at) - i128::from(start)) - (i128::from(diameter) - 1)
        };
        let (dx, dy) = (doubled(left, x), doubled(top, y));
        let correction = if diameter <= 4 { i128::from(diameter / 2) } else { 0 };
        let is_inside = dx * dx + dy * dy < i128::from(diameter) * i128::from(diameter) - correction;
        let found = Classification::circle_against_window(&Circle::new(Point::new(x, y), diameter), &window);
        prop_assert_eq!(found != Classification::Nothing, is_inside);
        prop_assert_eq!(found == Classification::Fills, is_inside && diameter > 1);
    }
}

#[test]
fn the_corner_of_a_box_is_no_part_of_its_circle() {
    let window = Window {
        left: 0,
        top: 0,
        right: 128,
        bottom: 64,
    };
    let at = |x, y, diameter| check_circle(Circle::with_center(Point::new(x, y), diameter), &window);
    assert_eq!(at(-14, -14, 41), Classification::Part);
    assert_eq!(at(-15, -15, 41), Classification::Nothing);
    assert_eq!(at(64, 32, 400), Classification::Fills);
    assert_eq!(at(64, 32, 63), Classification::Whole);
}

#[test]
fn the_ends_of_the_number_range_are_exact() {
    let last = Window {
        left: i32::MAX - 2,
        top: i32::MAX - 2,
        right: i32::MAX,
        bottom: i32::MAX,
    };
    let whole = Window {
        left: i32::MIN,
        top: i32::MIN,
        ..last
    };
    // Its last column is that which no window has.
    let corner = Point::new(i32::MAX - 2, i32::MAX - 2);
    let beyond = |side| Rectangle::new(corner, Size::new_equal(side));
    for (side, in_last, in_whole) in [
        (2, Classification::Whole, Classification::Whole),
        (3, Classification::Fills, Classification::Part),
        (u32::MAX, Classification::Fills, Classification::Part),
    ] {
        assert_eq!(Classification::rectangle_against_window(&beyond(side), &last), in_last);
        assert_eq!(
            Classification::rectangle_against_window(&beyond(side), &whole),
            in_whole
        );
        assert_eq!(last.clip_rectangle(&beyond(side)), Some(last.to_rectangle()));
    }
    let largest = Circle::new(Point::new(i32::MIN, i32::MIN), u32::MAX);
    assert_eq!(
        Classification::circle_against_window(&largest, &whole),
        Classification::Whole
    );
    assert_eq!(
        Classification::circle_against_window(&largest, &last),
        Classification::Nothing
    );
    assert_eq!(
        Classification::circle_against_window(&largest, &WINDOW),
        Classification::Fills
    );
    for diameter in [0, 1, u32::MAX] {
        let circle = Circle::new(Point::new(i32::MAX, i32::MAX), diameter);
        assert_eq!(
            Classification::circle_against_window(&circle, &whole),
            Classification::Nothing
        );
    }
}

#[test]
fn an_empty_window_shows_nothing() {
    let rectangle = Rectangle::new(Point::new(-9, -9), Size::new(50, 50));
    let circle = Circle::new(Point::new(-9, -9), 50);
    for empty in [
        Window::EMPTY,
        Window {
            left: 5,
            top: 0,
            right: 3,
            bottom: 9,
        },
    ] {
        assert_eq!(
            Classification::rectangle_against_window(&rectangle, &empty),
            Classification::Nothing
        );
        assert_eq!(empty.clip_rectangle(&rectangle), None);
        assert_eq!(
            Classification::circle_against_window(&circle, &empty),
            Classification::Nothing
        );
    }
}
