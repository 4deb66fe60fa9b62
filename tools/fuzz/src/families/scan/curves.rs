//! Curves as lines, and polynomials at equal steps.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use fixed::types::U8F8;
use zrow::{
    geometry::{InputError, Sub8, SubPoint},
    scan::{Bezier, PolynomialForwardDifference},
};
use zrow_methods::registry::{Agrees, CURVES};

use crate::{
    target::{Case, Verdict},
    values::{Count, Int, Stage, SubSpot, Tolerance},
};

/// A curve of two, three or four control points.
#[derive(Debug, Arbitrary)]
pub struct FlattenCase {
    stage: Stage,
    controls: [SubSpot; 4],
    degree: u8,
    by_hand: bool,
    tolerance: Tolerance,
}

/// Lines that any curve of the domain becomes at most.
const MOST_LINES: usize = 4_096;

/// Columns and rows, in units.
type Place = [f64; 2];

fn place(point: &SubPoint<Sub8>) -> Place {
    [f64::from(point.x_units()), f64::from(point.y_units())]
}

/// The point of a curve by de Casteljau's construction.
fn on_curve(controls: &[SubPoint<Sub8>], at: f64) -> Place {
    let mut places: Vec<Place> = controls.iter().map(place).collect();
    while places.len() > 1 {
        let between = |pair: &[Place]| [0, 1].map(|axis| pair[0][axis] + (pair[1][axis] - pair[0][axis]) * at);
        places = places.windows(2).map(between).collect();
    }
    places[0]
}

