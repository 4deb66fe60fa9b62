//! Curves against exact rational arithmetic, in `i128`: polynomials by forward differences, Béziers, their flattening.

use std::cell::Cell;

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Rgb565},
    prelude::*,
    primitives::{Polyline, Rectangle, StyledDimensions},
};
use fixed::types::U8F8;
use proptest::prelude::*;
use zrow::{
    draw::{DrawOn, FillRule, Path, PathCommand, Polygon, PrimitiveStyle, PrimitiveStyleBuilder},
    geometry::{Sub4, Sub8, SubPixel, SubPoint, Table, TooSmall},
    scan::{Bezier, Curves, PolynomialForwardDifference, StepTooFine},
};
use zrow_methods::registry::{Agrees, CURVES};

use crate::common::{self, cases, config, encloses, in_bands_and_whole, painted};

type Position = (i128, i128);

// ---- polynomials ----

/// `steps^degree` times the polynomial at `step / steps`.
fn polynomial(coefficients: &[i32], step: i128, steps: i128) -> i128 {
    let degree = coefficients.len().saturating_sub(1) as u32;
    let terms = coefficients.iter().zip(0u32..);
    terms
        .map(|(&coefficient, power)| i128::from(coefficient) * step.pow(power) * steps.pow(degree - power))
        .sum()
}

/// `floor(numerator / denominator + 1/2)`.
fn nearest(numerator: i128, denominator: i128) -> i128 {
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
        Err(StepTooFine { log2_steps: 20 })
    );
    assert!(PolynomialForwardDifference::dyadic(&[1, 2, 3, 4], 20).is_ok());
}

// ---- Béziers ----

/// `steps^degree` times the point of the curve at `step / steps`, by de Casteljau's triangle.
fn casteljau(controls: &[(i32, i32)], step: i128, steps: i128) -> Position {
    let mut row: Vec<Position> = controls.iter().map(|&(x, y)| (x.into(), y.into())).collect();
    while row.len() > 1 {
        row = row
            .windows(2)
            .map(|pair| {
                let between = |from: i128, to: i128| from * (steps - step) + to * step;
                (between(pair[0].0, pair[1].0), between(pair[0].1, pair[1].1))
            })
            .collect();
    }
    row[0]
}

/// The nearest point in units of `1 / scale` to that of the curve.
fn rounded_point(controls: &[(i32, i32)], step: i128, steps: i128, scale: i128) -> Position {
    let (x, y) = casteljau(controls, step, steps);
    let denominator = steps.pow(controls.len() as u32 - 1);
    (nearest(scale * x, denominator), nearest(scale * y, denominator))
}

/// Fractional parts of a unit that distances are measured in: rounding a point to them moves it by less than one.
const FINE: i128 = 1 << 10;

/// Whether a point is within `distance` of a line; all in the same unit.
fn is_near_line(point: Position, (from, to): (Position, Position), distance: i128) -> bool {
    let along = (to.0 - from.0, to.1 - from.1);
    let ahead = (point.0 - from.0, point.1 - from.1);
    let length_squared = along.0 * along.0 + along.1 * along.1;
    let dot = along.0 * ahead.0 + along.1 * ahead.1;
    let near = |of: Position| (point.0 - of.0).pow(2) + (point.1 - of.1).pow(2) <= distance * distance;
    if dot <= 0 {
        near(from)
    } else if dot >= length_squared {
        near(to)
    } else {
        let cross = along.0 * ahead.1 - along.1 * ahead.0;
        cross * cross <= distance * distance * length_squared
    }
}

/// Whether a point is within `distance` of lines through these points; begins where the last one was found.
fn is_near(point: Position, lines: &[Position], distance: i128, last_found: &mut usize) -> bool {
    let count = lines.len() - 1;
    for offset in 0..count {
        let index = (*last_found + offset) % count;
        if is_near_line(point, (lines[index], lines[index + 1]), distance) {
            *last_found = index;
            return true;
        }
    }
    false
}

fn units(points: impl Iterator<Item = SubPoint<Sub8>>) -> Vec<(i32, i32)> {
    points.map(|point| (point.x_units(), point.y_units())).collect()
}

