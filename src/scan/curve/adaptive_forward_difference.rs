//! Adaptive flattening by forward differences (Lien, Shantz and Pratt 1987, "Adaptive Forward Differencing for Rendering
//! Curves and Surfaces", Computer Graphics 21(4)): the step is halved where the curve bends, doubled where it does not.
//!
//! Guarantees: what [the module](crate::scan::curve) says. All differences are exact, so nothing drifts, and steps
//! are only doubled to where a halving could have begun: so the lines are those of
//! [`Bezier::de_casteljau`](crate::scan::Bezier::de_casteljau), point for point.
//!
//! Cost: three additions a coordinate for a line, and three additions and shifts for a halving or a doubling; a question
//! or two a line whether it is flat, but none for a parabola, which one step fits throughout. 88 bytes. Take it always: it
//! is the default.

use core::fmt::Debug;

use fixed::types::U8F8;

use crate::{
    geometry::{Sub8, SubPoint},
    scan::curve::{
        bezier::{Bezier, point_of_curve},
        flatten::{Flatness, GUARD_BITS, MOST_HALVINGS, compared, round},
    },
};

impl<const CONTROLS: usize> Bezier<CONTROLS> {
    /// The ends of the lines that a curve becomes, by a step that is halved where the curve bends and doubled where it does not:
    /// the default.
    ///
    /// All differences are exact, so the lines are those of [`Bezier::de_casteljau`](crate::scan::Bezier::de_casteljau). The
    /// [type](Self) says what the tolerance means.
    ///
    /// Cost: three additions a coordinate for a line, three additions and shifts for a halving or a doubling. 88 bytes. Source:
    /// Lien, Shantz and Pratt 1987.
    pub fn adaptive_forward_difference(
        &self,
        tolerance: U8F8,
    ) -> impl Iterator<Item = SubPoint<Sub8>> + Clone + Debug + use<CONTROLS> {
        flatten(self, tolerance)
    }
}

/// Starts a walk along a curve, whose step is chosen so that each line is within the tolerance.
pub(crate) fn flatten<const CONTROLS: usize>(curve: &Bezier<CONTROLS>, tolerance: U8F8) -> AdaptiveForwardDifference {
    let mut walk = CurveStep {
        axes: curve.power_basis().map(|coefficients| Differences::new(&coefficients)),
        halvings: 0,
        step: 0,
    };
    let flatness = Flatness::new(tolerance);
    walk.halve_until_flat(flatness);
    let bends_evenly = walk.axes.iter().all(|axis| axis.third == 0);
    AdaptiveForwardDifference {
        walk,
        flatness,
        bends_evenly,
    }
}

/// The lines of a curve, from its start to its end.
#[derive(Debug, Clone)]
pub(crate) struct AdaptiveForwardDifference {
    walk: CurveStep,
    flatness: Flatness,
    /// Whether the curve is a parabola or straight, so that one step fits all of it.
    bends_evenly: bool,
}

/// A point on a curve, and the differences for a step from there.
#[derive(Debug, Copy, Clone)]
struct CurveStep {
    /// The differences of the columns, and those of the rows.
    axes: [Differences; 2],
    /// How often the step has been halved; without a halving it is the whole curve.
    halvings: u32,
    /// Number of steps of this size that lie behind the point.
    step: u32,
}

/// A coordinate and its differences for one step, with guard bits.
#[derive(Debug, Copy, Clone)]
struct Differences {
    value: i64,
    first: i64,
    second: i64,
    third: i64,
}

// In the domain the second derivative is below 6 * 2^23 units and the third below 6 * 2^24. So all differences of a step
// that lies on the curve fit 63 bits with their guard bits. One more step behind the end, which is never read, fits as well: the
// last steps are short, since the curve is level within the tolerance there.
impl Differences {
    /// The differences for one step over the whole curve, from the coefficients of the power basis.
    fn new(coefficients: &[i32]) -> Self {
        let mut coefficients = coefficients.iter().map(|&units| i64::from(units) << GUARD_BITS);
        let mut next = || coefficients.next().unwrap_or(0);
        let [value, linear, square, cube] = [next(), next(), next(), next()];
        let third = cube * 6;
        Self {
            value,
            first: linear + square + cube,
            second: square * 2 + third,
            third,
        }
    }

    #[inline]
    fn advance(&mut self) {
        self.value += self.first;
        self.first += self.second;
        self.second += self.third;
    }

    /// Turns the differences into those for half the step; exact, as the guard bits allow for every halving.
    #[inline]
    fn halve(&mut self) {
        self.third >>= 3;
        self.second = (self.second >> 2) - self.third;
        self.first = (self.first - self.second) >> 1;
    }

    /// Turns the differences into those for twice the step.
    #[inline]
    fn double(&mut self) {
        self.first = self.first * 2 + self.second;
        self.second = (self.second + self.third) * 4;
        self.third *= 8;
    }

    /// The greatest size of the second derivative over the step: it is linear, so one end has it.
    #[inline]
    fn bend(&self) -> u32 {
        let at_start = self.second - self.third;
        compared(at_start).max(compared(self.second))
    }

    /// The greatest size of the second derivative over twice the step, before the step is doubled.
    #[inline]
    fn bend_of_double(&self) -> u32 {
        let at_start = (self.second - self.third) << 2;
        let at_end = (self.second + self.third) << 2;
        compared(at_start).max(compared(at_end))
    }
}

impl CurveStep {
    fn halve_until_flat(&mut self, flatness: Flatness) {
        while self.halvings < MOST_HALVINGS && !flatness.allows(self.axes.each_ref().map(Differences::bend)) {
            self.axes.iter_mut().for_each(Differences::halve);
            self.halvings += 1;
            self.step *= 2;
        }
    }

    /// Doubles the step where it stays flat and a halving could have begun; returns whether it did.
    fn double_while_flat(&mut self, flatness: Flatness) -> bool {
        let halvings = self.halvings;
        while self.halvings > 0
            && self.step.is_multiple_of(2)
            && flatness.allows(self.axes.each_ref().map(Differences::bend_of_double))
        {
            self.axes.iter_mut().for_each(Differences::double);
            self.halvings -= 1;
            self.step /= 2;
        }
        self.halvings != halvings
    }

    fn advance(&mut self) {
        self.axes.iter_mut().for_each(Differences::advance);
        self.step += 1;
    }

    fn is_at_end(&self) -> bool {
        self.step >> self.halvings != 0
    }
}

impl Iterator for AdaptiveForwardDifference {
    type Item = SubPoint<Sub8>;

    #[inline]
    fn next(&mut self) -> Option<SubPoint<Sub8>> {
        let Self { walk, flatness, .. } = self;
        if walk.is_at_end() {
            return None;
        }
        if !self.bends_evenly && !walk.double_while_flat(*flatness) {
            walk.halve_until_flat(*flatness);
        }
        walk.advance();
        let [x, y] = walk.axes.each_ref().map(|axis| round(axis.value));
        Some(point_of_curve(x, y))
    }
}
