//! Rotations stay rotations, however many are composed: lengths and angles in exact integers.

use fixed::types::U0F16;
use proptest::prelude::*;
use zrow::scene::Rotation;

use crate::common::{cases, config, is_quick};

/// 1 in 4.60, the format of a product of two numbers in 2.30.
const ONE: i128 = 1 << 60;

/// What is guaranteed of the square of a row's or column's length, and of the cosine between two: 2^-22, in 4.60.
const BOUND: i128 = 1 << (60 - 22);

/// Any rotation: turns about the three axes, one after the other.
pub fn rotation() -> impl Strategy<Value = Rotation> {
    any::<[u16; 3]>().prop_map(|angles| {
        let [a, b, c] = angles.map(U0F16::from_bits);
        Rotation::about_x(a)
            .then(&Rotation::about_y(b))
            .then(&Rotation::about_z(c))
    })
}

/// How far the rows and the columns are from being orthonormal: the largest of all their products, less what it should be,
/// in 4.60, exactly.
pub fn deviation(rotation: &Rotation) -> i128 {
    let rows = rotation
        .matrix()
        .map(|row| row.map(|element| i128::from(element.to_bits())));
    let columns = [0, 1, 2].map(|column| rows.map(|row| row[column]));
    let product = |one: &[i128; 3], other: &[i128; 3]| (0..3).map(|at| one[at] * other[at]).sum::<i128>();
    let mut largest = 0;
    for vectors in [rows, columns] {
        for (first, one) in vectors.iter().enumerate() {
            for (second, other) in vectors.iter().enumerate() {
                let expected = if first == second { ONE } else { 0 };
                largest = largest.max((product(one, other) - expected).abs());
            }
        }
    }
    largest
}

/// Whether it is a rotation and no reflection.
pub fn is_right_handed(rotation: &Rotation) -> bool {
    let [[a, b, c], [d, e, f], [g, h, i]] = rotation
        .matrix()
        .map(|row| row.map(|element| i128::from(element.to_bits())));
    a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g) > 0
}

fn check(rotation: &Rotation, which: &dyn core::fmt::Display) {
    let deviation = deviation(rotation);
    assert!(
        deviation <= BOUND,
        "{which}: {} of 2^-30 from a rotation",
        deviation >> 30
    );
    assert!(is_right_handed(rotation), "{which}");
}

fn about(axis: usize, angle: u16) -> Rotation {
    let angle = U0F16::from_bits(angle);
    match axis {
        0 => Rotation::about_x(angle),
        1 => Rotation::about_y(angle),
        _ => Rotation::about_z(angle),
    }
}

/// The error of one angle, of which the documented bound is made.
#[test]
fn one_angle_is_within_sixteen_units_of_a_rotation() {
    for angle in 0..=u16::MAX {
        assert!(deviation(&about(1, angle)) <= 16 << 30, "{angle}");
    }
}

#[test]
fn squares_of_squares_stay_rotations() {
    for axis in 0..3 {
        for angle in [1, 3, 1000, 8_191, 8_192, 21_845, 32_767, 65_535] {
            let mut rotation = about(axis, angle).then(&about((axis + 1) % 3, angle / 2));
            for squaring in 1..=200 {
                rotation = rotation.then(&rotation);
                check(
                    &rotation,
                    &format_args!("axis {axis}, {angle}, squared {squaring} times"),
                );
            }
        }
    }
}

#[test]
fn many_small_steps_stretch_nothing() {
    let step = about(0, 1).then(&about(1, 1)).then(&about(2, 1));
    let mut rotation = Rotation::IDENTITY;
    let mut largest = 0;
    let steps = if is_quick() { 500_000 } else { 5_000_000 };
    for _ in 0..steps {
        rotation = rotation.then(&step);
        // All of them, without what is asked of each in `check`.
        let [[a, b, c], ..] = rotation
            .matrix()
            .map(|row| row.map(|element| i64::from(element.to_bits())));
        largest = largest.max((a * a + b * b + c * c - (1 << 60)).abs());
    }
    assert!(i128::from(largest) <= BOUND, "{} of 2^-30", largest >> 30);
    check(&rotation, &format_args!("{steps} steps"));
}

/// One more about an axis, undone, squared, or composed with an earlier one.
#[derive(Debug, Clone)]
enum Step {
    Turn(usize, u16),
    Undo,
    Square,
    Earlier(prop::sample::Index),
}

fn any_step() -> impl Strategy<Value = Step> {
    prop_oneof![
        (0usize..3, any::<u16>()).prop_map(|(axis, angle)| Step::Turn(axis, angle)),
        Just(Step::Undo),
        Just(Step::Square),
        any::<prop::sample::Index>().prop_map(Step::Earlier),
    ]
}

proptest! {
    #![proptest_config(config(cases(300, 300)))]

    /// Whatever is composed with whatever in any order, each of them is a rotation.
    #[test]
    fn any_products_are_rotations(steps in prop::collection::vec(any_step(), 1..200)) {
        let mut made = vec![Rotation::IDENTITY];
        for (number, step) in steps.iter().enumerate() {
            let last = *made.last().unwrap();
            let next = match step {
                Step::Turn(axis, angle) => last.then(&about(*axis, *angle)),
                Step::Undo => last.inverse(),
                Step::Square => last.then(&last),
                Step::Earlier(index) => last.then(index.get(&made)),
            };
            check(&next, &format_args!("step {number}, {step:?}"));
            made.push(next);
        }
    }

    /// Up to twelve angles give the product of their matrices, rounded, and nothing is corrected.
    #[test]
    fn few_are_as_their_product(angles in prop::collection::vec((0usize..3, any::<u16>()), 2..13)) {
        let turns: Vec<Rotation> = angles.iter().map(|&(axis, angle)| about(axis, angle)).collect();
        let composed = turns.iter().skip(1).fold(turns[0], |composed, turn| composed.then(turn));
        let bits = |rotation: &Rotation| rotation.matrix().map(|row| row.map(|element| i128::from(element.to_bits())));
        let expected = turns.iter().skip(1).fold(bits(&turns[0]), |product, turn| {
            let turn = bits(turn);
            [0, 1, 2].map(|row| {
                [0, 1, 2].map(|column| {
                    let sum = (0..3).map(|at| turn[row][at] * product[at][column]).sum::<i128>();
                    (sum + (1 << 29)) >> 30
                })
            })
        });
        prop_assert_eq!(bits(&composed), expected);
    }
}