fn curve<S: SubPixel, const CONTROLS: usize>(controls: &[(i32, i32)]) -> Bezier<CONTROLS> {
    let controls: [SubPoint<S>; CONTROLS] = core::array::from_fn(|index| {
        let (x, y) = controls[index];
        SubPoint::from_units(x, y).unwrap()
    });
    Bezier::new(controls).unwrap()
}

/// The ends of the adaptive and the uniform lines, after what they promise of each other was checked.
fn flattened<const CONTROLS: usize>(controls: &[(i32, i32)], tolerance: u16) -> [Vec<(i32, i32)>; 2] {
    let curve = curve::<Sub8, CONTROLS>(controls);
    let tolerance = U8F8::from_bits(tolerance);
    let adaptive = units(Curves::adaptive_forward_difference(&curve, tolerance));
    let uniform = units(Curves::uniform_subdivision(&curve, tolerance));
    macro_rules! flatten_by_each {
        ($([$name:ident] [$($flatten:tt)+])+) => {
            [$(units($($flatten)+(&curve, tolerance))),+]
        };
    }
    for (algorithm, lines) in CURVES.iter().zip(zrow_methods::curves!(flatten_by_each)) {
        let has_to_agree = algorithm.agrees == Agrees::Always;
        assert!(!has_to_agree || lines == adaptive, "{}: {controls:?}", algorithm.name);
    }
    assert!(adaptive.len() <= uniform.len() && uniform.len() <= 4096);
    // Every end of an adaptive line is one of a uniform line, in the same order.
    let mut rest = uniform.iter();
    assert!(
        adaptive.iter().all(|end| rest.any(|other| other == end)),
        "{controls:?}"
    );
    [adaptive, uniform]
}

/// Everything that flattening promises; returns the largest distance seen of the curve to the lines, in thousandths of the
/// tolerance.
fn check<const CONTROLS: usize>(controls: &[(i32, i32)], tolerance: u16, samples: i128) -> i128 {
    let [adaptive, uniform] = flattened::<CONTROLS>(controls, tolerance);
    // Uniform: the exact points, rounded.
    let steps = uniform.len() as i128;
    for (end, step) in uniform.iter().zip(1i128..) {
        let (x, y) = rounded_point(controls, step, steps, 1);
        assert_eq!((i128::from(end.0), i128::from(end.1)), (x, y), "{controls:?}");
    }
    let tolerance = i128::from(tolerance.max(2));
    let fine_curve: Vec<Position> = (0..=samples)
        .map(|step| rounded_point(controls, step, samples, FINE))
        .collect();
    // Half of what is between two samples of the curve, at most: max |B''| / (8 samples^2), each coordinate by itself.
    let degree = CONTROLS as i128 - 1;
    let bend = |coordinate: fn(&(i32, i32)) -> i32| {
        let differences = controls.windows(3).map(|three| {
            i128::from(coordinate(&three[0])) - 2 * i128::from(coordinate(&three[1]))
                + i128::from(coordinate(&three[2]))
        });
        differences.map(i128::abs).max().unwrap_or(0) * degree * (degree - 1)
    };
    let between_samples = FINE * (bend(|point| point.0) + bend(|point| point.1)) / (8 * samples * samples) + 1;
    let mut largest = 0;
    for ends in [&adaptive, &uniform] {
        assert_eq!(ends.last(), controls.last(), "the end is exact");
        let lines: Vec<Position> = controls
            .iter()
            .take(1)
            .chain(ends)
            .map(|&(x, y)| (i128::from(x) * FINE, i128::from(y) * FINE))
            .collect();
        // From the curve to the lines.
        let mut found = 0;
        for &point in &fine_curve {
            let within = |distance: i128, found: &mut usize| is_near(point, &lines, distance, found);
            assert!(
                within(tolerance * FINE + 1, &mut found),
                "{controls:?}, {tolerance}: {point:?} is far from the lines"
            );
            while !within(largest * tolerance * FINE / 1000, &mut found) {
                largest += 1;
            }
        }
        // And back, from the middles of the lines.
        let mut found = 0;
        for pair in lines.windows(2) {
            let middle = ((pair[0].0 + pair[1].0) / 2, (pair[0].1 + pair[1].1) / 2);
            assert!(
                is_near(middle, &fine_curve, tolerance * FINE + 2 + between_samples, &mut found),
                "{controls:?}, {tolerance}: {middle:?} is far from the curve"
            );
        }
    }
    // Reversed.
    let reversed: Vec<(i32, i32)> = controls.iter().rev().copied().collect();
    let back = flattened::<CONTROLS>(&reversed, tolerance as u16);
    for (there, back) in [&adaptive, &uniform].into_iter().zip([&back[0], &back[1]]) {
        let mut expected: Vec<(i32, i32)> = back.iter().rev().skip(1).copied().collect();
        expected.extend(controls.last());
        assert_eq!(*there, expected, "{controls:?} reversed");
    }
    largest
}

