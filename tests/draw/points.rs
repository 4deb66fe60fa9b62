//! Points against their definitions, pixel by pixel, and against the shapes that have the same style.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, PrimitiveStyleBuilder, Rectangle},
};
use proptest::prelude::*;
use zrow::draw::{DrawOn, Points, PrimitiveStyle, StrokeAlignment};

use crate::common::{cases, config, painted, picture};

fn area() -> Rectangle {
    Rectangle::new(Point::new(-9, 3), Size::new(48, 40))
}

fn distances(center: Point, pixel: Point) -> (i128, i128) {
    let apart = |one: i32, other: i32| (i128::from(one) - i128::from(other)).abs();
    (apart(center.x, pixel.x), apart(center.y, pixel.y))
}

fn in_square(center: Point, radius: u32, pixel: Point) -> bool {
    let (dx, dy) = distances(center, pixel);
    dx.max(dy) <= i128::from(radius)
}

fn in_disc(center: Point, radius: u32, pixel: Point) -> bool {
    let (dx, dy) = distances(center, pixel);
    let radius = i128::from(radius);
    let limit = if radius == 1 { 1 } else { radius * radius + radius };
    dx * dx + dy * dy <= limit
}

type IsInside = fn(Point, u32, Point) -> bool;

fn check(centers: &[Point], radius: u32, area: Rectangle) {
    let style = PrimitiveStyle::with_fill(Rgb565::WHITE);
    let shapes: [(Points<'_>, IsInside); 2] = [
        (Points::squares(centers, radius), in_square),
        (Points::discs(centers, radius), in_disc),
    ];
    for (points, is_inside) in shapes {
        let expected: Vec<Point> = area
            .points()
            .filter(|&pixel| centers.iter().any(|&center| is_inside(center, radius, pixel)))
            .collect();
        let drawn = painted(area, |band| {
            let Ok(()) = points.into_styled(style).draw_on(band);
        });
        assert_eq!(drawn, expected, "{points:?} in {area:?}");
        // The other entry point.
        let drawn = painted(area, |band| {
            let Ok(()) = points.into_styled(style).draw(band);
        });
        assert_eq!(drawn, expected, "{points:?} in {area:?}");
    }
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        6 => -20..60i32,
        1 => any::<i32>(),
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, i32::MAX - 1, i32::MAX]),
    ]
}

fn radius() -> impl Strategy<Value = u32> {
    prop_oneof![8 => 0..12u32, 2 => 0..200u32, 1 => 0..=i32::MAX as u32, 1 => Just(i32::MAX as u32)]
}

proptest! {
    #![proptest_config(config(cases(2_000, 2_000)))]

    #[test]
    fn points_are_their_definition(
        centers in prop::collection::vec((coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y)), 0..4),
        radius in radius(),
        row in prop::option::of(3..43i32),
    ) {
        let area = match row {
            Some(row) => Rectangle::new(Point::new(-9, row), Size::new(48, 1)),
            None => area(),
        };
        check(&centers, radius, area);
    }

    #[test]
    fn a_style_is_that_of_the_shape(
        x in -10..50i32, y in -5..50i32,
        radius in 0..20u32,
        width in 0..6u32,
        alignment in prop::sample::select(vec![StrokeAlignment::Inside, StrokeAlignment::Center, StrokeAlignment::Outside]),
        (has_fill, has_stroke) in any::<(bool, bool)>(),
    ) {
        let mut style = PrimitiveStyleBuilder::new().stroke_width(width).stroke_alignment(alignment);
        if has_fill {
            style = style.fill_color(Rgb565::GREEN);
        }
        if has_stroke {
            style = style.stroke_color(Rgb565::RED);
        }
        let style = PrimitiveStyle::from(style.build());
        let center = Point::new(x, y);
        let rectangle = Rectangle::new(center - Point::new_equal(radius as i32), Size::new_equal(2 * radius + 1));
        let circle = Circle::new(rectangle.top_left, 2 * radius + 1);
        let centers = [center];
        let (squares, discs) = (Points::squares(&centers, radius), Points::discs(&centers, radius));
        let of_squares = picture(area(), |band| { let Ok(()) = squares.into_styled(style).draw_on(band); });
        let of_rectangle = picture(area(), |band| { let Ok(()) = rectangle.into_styled(style).draw_on(band); });
        prop_assert_eq!(of_squares, of_rectangle);
        let of_discs = picture(area(), |band| { let Ok(()) = discs.into_styled(style).draw_on(band); });
        let of_circle = picture(area(), |band| { let Ok(()) = circle.into_styled(style).draw_on(band); });
        prop_assert_eq!(of_discs, of_circle);
        prop_assert_eq!(squares.into_styled(style).bounding_box(), rectangle.into_styled(style).bounding_box());
        prop_assert_eq!(discs.into_styled(style).bounding_box(), circle.into_styled(style).bounding_box());
    }
}

#[test]
fn the_largest_points_at_the_ends_of_the_number_range() {
    let ends = [i32::MIN, i32::MIN + 1, 0, i32::MAX - 1, i32::MAX];
    for center in ends.into_iter().flat_map(|x| ends.map(|y| Point::new(x, y))) {
        for radius in [0, 1, i32::MAX as u32 - 1, i32::MAX as u32] {
            for top_left in [
                Point::new(i32::MIN, i32::MIN),
                Point::new(-3, -3),
                Point::new(i32::MAX - 7, i32::MIN),
            ] {
                check(&[center], radius, Rectangle::new(top_left, Size::new(7, 7)));
            }
        }
    }
}

#[test]
fn boxes_have_no_overflow() {
    let centers = [Point::new(i32::MIN, 5), Point::new(i32::MAX, 9)];
    let points = Points::squares(&centers, 3);
    assert_eq!(
        points.bounding_box(),
        Rectangle::new(Point::new(i32::MIN, 2), Size::new(u32::MAX, 11))
    );
    // A radius that no square has draws the largest.
    let style = PrimitiveStyle::with_fill(Rgb565::WHITE);
    let centers = [Point::new(i32::MAX, 9)];
    let [of_no_radius, of_the_largest] = [u32::MAX, i32::MAX as u32].map(|radius| {
        painted(area(), |band| {
            let Ok(()) = Points::discs(&centers, radius).into_styled(style).draw_on(band);
        })
    });
    assert_eq!(of_no_radius, of_the_largest);
    assert_eq!(Points::discs(&[], 3).bounding_box(), Rectangle::zero());
}