fn distance_to([px, py]: Place, [ax, ay]: Place, [bx, by]: Place) -> f64 {
    let (dx, dy) = (bx - ax, by - ay);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 {
        (((px - ax) * dx + (py - ay) * dy) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (px - ax - along * dx).hypot(py - ay - along * dy)
}

impl FlattenCase {
    fn check_with<const CONTROLS: usize>(&self) -> Verdict {
        let spots = self.controls.iter().take(CONTROLS);
        let points: Vec<SubPoint<Sub8>> = spots
            .map(|spot| {
                if self.by_hand {
                    spot.by_hand(&self.stage)
                } else {
                    spot.inside(&self.stage)
                }
            })
            .collect();
        let controls: [SubPoint<Sub8>; CONTROLS] = points.as_slice().try_into().context("as many controls")?;
        let Ok(curve) = Bezier::new(controls) else {
            ensure!(self.by_hand, "points of the domain are outside of it");
            return Ok(());
        };
        let tolerance = self.tolerance.0;
        let adaptive: Vec<_> = Bezier::adaptive_forward_difference(&curve, tolerance)
            .take(MOST_LINES + 1)
            .collect();
        let uniform = Bezier::uniform_subdivision(&curve, tolerance);
        let known = uniform.len();
        let uniform: Vec<_> = uniform.take(MOST_LINES + 1).collect();
        macro_rules! flatten_by_each {
            ($([$name:ident] [$($flatten:tt)+])+) => {
                [$($($flatten)+(&curve, tolerance).take(MOST_LINES + 1).collect::<Vec<_>>()),+]
            };
        }
        for (algorithm, lines) in CURVES.iter().zip(zrow_methods::curves!(flatten_by_each)) {
            ensure!(
                algorithm.agrees != Agrees::Always || lines == adaptive,
                "{}: {} lines, {} adaptive ones",
                algorithm.name,
                lines.len(),
                adaptive.len()
            );
        }
        ensure!(uniform.len() == known, "{} lines of {known}", uniform.len());
        for (name, lines) in [("adaptive", &adaptive), ("uniform", &uniform)] {
            ensure!((1..=MOST_LINES).contains(&lines.len()), "{name}: {} lines", lines.len());
            ensure!(lines.last() == controls.last(), "{name}: the last line ends elsewhere");
        }
        let mut rest = uniform.iter();
        ensure!(
            adaptive.iter().all(|end| rest.any(|other| other == end)),
            "an end of the adaptive lines is none of the uniform ones"
        );
        let mut turned = controls;
        turned.reverse();
        let turned = Bezier::new(turned).context("the reversed curve")?;
        let mut back: Vec<_> = Bezier::adaptive_forward_difference(&turned, tolerance)
            .take(MOST_LINES + 1)
            .collect();
        back.reverse();
        let ends = controls.first().into_iter().chain(&adaptive);
        let back_ends = back.iter().chain(controls.last());
        ensure!(ends.eq(back_ends), "the reversed curve has other lines");
        if adaptive.len() <= 64 {
            let allowed = f64::from(tolerance.max(U8F8::from_bits(2)).to_bits()) + 1e-6;
            let corners: Vec<Place> = controls.first().into_iter().chain(&adaptive).map(place).collect();
            for step in 0..=32 {
                let point = on_curve(&controls, f64::from(step) / 32.0);
                let nearest = corners
                    .windows(2)
                    .map(|line| distance_to(point, line[0], line[1]))
                    .fold(f64::INFINITY, f64::min);
                ensure!(
                    nearest <= allowed,
                    "{point:?} is {nearest} units from the lines, {allowed} are allowed"
                );
            }
        }
        Ok(())
    }
}

impl Case for FlattenCase {
    fn check(&self) -> Verdict {
        match self.degree % 3 {
            0 => self.check_with::<4>(),
            1 => self.check_with::<3>(),
            _ => self.check_with::<2>(),
        }
    }
}

/// A polynomial of up to degree four.
#[derive(Debug, Arbitrary)]
pub struct PolynomialCase {
    coefficients: [Int; 5],
    log2_steps: Count,
    few_steps: bool,
    steps: Count,
    guard_bits: Count,
}

/// `numerator / 2^bits`, rounded to the nearest, ties up.
fn rounded(numerator: i128, bits: u32) -> i128 {
    (2 * numerator + (1 << bits)) >> (bits + 1)
}

impl PolynomialCase {
    fn check_with<const TERMS: usize>(&self) -> Verdict {
        let coefficients: [i32; TERMS] = std::array::from_fn(|index| self.coefficients[index].0);
        let degree = TERMS as u32 - 1;
        let log2_steps = if self.few_steps {
            self.log2_steps.0 % 18
        } else {
            self.log2_steps.0
        };
        let guard_bits = u64::from(degree) * u64::from(log2_steps);
        match PolynomialForwardDifference::dyadic(&coefficients, log2_steps) {
            Err(InputError::StepTooFine { log2_steps: most }) => {
                ensure!(
                    guard_bits > 62 && degree > 0 && most == 62 / degree,
                    "at most {most} of {log2_steps}"
                );
            }
            Err(error) => anyhow::bail!("{error}, which is no error of a step"),
            Ok(mut walk) => {
                ensure!(guard_bits <= 62, "{guard_bits} guard bits");
                for step in 0..24i128 {
                    let terms = coefficients.iter().zip(0..);
                    // With 2^guard_bits for one.
                    let exact: i128 = terms
                        .map(|(coefficient, power)| {
                            let shift = log2_steps * (degree - power);
                            (i128::from(*coefficient) * step.pow(power)) << shift
                        })
                        .sum();
                    let expected = rounded(exact, guard_bits as u32);
                    // What is added for rounding has to fit as well.
                    let fits = exact.unsigned_abs() < (1 << 62);
                    ensure!(
                        !fits || i128::from(walk.value()) == expected,
                        "{} at step {step}, exactly {expected}",
                        walk.value()
                    );
                    walk.advance();
                }
            }
        }
        let steps = if self.few_steps {
            self.steps.0 % 500
        } else {
            self.steps.0
        };
        let guard_bits = if self.few_steps {
            8 + self.guard_bits.0 % 16
        } else {
            self.guard_bits.0
        };
        let mut walk = PolynomialForwardDifference::rounded(&coefficients, steps, guard_bits);
        for step in 0..24i128 {
            if self.few_steps {
                let steps = f64::from(steps.max(1));
                let at = step as f64 / steps;
                let exact = coefficients
                    .iter()
                    .rev()
                    .fold(0.0, |sum, coefficient| sum * at + f64::from(*coefficient));
                // The drift that is promised, and what f64 rounds here.
                let choices = (1..=i128::from(degree)).map(|count| {
                    (0..count)
                        .fold(1i128, |ways, taken| ways * (step - taken) / (taken + 1))
                        .max(0)
                });
                let drift = 0.51 * choices.sum::<i128>() as f64 / f64::from(1u32 << guard_bits) + 0.5;
                let fits = exact.abs() < (1i64 << (62 - guard_bits)) as f64;
                let off = (walk.value() as f64 - exact).abs();
                ensure!(
                    !fits || off <= drift + 1e-5 * (1.0 + at.powi(4)),
                    "{off} off at step {step}, {drift} is promised"
                );
            }
            walk.advance();
        }
        Ok(())
    }
}

impl Case for PolynomialCase {
    fn check(&self) -> Verdict {
        self.check_with::<1>()?;
        self.check_with::<2>()?;
        self.check_with::<3>()?;
        self.check_with::<5>()
    }
}