fn control(least: i32, most: i32) -> impl Strategy<Value = (i32, i32)> {
    (least..=most, least..=most)
}

fn tolerance() -> impl Strategy<Value = u16> {
    prop_oneof![Just(0u16), Just(2), Just(3), 2..20u16, 20..300u16, Just(u16::MAX)]
}

proptest! {
    #![proptest_config(config(cases(15, 150)))]

    #[test]
    fn quadratics_of_a_screen_keep_the_tolerance(controls in prop::collection::vec(control(-2000, 62_000), 3), tolerance in tolerance()) {
        check::<3>(&controls, tolerance, 512);
    }

    #[test]
    fn cubics_of_a_screen_keep_the_tolerance(controls in prop::collection::vec(control(-2000, 62_000), 4), tolerance in tolerance()) {
        check::<4>(&controls, tolerance, 512);
    }

    #[test]
    fn small_cubics_keep_the_tolerance(controls in prop::collection::vec(control(-40, 900), 4), tolerance in tolerance()) {
        check::<4>(&controls, tolerance, 256);
    }

    #[test]
    fn lines_stay_one_line(controls in prop::collection::vec(control(Sub8::MIN_UNITS, Sub8::MAX_UNITS), 2), tolerance in tolerance()) {
        prop_assert_eq!(flattened::<2>(&controls, tolerance), [(); 2].map(|()| vec![controls[1]]));
    }

    #[test]
    fn the_power_basis_is_exact(controls in prop::collection::vec(control(Sub8::MIN_UNITS, Sub8::MAX_UNITS), 4)) {
        fn check_power<const CONTROLS: usize>(controls: &[(i32, i32)]) {
            let [x, y] = curve::<Sub8, CONTROLS>(controls).power_basis();
            for step in 0..=7 {
                let expected = casteljau(&controls[..CONTROLS], step, 7);
                assert_eq!((polynomial(&x, step, 7), polynomial(&y, step, 7)), expected);
            }
        }
        check_power::<2>(&controls);
        check_power::<3>(&controls);
        check_power::<4>(&controls);
    }

    #[test]
    fn sixteenths_give_the_lines_of_256ths(controls in prop::collection::vec(control(Sub4::MIN_UNITS, Sub4::MAX_UNITS), 4), tolerance in tolerance()) {
        let finer: Vec<(i32, i32)> = controls.iter().map(|&(x, y)| (16 * x, 16 * y)).collect();
        let coarse = curve::<Sub4, 4>(&controls);
        prop_assert_eq!(coarse, curve::<Sub8, 4>(&finer));
        prop_assert_eq!(
            units(Curves::adaptive_forward_difference(&coarse, U8F8::from_bits(tolerance))),
            &flattened::<4>(&finer, tolerance)[0][..]
        );
    }
}

proptest! {
    #![proptest_config(config(6))]

    #[test]
    fn cubics_of_the_whole_domain_keep_the_tolerance(controls in prop::collection::vec(control(Sub8::MIN_UNITS, Sub8::MAX_UNITS), 4), tolerance in 2..60u16) {
        check::<4>(&controls, tolerance, 512);
    }
}

#[test]
fn the_bound_is_attained() {
    // A parabola's distance to its line is the bound; what is rounded takes some of it.
    let parabola = [(0, 0), (30_000, 100), (60_000, 0)];
    let largest = (2..60)
        .map(|tolerance| check::<3>(&parabola, tolerance, 512))
        .max()
        .unwrap();
    println!("largest distance of a flat parabola: {largest} thousandths of the tolerance");
    assert!(largest > 900, "{largest}");
}

