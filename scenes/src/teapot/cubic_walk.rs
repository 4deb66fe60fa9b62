//! A cubic Bézier curve at equal steps by forward differences (Foley, van Dam et al. 1990, section 11.2.9), exactly: four
//! integers, and three additions a step.

/// One coordinate of a curve, where the walk is: the value and its differences of order 1, 2 and 3.
#[derive(Copy, Clone)]
pub(super) struct CubicWalk([i64; 4]);

impl CubicWalk {
    /// From the first of the curve's four control values to the last in so many steps. Values and slopes are those of
    /// the curve times the third power of the steps, so that they are whole.
    pub(super) const fn new([start, one, two, end]: [i64; 4], steps: i64) -> Self {
        // The coefficients of 1, t, t^2 and t^3, with t = k / steps.
        let constant = start * steps * steps * steps;
        let linear = 3 * (one - start) * steps * steps;
        let square = 3 * (start - 2 * one + two) * steps;
        let cube = end - start + 3 * (one - two);
        Self([constant, linear + square + cube, 2 * square + 6 * cube, 6 * cube])
    }

    pub(super) const fn value(&self) -> i64 {
        self.0[0]
    }

    /// Six times the derivative by the number of the step: that of Newton's series of the differences.
    pub(super) const fn slope(&self) -> i64 {
        let [_, one, two, three] = self.0;
        6 * one - 3 * two + 2 * three
    }

    /// One step on.
    pub(super) const fn advance(&mut self) {
        let [value, one, two, three] = self.0;
        self.0 = [value + one, one + two, two + three, three];
    }
}
