//! Flattening in equal steps of the parameter, their number by Wang's formula (1984; Sederberg and Parry 1986), walked by
//! forward differences.
//!
//! Guarantees: what [the module](crate::scan::curve) says; the number of lines is known before the first one, and
//! is the next power of two, so that the [differences](crate::scan::curve::polynomial_forward_difference) are exact. The
//! ends of the adaptive siblings' lines are among those here.
//!
//! Cost: as many additions a coordinate and a line as the degree. Take it when the number of lines must be known, or when
//! lines are cheap: it finds them in half the time of the adaptive way, but a third more of them on an average cubic.

use core::fmt::Debug;

use fixed::types::U8F8;

use crate::{
    geometry::{Sub8, SubPoint},
    scan::curve::{
        bezier::{Bezier, bend, point_of_curve},
        flatten::Flatness,
        polynomial_forward_difference::PolynomialForwardDifference,
    },
};

impl<const CONTROLS: usize> Bezier<CONTROLS> {
    /// The ends of the lines that a curve becomes, in equal steps of its parameter; their number is known before the first one.
    ///
    /// The number is a power of two, so that all values are exact; the ends of the adaptive siblings' lines are among those
    /// here. The [type](Self) says what the tolerance means.
    ///
    /// Cost: as many additions a coordinate and a line as the degree. Source: Wang 1984; Sederberg and Parry 1986.
    pub fn uniform_subdivision(
        &self,
        tolerance: U8F8,
    ) -> impl ExactSizeIterator<Item = SubPoint<Sub8>> + Clone + Debug + use<CONTROLS> {
        let halvings = Flatness::new(tolerance).halvings(self.guarded_controls().each_ref().map(bend));
        let [x, y] = self
            .power_basis()
            .map(|coefficients| PolynomialForwardDifference::dyadic(&coefficients, halvings));
        match (x, y) {
            (Ok(x), Ok(y)) => UniformSubdivision {
                axes: [x, y],
                remaining: 1 << halvings,
            },
            // Never: 12 halvings of a cubic take 36 guard bits.
            _ => UniformSubdivision {
                axes: [PolynomialForwardDifference::rounded(&[0; CONTROLS], 1, 0); 2],
                remaining: 0,
            },
        }
    }
}

/// The lines of a curve, from its start to its end; their number is its exact size.
#[derive(Debug, Clone)]
struct UniformSubdivision<const CONTROLS: usize> {
    /// The differences of the columns, and those of the rows.
    axes: [PolynomialForwardDifference<CONTROLS>; 2],
    remaining: u32,
}

impl<const CONTROLS: usize> Iterator for UniformSubdivision<CONTROLS> {
    type Item = SubPoint<Sub8>;

    fn next(&mut self) -> Option<SubPoint<Sub8>> {
        self.remaining = self.remaining.checked_sub(1)?;
        self.axes.iter_mut().for_each(PolynomialForwardDifference::advance);
        let [x, y] = self.axes.each_ref().map(PolynomialForwardDifference::value);
        Some(point_of_curve(x, y))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.remaining as usize, Some(self.remaining as usize))
    }
}

impl<const CONTROLS: usize> ExactSizeIterator for UniformSubdivision<CONTROLS> {}