#[test]
fn degenerate_curves_are_flattened() {
    let s = 25_600;
    let cubics = [
        // All points are one.
        [(77, -5); 4],
        // Two and two, and three and one.
        [(0, 0), (0, 0), (s, s), (s, s)],
        [(0, 0), (0, 0), (0, 0), (s, 1)],
        // A cusp in the middle.
        [(0, 0), (s, s), (0, s), (s, 0)],
        // A loop.
        [(0, 0), (3 * s, s), (-2 * s, s), (s, 0)],
        // On a line, beyond both ends.
        [(0, 0), (3 * s, 0), (-2 * s, 0), (s, 0)],
        [(0, 0), (-s, -2 * s), (2 * s, 4 * s), (s, 2 * s)],
        // Ends that meet.
        [(0, 0), (s, s), (-s, s), (0, 0)],
        // There and back on one line.
        [(0, 0), (s, 0), (s, 0), (0, 0)],
        // Hardly bent.
        [(0, 0), (s, 1), (2 * s, 1), (3 * s, 0)],
    ];
    for controls in cubics {
        for tolerance in [0, 2, 16, 64, 256] {
            check::<4>(&controls, tolerance, 512);
        }
    }
    let quadratics = [
        [(9, 9); 3],
        [(0, 0), (s, 0), (0, 0)],
        [(0, 0), (3 * s, 3 * s), (s, s)],
        [(0, 0), (s, 0), (2 * s, 0)],
        [(0, 0), (0, 0), (s, s)],
    ];
    for controls in quadratics {
        for tolerance in [0, 2, 16, 64, 256] {
            check::<3>(&controls, tolerance, 512);
        }
    }
    assert_eq!(flattened::<4>(&[(77, -5); 4], 2)[0], [(77, -5)]);
}

#[test]
fn control_points_at_the_limits_of_the_domain_are_flattened() {
    let limits = [Sub8::MIN_UNITS, Sub8::MAX_UNITS];
    let corners: Vec<(i32, i32)> = limits.iter().flat_map(|&x| limits.map(|y| (x, y))).collect();
    for numbers in 0..256 {
        let controls: Vec<(i32, i32)> = (0..4).map(|place| corners[numbers >> (2 * place) & 3]).collect();
        let [adaptive, uniform] = flattened::<4>(&controls, 2);
        let [parabola, _] = flattened::<3>(&controls[..3], 2);
        assert_eq!(adaptive.last(), controls.last());
        assert_eq!(parabola.last(), controls.get(2));
        for (end, step) in uniform.iter().zip(1i128..) {
            let exact = rounded_point(&controls, step, uniform.len() as i128, 1);
            assert_eq!((i128::from(end.0), i128::from(end.1)), exact, "{controls:?}");
        }
    }
    check::<4>(&[corners[0], corners[3], corners[0], corners[3]], 2, 512);
    check::<4>(&[corners[0], corners[3], corners[1], corners[2]], 2, 512);
}

#[test]
fn points_outside_the_domain_are_refused() {
    let far = SubPoint::<Sub8> {
        x: fixed::types::I24F8::MIN,
        y: fixed::types::I24F8::MAX,
    };
    assert!(Bezier::new([SubPoint::default(), far, SubPoint::default()]).is_err());
    // All that 12.4 bits hold is in the domain of 24.8.
    let corner = SubPoint::<Sub4> {
        x: fixed::types::I12F4::MIN,
        y: fixed::types::I12F4::MAX,
    };
    assert!(Bezier::new([corner, SubPoint::default(), corner]).is_ok());
}

// ---- paths ----

/// A command in units, to be made at either precision.
#[derive(Debug, Copy, Clone)]
enum Command {
    Move((i32, i32)),
    Line((i32, i32)),
    Quadratic([(i32, i32); 2]),
    Cubic([(i32, i32); 3]),
    Close,
}

/// The ends of the straight lines of a contour, and whether it is closed.
type Contour = (Vec<SubPoint<Sub8>>, bool);

fn command<S: SubPixel>(command: &Command) -> PathCommand<S> {
    let at = |(x, y): (i32, i32)| SubPoint::from_units(x, y).unwrap();
    match *command {
        Command::Move(to) => PathCommand::MoveTo(at(to)),
        Command::Line(to) => PathCommand::LineTo(at(to)),
        Command::Quadratic([control, to]) => PathCommand::QuadraticTo(at(control), at(to)),
        Command::Cubic([one, other, to]) => PathCommand::CubicTo(at(one), at(other), at(to)),
        Command::Close => PathCommand::Close,
    }
}

