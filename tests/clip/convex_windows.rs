//! Convex windows with corners anywhere, and points for the tests of clipping against them.

use proptest::prelude::*;
use zrow::geometry::{ConvexWindow, InputError, Sub4, SubPixel, SubPoint};

use crate::{
    any_units::{AnyUnits, sub_point},
    common::{cases, config},
    reference::convex_parts::Position,
};

pub fn sub_points<S: AnyUnits>(positions: &[Position]) -> Vec<SubPoint<S>> {
    positions.iter().map(|&position| sub_point(position)).collect()
}

pub fn position<S: SubPixel>(point: SubPoint<S>) -> Position {
    (point.x_units(), point.y_units())
}

/// The corners of the convex hull, clockwise on the screen, without straight ones.
pub fn hull(points: &[Position]) -> Vec<Position> {
    let mut points = points.to_vec();
    points.sort_unstable();
    points.dedup();
    let turn = |a: Position, b: Position, c: Position| {
        let wide = i64::from;
        (wide(b.0) - wide(a.0)) * (wide(c.1) - wide(a.1)) - (wide(b.1) - wide(a.1)) * (wide(c.0) - wide(a.0))
    };
    let half = |points: &mut dyn Iterator<Item = Position>| {
        let mut chain: Vec<Position> = Vec::new();
        for point in points {
            while chain.len() >= 2 && turn(chain[chain.len() - 2], chain[chain.len() - 1], point) <= 0 {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut corners = half(&mut points.iter().copied());
    corners.extend(half(&mut points.iter().rev().copied()));
    corners
}

fn coordinate<S: AnyUnits>() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => -60..260i32,
        3 => S::MIN_UNITS..=S::MAX_UNITS,
        1 => S::LOWEST..=S::HIGHEST,
        1 => prop::sample::select(vec![S::LOWEST, S::HIGHEST, S::MIN_UNITS, S::MAX_UNITS, 0, -1]),
    ]
}

pub fn any_position<S: AnyUnits>() -> impl Strategy<Value = Position> {
    (coordinate::<S>(), coordinate::<S>())
}

/// A convex window with corners in a square; either orientation.
pub fn window_within(low: i32, high: i32) -> impl Strategy<Value = Vec<Position>> {
    (prop::collection::vec((low..=high, low..=high), 3..12), any::<bool>())
        .prop_map(|(points, is_reversed)| {
            let mut corners = hull(&points);
            if is_reversed {
                corners.reverse();
            }
            corners
        })
        .prop_filter("no area", |corners| corners.len() >= 3)
}

pub fn any_window<S: AnyUnits>() -> impl Strategy<Value = Vec<Position>> {
    prop_oneof![
        3 => window_within(-20, 220),
        1 => window_within(0, 6),
        1 => window_within(S::MIN_UNITS, S::MAX_UNITS),
    ]
}

proptest! {
    #![proptest_config(config(cases(4_000, 4_000)))]

    #[test]
    fn a_hull_is_a_window_and_a_dented_one_is_not(window in window_within(-300, 300), corner in 0..12usize) {
        let corner = corner % window.len();
        let mut twice = window.clone();
        twice.extend(&window);
        prop_assert_eq!(ConvexWindow::new(&sub_points::<Sub4>(&twice)).err(), Some(InputError::CrossingSides));
        let mut repeated = window.clone();
        repeated.insert(corner, window[corner]);
        let error = ConvexWindow::new(&sub_points::<Sub4>(&repeated)).err();
        prop_assert_eq!(error, Some(InputError::StraightCorner { corner }));
    }
}
