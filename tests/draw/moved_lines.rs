//! One-pixel lines that `Polyline::translate` moves, also beyond `i32`: around any of their points they are exact.

use std::collections::BTreeSet;

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Polyline, Rectangle},
};
use proptest::prelude::*;
use zrow::draw::{DrawOn, PrimitiveStyle};

use crate::common::{cases, config, painted};
use crate::reference::nearest_pixels::{nearest, pixels};

/// Draws a moved line in a window, and by its definition.
fn check(vertices: [Point; 2], translate: Point, window: Rectangle) -> Result<usize, TestCaseError> {
    let mut line = Polyline::new(&vertices);
    line.translate = translate;
    let drawn = painted(window, |band| {
        let Ok(()) = line
            .into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1))
            .draw_on(band);
    });
    let drawn: BTreeSet<_> = drawn
        .into_iter()
        .map(|point| (i128::from(point.x), i128::from(point.y)))
        .collect();
    let [from, to] = vertices.map(|vertex| {
        (
            i128::from(vertex.x) + i128::from(translate.x),
            i128::from(vertex.y) + i128::from(translate.y),
        )
    });
    let expected = pixels(from, to, window);
    prop_assert_eq!(&drawn, &expected, "{:?} by {} in {:?}", vertices, translate, window);
    Ok(expected.len())
}

/// The line that takes the most steps a line can have, seen where it ends: more than 2^32 behind the window's other side.
#[test]
fn the_last_of_the_most_steps_are_drawn() {
    for (along, translate, first) in [(i32::MIN, i32::MIN, -10), (i32::MAX, i32::MAX, -40)] {
        let (near, far) = (!along, along);
        let window = Rectangle::new(Point::new(first, first), Size::new(64, 64));
        for aside in [-3, 0, 5] {
            let level = [Point::new(far, aside), Point::new(near, aside)];
            let shown = check(level, Point::new(translate, 0), window).unwrap();
            let upright = level.map(|Point { x, y }| Point::new(y, x));
            assert_eq!(shown, check(upright, Point::new(0, translate), window).unwrap());
            assert!(shown >= 10, "{shown}");
        }
        let diagonal = [Point::new_equal(far), Point::new_equal(near)];
        assert!(check(diagonal, Point::new_equal(translate), window).unwrap() >= 10);
    }
}

fn coordinate() -> impl Strategy<Value = i32> {
    let extremes = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    prop_oneof![2 => prop::sample::select(extremes.to_vec()), 1 => any::<i32>(), 1 => -100..100i32]
}

fn point() -> impl Strategy<Value = Point> {
    (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y))
}

proptest! {
    #![proptest_config(config(cases(8_000, 8_000)))]

    /// Wherever the line is looked at: at its ends and in between.
    #[test]
    fn moved_lines_are_exact_around_any_of_their_points(
        from in point(),
        to in point(),
        translate in point(),
        part in prop_oneof![Just(0u32), Just(1 << 16), Just(1 << 15), 0..=1u32 << 16],
        aside in (-20..20i32, -20..20i32),
    ) {
        let along = |from: i32, to: i32, translate: i32, aside: i32| {
            let (from, to) = (i128::from(from), i128::from(to));
            let at = from + nearest((to - from) * i128::from(part), 1 << 16) + i128::from(translate) + i128::from(aside);
            // The window ends before the last coordinate.
            at.clamp(i128::from(i32::MIN), i128::from(i32::MAX - 16)) as i32
        };
        let corner = Point::new(
            along(from.x, to.x, translate.x, aside.0),
            along(from.y, to.y, translate.y, aside.1),
        );
        check([from, to], translate, Rectangle::new(corner, Size::new(16, 16)))?;
    }
}