/// The contours that a path of 1/256 pixel has, by the sibling that halves.
fn contours(commands: &[Command], tolerance: U8F8) -> Vec<Contour> {
    let at = |(x, y): (i32, i32)| SubPoint::<Sub8>::from_units(x, y).unwrap();
    let mut contours = vec![(vec![at((0, 0))], false)];
    for command in commands {
        let (points, closed) = contours.last_mut().unwrap();
        let from = *points.last().unwrap();
        match *command {
            Command::Move(to) => contours.push((vec![at(to)], false)),
            Command::Line(to) => points.push(at(to)),
            Command::Quadratic([control, to]) => {
                let curve = Bezier::new([from, at(control), at(to)]).unwrap();
                points.extend(Curves::de_casteljau(&curve, tolerance));
            }
            Command::Cubic([one, other, to]) => {
                let curve = Bezier::new([from, at(one), at(other), at(to)]).unwrap();
                points.extend(Curves::de_casteljau(&curve, tolerance));
            }
            Command::Close => {
                *closed = true;
                let begins = vec![points[0]];
                contours.push((begins, false));
            }
        }
    }
    contours.retain(|(points, closed)| points.len() > 1 || *closed);
    contours
}

const EDGES: usize = 2000;

fn window() -> Rectangle {
    Rectangle::new(Point::new(-3, 5), Size::new(60, 44))
}

/// The fill is that of the polygon of the same lines, the thin stroke that of their polylines, the wide one that of closed
/// polygons and open polylines; each inside its bounding box.
fn check_path(commands: &[Command], tolerance: u16, window: Rectangle) {
    let tolerance = U8F8::from_bits(tolerance);
    let path: Vec<PathCommand<Sub8>> = commands.iter().map(command).collect();
    let contours = contours(commands, tolerance);
    let points: Vec<&[SubPoint<Sub8>]> = contours.iter().map(|(points, _)| points.as_slice()).collect();
    for rule in [FillRule::EvenOdd, FillRule::NonZero] {
        let path = Path::new(&path, rule).unwrap().with_tolerance(tolerance);
        let prepared = path.prepare::<EDGES, EDGES>().unwrap();
        let polygon = Polygon::new(&points, rule).prepare::<EDGES, EDGES>().unwrap();
        assert_eq!(prepared.edge_count(), polygon.edge_count());
        let fill = PrimitiveStyle::with_fill(Rgb565::WHITE);
        let bounds = prepared.bounding_box();
        let filled = in_bands_and_whole(&prepared.into_styled(fill), window);
        let expected = painted(window, |band| {
            let Ok(()) = polygon.into_styled(fill).draw_on(band);
        });
        assert_eq!(filled, expected, "{rule:?} {commands:?}");
        assert!(
            filled.iter().all(|&pixel| encloses(&bounds, pixel)),
            "{commands:?}, {bounds:?}"
        );
    }
    let path = Path::new(&path, FillRule::NonZero).unwrap().with_tolerance(tolerance);
    for width in [1, 2, 5] {
        let stroke = PrimitiveStyle::with_stroke(Rgb565::WHITE, width);
        let bounds = path.styled_bounding_box(&stroke);
        let stroked = in_bands_and_whole(&path.into_styled(stroke), window);
        let expected = painted(window, |band| {
            for (points, closed) in &contours {
                draw_stroke(points, *closed, stroke, band);
            }
        });
        assert_eq!(stroked, expected, "width {width}, {commands:?}");
        assert!(
            stroked.iter().all(|&pixel| encloses(&bounds, pixel)),
            "{commands:?}, {bounds:?}"
        );
    }
}

fn pixel(point: &SubPoint<Sub8>) -> Point {
    Point::new(
        (point.x_units() + 128).div_euclid(256),
        (point.y_units() + 128).div_euclid(256),
    )
}

