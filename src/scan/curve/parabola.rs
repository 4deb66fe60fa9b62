//! Quadratic Bézier curves by forward differences in 32 bits: what text of many small curves is flattened with.
//!
//! A parabola bends evenly, so one step fits all of it, and its two differences are whole numbers in units of 1/256 pixel
//! divided by the number of steps twice. With up to 16 steps they fit 32 bits; a curve that takes more goes the way of all curves.
//!
//! Guarantees: the lines of [`Bezier::adaptive_forward_difference`](crate::scan::Bezier::adaptive_forward_difference), point for
//! point. Cost: two additions and a shift a coordinate for a line, and some 60 instructions a curve.
//!
//! Source: forward differences (Newton 1687; Foley, van Dam et al. 1990, section 11.2.9).

use fixed::types::U8F8;

use crate::{
    geometry::{Sub8, SubPoint},
    scan::curve::{
        Bezier,
        flatten::{Flatness, compared_parabola},
    },
};

/// The most halvings for which differences fit 32 bits: coordinates are below 2^22 apart.
const MOST_HALVINGS: u32 = 4;

/// Calls with both ends of each line of a curve with three control points (x, y), in 1/256 pixel, that is nowhere further from the
/// curve than the tolerance. All points must be in the domain of [`Sub8`].
#[inline(always)]
pub(crate) fn flatten(controls: [[i32; 2]; 3], tolerance: U8F8, mut line: impl FnMut([i32; 2], [i32; 2])) {
    let [from, control, to] = controls;
    // Not `flatten` of an array of axes, so that all of it stays in registers.
    let second = [from[0] - 2 * control[0] + to[0], from[1] - 2 * control[1] + to[1]];
    let flatness = Flatness::new(tolerance);
    let mut halvings = 0;
    while halvings <= MOST_HALVINGS && !flatness.allows(second.map(|axis| compared_parabola(axis, halvings))) {
        halvings += 1;
    }
    if halvings > MOST_HALVINGS {
        return flatten_long(controls, tolerance, &mut line);
    }
    let shift = 2 * halvings;
    let half = (1 << shift) >> 1;
    // Both differences for one step, times the square of the number of steps.
    let difference = |axis: [i32; 3]| ((axis[1] - axis[0]) << (halvings + 1)) + (axis[0] - 2 * axis[1] + axis[2]);
    let mut first = [
        difference([from[0], control[0], to[0]]),
        difference([from[1], control[1], to[1]]),
    ];
    let (mut value, mut at) = ([half; 2], from);
    for _ in 0..1 << halvings {
        value = [value[0] + first[0], value[1] + first[1]];
        first = [first[0] + 2 * second[0], first[1] + 2 * second[1]];
        let end = [from[0] + (value[0] >> shift), from[1] + (value[1] >> shift)];
        line(at, end);
        at = end;
    }
}

/// The same lines of a curve that takes more steps.
#[cold]
#[inline(never)]
fn flatten_long(controls: [[i32; 2]; 3], tolerance: U8F8, line: &mut dyn FnMut([i32; 2], [i32; 2])) {
    let [from, _, to] = controls;
    let points = controls.map(|[x, y]| SubPoint::<Sub8>::from_units(x, y));
    let curve = match points {
        [Ok(from), Ok(control), Ok(to)] => Bezier::new([from, control, to]),
        [Err(error), ..] | [_, Err(error), _] | [.., Err(error)] => Err(error),
    };
    // All points are in the domain.
    let Ok(curve) = curve else { return line(from, to) };
    let mut at = from;
    for end in curve.adaptive_forward_difference(tolerance) {
        let end = [end.x_units(), end.y_units()];
        line(at, end);
        at = end;
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;
    use crate::geometry::SubPixel;

    /// xorshift32.
    fn random(state: &mut u32) -> i32 {
        *state ^= *state << 13;
        *state ^= *state >> 17;
        *state ^= *state << 5;
        *state as i32
    }

    #[test]
    fn lines_are_those_of_all_curves() {
        let mut state = 0x2545_f491;
        let mut lines = 0;
        for attempt in 0..20_000 {
            let bits = 10 + attempt % 22;
            let mut next = || (random(&mut state) >> (32 - bits)).clamp(Sub8::MIN_UNITS, Sub8::MAX_UNITS);
            let controls = [[next(), next()], [next(), next()], [next(), next()]];
            let points = controls.map(|[x, y]| SubPoint::<Sub8>::from_units(x, y).unwrap());
            for tolerance in [2, 4, 32] {
                let tolerance = U8F8::from_bits(tolerance);
                let curve = Bezier::new(points).unwrap();
                let mut expected = curve.adaptive_forward_difference(tolerance);
                let mut at = controls[0];
                flatten(controls, tolerance, |from, to| {
                    assert_eq!(from, at);
                    at = to;
                    lines += 1;
                    let end = expected.next().map(|end| [end.x_units(), end.y_units()]);
                    assert_eq!(end, Some(to), "{controls:?}");
                });
                assert_eq!(
                    (at, expected.collect::<Vec<_>>().len()),
                    (controls[2], 0),
                    "{controls:?}"
                );
            }
        }
        assert!(lines > 300_000, "{lines}");
    }
}
