//! Bézier curves and their flattening, against exact rational arithmetic in `i128`.

use fixed::types::U8F8;
use proptest::prelude::*;
use zrow::{
    geometry::{Sub4, Sub8, SubPixel, SubPoint},
    scan::Bezier,
};
use zrow_methods::registry::{Agrees, CURVES};

use crate::common::{by_depth, cases, config};
use crate::polynomials::{nearest, polynomial};

pub type Position = (i128, i128);

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
pub fn rounded_point(controls: &[(i32, i32)], step: i128, steps: i128, scale: i128) -> Position {
    let (x, y) = casteljau(controls, step, steps);
    let denominator = steps.pow(controls.len() as u32 - 1);
    (nearest(scale * x, denominator), nearest(scale * y, denominator))
}

/// Fractional parts of a unit that distances are measured in: rounding a point to them moves it by less than one.
pub const FINE: i128 = 1 << 10;

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
pub fn is_near(point: Position, lines: &[Position], distance: i128, last_found: &mut usize) -> bool {
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
    let adaptive = units(Bezier::adaptive_forward_difference(&curve, tolerance));
    let uniform = units(Bezier::uniform_subdivision(&curve, tolerance));
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

pub fn control(least: i32, most: i32) -> impl Strategy<Value = (i32, i32)> {
    (least..=most, least..=most)
}

pub fn tolerance() -> impl Strategy<Value = u16> {
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
            units(Bezier::adaptive_forward_difference(&coarse, U8F8::from_bits(tolerance))),
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
    for numbers in (0..256).step_by(by_depth(5, 1, 1)) {
        let controls: Vec<(i32, i32)> = (0..4).map(|position| corners[numbers >> (2 * position) & 3]).collect();
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