/// The stroke of a contour through other entry points: a thin one as a polyline, a closed wide one as a polygon. What is left, an
/// open wide one, is compared where its vertices are pixels: see [`an_open_path_of_pixels_is_a_polyline`].
fn draw_stroke(
    points: &[SubPoint<Sub8>],
    closed: bool,
    stroke: PrimitiveStyle<Rgb565>,
    band: &mut zrow::band::Band<'_, Rgb565>,
) {
    if stroke.stroke_width == 1 {
        let mut pixels: Vec<Point> = points.iter().map(pixel).collect();
        if closed {
            pixels.push(pixels[0]);
        }
        let Ok(()) = Polyline::new(&pixels).into_styled(stroke).draw_on(band);
    } else if closed {
        let contours = [points];
        let polygon = Polygon::new(&contours, FillRule::NonZero)
            .prepare::<EDGES, EDGES>()
            .unwrap();
        let Ok(()) = polygon.into_styled(stroke).draw_on(band);
    } else {
        let commands: Vec<PathCommand<Sub8>> = points
            .iter()
            .enumerate()
            .map(|(index, &point)| match index {
                0 => PathCommand::MoveTo(point),
                _ => PathCommand::LineTo(point),
            })
            .collect();
        let path = Path::new(&commands, FillRule::NonZero).unwrap();
        let Ok(()) = path.into_styled(stroke).draw_on(band);
    }
}

fn commands(least: i32, most: i32) -> impl Strategy<Value = Vec<Command>> {
    let point = move || control(least, most);
    let command = prop_oneof![
        2 => point().prop_map(Command::Move),
        3 => point().prop_map(Command::Line),
        3 => [point(), point()].prop_map(Command::Quadratic),
        3 => [point(), point(), point()].prop_map(Command::Cubic),
        2 => Just(Command::Close),
    ];
    prop::collection::vec(command, 0..12)
}

proptest! {
    #![proptest_config(config(cases(15, 120)))]

    #[test]
    fn paths_are_what_is_made_of_their_lines(commands in commands(-1500, 14_000), tolerance in tolerance()) {
        check_path(&commands, tolerance, window());
    }

    #[test]
    fn an_open_path_of_pixels_is_a_polyline(points in prop::collection::vec((-10..60i32, -10..60i32), 2..8), width in 1..7u32) {
        let pixels: Vec<Point> = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let to = |pixel: &Point| PathCommand::LineTo(SubPoint::<Sub4>::from_pixel(*pixel).unwrap());
        let mut commands: Vec<_> = pixels.iter().map(to).collect();
        commands[0] = PathCommand::MoveTo(SubPoint::from_pixel(pixels[0]).unwrap());
        let path = Path::new(&commands, FillRule::EvenOdd).unwrap();
        let stroke = PrimitiveStyle::with_stroke(Rgb565::WHITE, width);
        let expected = painted(window(), |band| {
            let Ok(()) = Polyline::new(&pixels).into_styled(stroke).draw_on(band);
        });
        prop_assert_eq!(in_bands_and_whole(&path.into_styled(stroke), window()), expected);
    }

    #[test]
    fn both_precisions_fill_alike(commands in commands(-100, 900), tolerance in tolerance()) {
        let coarse: Vec<PathCommand<Sub4>> = commands.iter().map(command).collect();
        let finer = |(x, y)| (16 * x, 16 * y);
        let fine: Vec<PathCommand<Sub8>> = commands
            .iter()
            .map(|coarse| match *coarse {
                Command::Move(to) => Command::Move(finer(to)),
                Command::Line(to) => Command::Line(finer(to)),
                Command::Quadratic(points) => Command::Quadratic(points.map(finer)),
                Command::Cubic(points) => Command::Cubic(points.map(finer)),
                Command::Close => Command::Close,
            })
            .map(|fine| command(&fine))
            .collect();
        let tolerance = U8F8::from_bits(tolerance);
        let style = PrimitiveStyleBuilder::new().fill_color(Rgb565::RED).stroke_color(Rgb565::WHITE).stroke_width(1).build();
        let coarse = Path::new(&coarse, FillRule::EvenOdd).unwrap().with_tolerance(tolerance).prepare::<EDGES, EDGES>().unwrap();
        let fine = Path::new(&fine, FillRule::EvenOdd).unwrap().with_tolerance(tolerance).prepare::<EDGES, EDGES>().unwrap();
        prop_assert_eq!(coarse.bounding_box(), fine.bounding_box());
        let draw = |drawable: &dyn Fn(&mut zrow::band::Band<'_, Rgb565>)| common::picture(window(), drawable);
        prop_assert_eq!(
            draw(&|band| { let Ok(()) = coarse.into_styled(style).draw_on(band); }),
            draw(&|band| { let Ok(()) = fine.into_styled(style).draw_on(band); })
        );
    }

    #[test]
    fn the_thin_stroke_of_a_curve_is_near_it(controls in prop::collection::vec(control(-1500, 14_000), 4), tolerance in 2..400u16) {
        let command = [
            Command::Move(controls[0]),
            Command::Cubic([controls[1], controls[2], controls[3]]),
        ];
        let commands = command.map(|it| self::command::<Sub8>(&it));
        let path = Path::new(&commands, FillRule::EvenOdd).unwrap().with_tolerance(U8F8::from_bits(tolerance));
        let area = Rectangle::new(Point::new(-8, -8), Size::new(72, 72));
        let pixels = painted(area, |band| {
            let Ok(()) = path.into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1)).draw_on(band);
        });
        let curve: Vec<Position> = (0..=512).map(|step| rounded_point(&controls, step, 512, FINE)).collect();
        // The ends of a line move by sqrt(1/2) pixel at most to their pixels, and it by 1/2 pixel to its own.
        let most = (i128::from(tolerance) + 182 + 128 + 1) * FINE;
        let mut found = 0;
        for pixel in pixels {
            let centre = (i128::from(pixel.x) * 256 * FINE, i128::from(pixel.y) * 256 * FINE);
            assert!(is_near(centre, &curve, most, &mut found), "{controls:?}, {pixel:?}");
        }
    }
}

