//! Polynomials by forward differences, against exact rational arithmetic in `i128`.

use std::cell::Cell;

use proptest::prelude::*;
use zrow::{geometry::InputError, scan::PolynomialForwardDifference};

use crate::common::{cases, config};

/// `steps^degree` times the polynomial at `step / steps`.
pub fn polynomial(coefficients: &[i32], step: i128, steps: i128) -> i128 {
    let degree = coefficients.len().saturating_sub(1) as u32;
    let terms = coefficients.iter().zip(0u32..);
    terms
        .map(|(&coefficient, power)| i128::from(coefficient) * step.pow(power) * steps.pow(degree - power))
        .sum()
}

/// `floor(numerator / denominator + 1/2)`.
pub fn nearest(numerator: i128, denominator: i128) -> i128 {
    (2 * numerator + denominator).div_euclid(2 * denominator)
}

fn binomial(n: i128, k: u32) -> i128 {
    (0..i128::from(k)).fold(1, |product, index| product * (n - index) / (index + 1))
}

/// Every value of an exact walk, and of some more steps behind its end.
fn check_dyadic<const TERMS: usize>(coefficients: &[i32], log2_steps: u32) {
    let coefficients: [i32; TERMS] = core::array::from_fn(|index| coefficients[index]);
    let mut walk = PolynomialForwardDifference::dyadic(&coefficients, log2_steps).unwrap();
    let steps = 1i128 << log2_steps;
    let degree = TERMS as u32 - 1;
    // What the other bits of an `i64` hold.
    let most = 1i128 << (63 - degree * log2_steps);
    for step in 0..=steps + 3 {
        let exact = nearest(polynomial(&coefficients, step, steps), steps.pow(degree));
        if (-most..most - 1).contains(&exact) {
            assert_eq!(
                i128::from(walk.value()),
                exact,
                "{coefficients:?}, step {step} of {steps}"
            );
        }
        walk.advance();
    }
}

/// How much of the bound the drift takes at most, in thousandths. The bound is in units of `1 / 2^guard_bits`.
fn check_rounded<const TERMS: usize>(coefficients: &[i32], steps: u32, guard_bits: u32) -> i128 {
    let coefficients: [i32; TERMS] = core::array::from_fn(|index| coefficients[index]);
    let mut walk = PolynomialForwardDifference::rounded(&coefficients, steps, guard_bits);
    let degree = TERMS as u32 - 1;
    let denominator = i128::from(steps).pow(degree);
    let mut most = 0;
    for step in 0..=i128::from(steps) {
        let exact = polynomial(&coefficients, step, steps.into());
        let error = (i128::from(walk.value()) * denominator - exact).abs();
        // Half a unit is the rounding of what is read.
        let drift = (2 * error - denominator).max(0) << guard_bits;
        let ways: i128 = (1..=degree).map(|order| binomial(step, order)).sum();
        // drift / (2 denominator) <= 51/100 ways
        let bound = 102 * ways * denominator;
        assert!(100 * drift <= bound, "{coefficients:?}, step {step} of {steps}");
        if bound > 0 {
            most = most.max(100_000 * drift / bound);
        }
        walk.advance();
    }
    most
}

fn coefficients(most: i32) -> impl Strategy<Value = Vec<i32>> {
    prop::collection::vec(-most..=most, 7)
}

proptest! {
    #![proptest_config(config(cases(30, 300)))]

    #[test]
    fn steps_of_a_power_of_two_are_exact(coefficients in coefficients(i32::MAX), log2_steps in 0..=10u32) {
        check_dyadic::<1>(&coefficients, log2_steps);
        check_dyadic::<2>(&coefficients, log2_steps);
        check_dyadic::<3>(&coefficients, log2_steps);
        check_dyadic::<4>(&coefficients, log2_steps);
        check_dyadic::<5>(&coefficients, log2_steps);
        check_dyadic::<6>(&coefficients, log2_steps);
        check_dyadic::<7>(&coefficients, log2_steps);
        // Small enough that the steepest fit as well.
        let small: Vec<i32> = coefficients.iter().map(|coefficient| coefficient >> 20).collect();
        check_dyadic::<6>(&small, log2_steps.min(9));
        check_dyadic::<7>(&small, log2_steps.min(8));
    }
}

