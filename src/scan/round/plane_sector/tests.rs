//! The half planes and pieces of a sector of the plane, for any numbers, against their definition in `i128`.

#[path = "../../../../tests/reference/directions.rs"]
mod directions;

use std::{ops::Range, vec};

use directions::{middle_2x, normal};
use embedded_graphics::{
    geometry::{AngleUnit, Point, Size},
    primitives::Rectangle,
};
use proptest::{prelude::*, test_runner::RngSeed};

use super::{Center, Columns, HalfPlane, PlaneSector, runs};

fn any_number() -> impl Strategy<Value = i64> {
    let ends = vec![
        i64::MIN,
        i64::MIN + 1,
        -1,
        0,
        1,
        i64::MAX - 1,
        i64::MAX,
        1 << 60,
        -1 << 60,
    ];
    prop_oneof![
        any::<i64>(),
        -100_000..100_000i64,
        (-1i64 << 50)..(1i64 << 50),
        prop::sample::select(ends)
    ]
}

fn any_coordinate() -> impl Strategy<Value = i32> {
    let ends = vec![i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    prop_oneof![any::<i32>(), -100..100i32, prop::sample::select(ends)]
}

fn any_columns() -> impl Strategy<Value = Columns> {
    (any_coordinate(), any_coordinate()).prop_map(|(start, end)| Columns { start, end })
}

fn range(columns: Columns) -> Range<i64> {
    columns.start.into()..columns.end.into()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40_000, rng_seed: RngSeed::Fixed(0x0123_4567), ..ProptestConfig::default() })]

    #[test]
    fn columns_are_those_of_the_half_plane(
        degrees in prop_oneof![
            4 => (-8i32..=8).prop_map(|quarter| quarter as f32 * 90.0),
            8 => -400.0f32..400.0,
            1 => prop::sample::select(vec![1e20, f32::NEG_INFINITY, f32::NAN]),
        ],
        is_left in any::<bool>(),
        beyond in any_number(),
        corner in (any_coordinate(), any_coordinate()),
        size in (any::<u32>(), prop::sample::select(vec![0, 1, 2, u32::MAX])),
        y in any_coordinate(),
        visible in any_columns(),
        column in any_coordinate(),
    ) {
        let angle = degrees.deg();
        let bounds = Rectangle::new(Point::new(corner.0, corner.1), Size::new(size.0, size.1));
        let half_plane = if is_left { HalfPlane::left_of(angle, beyond) } else { HalfPlane::right_of(angle, beyond) };
        let found = half_plane.columns(Center::of(&bounds), y, visible);
        let (normal_x, normal_y) = normal(angle);
        let side = if is_left { -1 } else { 1 };
        let is_inside = |x: i64| {
            let dx = 2 * i128::from(x) - middle_2x(corner.0, size.0);
            let dy = 2 * i128::from(y) - middle_2x(corner.1, size.1);
            side * (normal_x * dx + normal_y * dy) >= -i128::from(beyond)
        };
        let (found, visible) = (range(found), range(visible));
        for x in [found.start - 1, found.start, found.end - 1, found.end, visible.start, visible.end - 1, column.into()] {
            let expected = visible.contains(&x) && is_inside(x);
            prop_assert_eq!(found.contains(&x), expected, "column {}", x);
        }
    }

    /// Pieces and runs of columns that no half plane gives.
    #[test]
    fn no_columns_panic(
        degrees in (-800.0f32..800.0, -800.0f32..800.0),
        (right, left, visible) in (any_columns(), any_columns(), any_columns()),
        mut borders in prop::collection::vec(any_coordinate(), 0..14),
        column in any_coordinate(),
    ) {
        let sector = PlaneSector::new(degrees.0.deg(), degrees.1.deg());
        let pieces = sector.row_runs([right, left], visible);
        let is_inside = sector.contains(&[right, left], column);
        if right.start <= right.end && left.start <= left.end && visible.contains(column) {
            prop_assert_eq!(pieces.iter().any(|piece| piece.contains(column)), is_inside);
        }
        let mut end = i64::from(visible.start);
        let emitted = runs(visible, &mut borders, |x| Some(x & 1), |columns, _| {
            if columns.is_empty() || i64::from(columns.start) < end || columns.end > visible.end {
                return Err(columns);
            }
            end = columns.end.into();
            Ok(())
        });
        prop_assert_eq!(emitted, Ok(()));
    }
}

#[test]
fn ends_of_the_number_range() {
    let reversed = Columns { start: 9, end: -9 };
    let center = Center::of(&Rectangle::new(Point::zero(), Size::new(5, 5)));
    for angle in [0.0, 33.0, 90.0, 123.0, 180.0, 270.0] {
        for beyond in [i64::MIN, -1, 0, 1, i64::MAX] {
            for half_plane in [
                HalfPlane::left_of(angle.deg(), beyond),
                HalfPlane::right_of(angle.deg(), beyond),
            ] {
                assert!(half_plane.columns(center, 3, reversed).is_empty());
            }
        }
    }
    // Everything is within any distance, and nothing is.
    let visible = Columns { start: -50, end: 50 };
    assert_eq!(
        HalfPlane::right_of(33.0.deg(), i64::MAX).columns(center, 3, visible),
        visible
    );
    assert!(
        HalfPlane::right_of(33.0.deg(), i64::MIN)
            .columns(center, 3, visible)
            .is_empty()
    );
}