proptest! {
    #![proptest_config(config(12))]

    #[test]
    fn paths_of_the_whole_domain_are_what_is_made_of_their_lines(commands in commands(Sub8::MIN_UNITS, Sub8::MAX_UNITS), tolerance in 16..300u16) {
        check_path(&commands, tolerance, window());
    }
}

/// A circle of four cubics, from its rightmost point on, in 1/256 pixel.
fn circle(center: (i32, i32), radius: i32) -> [Command; 6] {
    // 4/3 (sqrt(2) - 1) of the radius.
    let handle = (f64::from(radius) * 0.552_284_749_830_793_4).round() as i32;
    let at = |x: i32, y: i32| (center.0 + x, center.1 + y);
    let (r, h) = (radius, handle);
    [
        Command::Move(at(r, 0)),
        Command::Cubic([at(r, h), at(h, r), at(0, r)]),
        Command::Cubic([at(-h, r), at(-r, h), at(-r, 0)]),
        Command::Cubic([at(-r, -h), at(-h, -r), at(0, -r)]),
        Command::Cubic([at(h, -r), at(r, -h), at(r, 0)]),
        Command::Close,
    ]
}

#[test]
fn a_circle_of_four_cubics_is_a_circle_within_its_error() {
    let mut off_by = 0.0f64;
    for radius in [256, 1000, 5000, 12_800, 25_600] {
        for tolerance in [2u16, 8, 32] {
            let outline = contours(&circle((0, 0), radius), U8F8::from_bits(tolerance));
            // The cubics are up to 2.73/10,000 of the radius outside the circle; their handles are rounded by half a unit
            // each way, of which 3/4 show at most. Lines are inside the cubics by the tolerance.
            let outside = f64::from(radius) * 2.73e-4 + 0.75 * 0.708 + f64::from(tolerance);
            let inside = 0.75 * 0.708 + f64::from(tolerance);
            for pair in outline[0].0.windows(2) {
                for part in 0..=8 {
                    let between = |from: i32, to: i32| f64::from(from) + f64::from(to - from) * f64::from(part) / 8.0;
                    let x = between(pair[0].x_units(), pair[1].x_units());
                    let y = between(pair[0].y_units(), pair[1].y_units());
                    let error = x.hypot(y) - f64::from(radius);
                    assert!(-inside <= error && error <= outside, "{radius} {tolerance}: {error}");
                    off_by = off_by.max(error.abs() / outside);
                }
            }
        }
    }
    println!("circles of four cubics: up to {off_by:.2} of the allowed error");
    // Pixels: whoever is clearly inside or outside the circle is inside or outside the path.
    let (center, radius) = ((30 * 256 + 77, 28 * 256 - 31), 22 * 256);
    let commands = circle(center, radius).map(|it| command::<Sub8>(&it));
    let path = Path::new(&commands, FillRule::NonZero)
        .unwrap()
        .prepare::<200, 4>()
        .unwrap();
    let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    let filled = painted(area, |band| {
        let Ok(()) = path.into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE)).draw_on(band);
    });
    for pixel in area.points() {
        let distance = f64::from(pixel.x * 256 - center.0).hypot(f64::from(pixel.y * 256 - center.1));
        if (distance - f64::from(radius)).abs() > 34.1 {
            assert_eq!(filled.contains(&pixel), distance < f64::from(radius), "{pixel:?}");
        }
    }
}