/// What a random test keeps of all its cases.
fn largest(cases: u32, run: impl Fn(&[i32], u32) -> i128) -> i128 {
    let largest = Cell::new(0);
    let mut runner = prop::test_runner::TestRunner::new(config(cases));
    runner
        .run(&(coefficients(5000), 1..400u32), |(coefficients, steps)| {
            largest.set(largest.get().max(run(&coefficients, steps)));
            Ok(())
        })
        .unwrap();
    largest.get()
}

#[test]
fn the_drift_of_other_steps_keeps_its_bound_and_comes_near_it() {
    // Few guard bits, so that the drift shows in whole units.
    let thousandths = [
        largest(300, check_rounded_with::<2, 1>),
        largest(300, check_rounded_with::<3, 4>),
        largest(300, check_rounded_with::<4, 8>),
        largest(300, check_rounded_with::<5, 16>),
        largest(300, check_rounded_with::<6, 20>),
        largest(300, check_rounded_with::<7, 24>),
    ];
    println!("largest drift of degrees 1 to 6, in thousandths of the bound: {thousandths:?}");
    assert!(
        thousandths.iter().all(|&part| part > 900),
        "the bound is not tight: {thousandths:?}"
    );
    // Degree 0 has no drift at all.
    assert_eq!(largest(20, check_rounded_with::<1, 0>), 0);
}

fn check_rounded_with<const TERMS: usize, const GUARD_BITS: u32>(coefficients: &[i32], steps: u32) -> i128 {
    check_rounded::<TERMS>(coefficients, steps, GUARD_BITS)
}

#[test]
fn with_many_guard_bits_other_steps_are_as_good_as_exact() {
    // A cubic over the columns of a display: less than 1/1000 unit of drift.
    let mut walk = PolynomialForwardDifference::rounded(&[-4000, 90_000, -250_000, 170_000], 319, 40);
    for step in 0..=319 {
        let exact = polynomial(&[-4000, 90_000, -250_000, 170_000], step, 319);
        let error = (1000 * (i128::from(walk.value()) * 319i128.pow(3) - exact)).abs();
        assert!(error <= 501 * 319i128.pow(3));
        walk.advance();
    }
}

/// The differences of the highest degree with a bound are up to 2^17 times as large as the coefficients.
#[test]
fn the_largest_differences_of_degree_8_are_exact_at_whole_steps() {
    for coefficients in [[i32::MAX; 9], [i32::MIN; 9]] {
        for guard_bits in [0, 1, 4, 7] {
            let mut walk = PolynomialForwardDifference::rounded(&coefficients, 1, guard_bits);
            for step in 0..=8 {
                let exact = polynomial(&coefficients, step, 1);
                assert_eq!(i128::from(walk.value()), exact, "step {step}, {guard_bits} guard bits");
                walk.advance();
            }
        }
    }
}

#[test]
fn extreme_polynomials_do_not_panic() {
    for coefficient in [i32::MIN, i32::MAX] {
        for log2_steps in [0, 1, 8, 62, 63, u32::MAX] {
            for steps in [0, 1, 3, u32::MAX] {
                let coefficients = [coefficient; 7];
                let mut walk = PolynomialForwardDifference::rounded(&coefficients, steps, log2_steps);
                walk.advance();
                walk.value();
                if let Ok(mut walk) = PolynomialForwardDifference::dyadic(&coefficients, log2_steps) {
                    walk.advance();
                    walk.value();
                }
            }
        }
    }
    let nothing = PolynomialForwardDifference::dyadic(&[], 8).unwrap();
    assert_eq!(nothing.value(), 0);
    let constant = PolynomialForwardDifference::dyadic(&[i32::MIN], u32::MAX).unwrap();
    assert_eq!(constant.value(), i64::from(i32::MIN));
    assert_eq!(
        PolynomialForwardDifference::dyadic(&[1, 2, 3, 4], 21),
        Err(InputError::StepTooFine { log2_steps: 20 })
    );
    assert!(PolynomialForwardDifference::dyadic(&[1, 2, 3, 4], 20).is_ok());
}