#[test]
fn a_path_that_does_not_fit_says_what_is_needed() {
    let commands = circle((9000, 9000), 8000).map(|it| command::<Sub8>(&it));
    let path = Path::new(&commands, FillRule::EvenOdd).unwrap();
    let needed = path.prepare::<3, 3>().unwrap_err();
    assert_eq!(needed.table, Table::Edges);
    let Ok(enough) = path.prepare::<100, 2>() else {
        panic!("{needed}")
    };
    assert_eq!(enough.edge_count(), needed.needed);
    assert_eq!(
        path.prepare::<100, 1>().unwrap_err(),
        TooSmall {
            table: Table::ActiveEdges,
            needed: 2
        }
    );
}

#[test]
fn paths_of_nothing_draw_nothing() {
    let at = |x, y| SubPoint::<Sub4>::from_units(x, y).unwrap();
    let paths: [&[PathCommand<Sub4>]; 6] = [
        &[],
        &[PathCommand::MoveTo(at(80, 80))],
        &[PathCommand::MoveTo(at(80, 80)), PathCommand::MoveTo(at(160, 80))],
        &[PathCommand::LineTo(at(0, 0))],
        &[PathCommand::MoveTo(at(80, 80)), PathCommand::LineTo(at(160, 160))],
        &[
            PathCommand::MoveTo(at(80, 80)),
            PathCommand::CubicTo(at(80, 80), at(80, 80), at(80, 80)),
        ],
    ];
    for commands in paths {
        let path = Path::new(commands, FillRule::NonZero)
            .unwrap()
            .prepare::<8, 8>()
            .unwrap();
        let mut display = MockDisplay::new();
        path.into_styled(PrimitiveStyle::with_fill(BinaryColor::On))
            .draw(&mut display)
            .unwrap();
        display.assert_eq(&MockDisplay::new());
    }
    // A stroke has a dot where a line has no length, but none where there is no line.
    let strokes = paths.map(|commands| {
        painted(window(), |band| {
            let path = Path::new(commands, FillRule::NonZero).unwrap();
            let Ok(()) = path
                .into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1))
                .draw_on(band);
        })
    });
    assert_eq!(strokes[..4], [const { Vec::new() }; 4]);
    assert_eq!(strokes[4].len(), 6);
    assert_eq!(strokes[5], [Point::new(5, 5)]);
}

#[test]
fn both_doors_draw_the_same() {
    let commands = circle((8000, 8000), 6000).map(|it| command::<Sub8>(&it));
    let style = PrimitiveStyleBuilder::new()
        .fill_color(Rgb565::RED)
        .stroke_color(Rgb565::WHITE)
        .stroke_width(3)
        .build();
    let path = Path::new(&commands, FillRule::EvenOdd)
        .unwrap()
        .prepare::<100, 2>()
        .unwrap();
    let styled = path.into_styled(style);
    let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    let fast = common::picture(area, |band| {
        let Ok(()) = styled.draw_on(band);
    });
    let general = common::picture(area, |band| {
        let Ok(()) = styled.draw(band);
    });
    assert_eq!(fast, general);
    assert!(fast.contains(&Rgb565::RED) && fast.contains(&Rgb565::WHITE));
}

#[test]
fn paths_outside_the_domain_are_refused() {
    let far = SubPoint::<Sub8> {
        x: fixed::types::I24F8::MIN,
        y: fixed::types::I24F8::MAX,
    };
    let near = SubPoint::default();
    for command in [
        PathCommand::MoveTo(far),
        PathCommand::LineTo(far),
        PathCommand::QuadraticTo(far, near),
        PathCommand::CubicTo(near, far, near),
    ] {
        assert!(Path::new(&[PathCommand::MoveTo(near), command], FillRule::EvenOdd).is_err());
    }
}
