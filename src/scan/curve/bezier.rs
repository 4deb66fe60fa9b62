//! Bézier curves (de Casteljau 1959, Bézier 1962): quadratic and cubic ones by their control points, in 1/256 pixel.
//!
//! Guarantees: sub-pixel points of either precision are taken as they are; the power basis is exact. What draws a curve is
//! in [the module](crate::scan::curve).

use core::num::NonZeroU32;

use fixed::types::I24F8;

use crate::{
    geometry::{InputError, Sub8, SubPixel, SubPoint},
    scan::curve::flatten::{GUARD_BITS, compared},
};

/// A Bézier curve with that many control points: 3 of a parabola (quadratic), 4 of a curve that can have an
/// inflection, a loop or a cusp (cubic), and 2 of a straight line.
///
/// # Flattening
///
/// A curve becomes straight lines that are nowhere further from it than a tolerance. A function for each
/// algorithm, all with the signature `fn(&self, tolerance)`.
///
/// They give the ends of the lines; the first line begins at the first control point.
///
/// | algorithm | how | take it when |
/// |---|---|---|
/// | [`adaptive_forward_difference`](Self::adaptive_forward_difference) | the step grows and shrinks | lines are drawn: the default, fewest lines and no table |
/// | [`de_casteljau`](Self::de_casteljau) | halves the curve until its parts are flat | halves of curves are wanted by themselves; it gives the same lines |
/// | [`uniform_subdivision`](Self::uniform_subdivision) | equal steps, their number known before | the number of lines must be known, or lines are cheap |
///
/// A cubic with random control points on a display takes a third more lines by equal steps, and half the time to find them.
///
/// Guarantees of all three:
/// - each point of the curve has a point of the lines within the tolerance, and each of the lines one of the curve (their
///   Fréchet distance); the rounding of the ends to 1/256 pixel is included. The smallest tolerance that can be kept is
///   2/256 pixel, and smaller ones count as that;
/// - the last line ends exactly at the last control point;
/// - the reversed curve has the same lines, reversed;
/// - any curve in the domain of [`Sub8`]: at most 4,096 lines, no number overflows.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bezier<const CONTROLS: usize> {
    /// Columns of the control points, in 1/256 pixel.
    x: [i32; CONTROLS],
    /// Rows of the control points, in 1/256 pixel.
    y: [i32; CONTROLS],
}

impl<const CONTROLS: usize> Bezier<CONTROLS> {
    /// The curve with these control points; the first and the last one are its ends.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a point is outside the domain of [`Sub8`], which a point made by
    /// [`SubPoint::from_units`] never is.
    pub fn new<S: SubPixel>(controls: [SubPoint<S>; CONTROLS]) -> Result<Self, InputError> {
        const { assert!(2 <= CONTROLS && CONTROLS <= 4) }
        let mut curve = Self {
            x: [0; CONTROLS],
            y: [0; CONTROLS],
        };
        for ((x, y), control) in curve.x.iter_mut().zip(&mut curve.y).zip(&controls) {
            let point = to_sub8(control)?;
            (*x, *y) = (point.x_units(), point.y_units());
        }
        Ok(curve)
    }

    /// The coefficients of 1, t, t^2 and so on of both coordinates, in 1/256 pixel: columns, then rows.
    ///
    /// The coefficient of t^i is the difference of order i of the control points times the number of ways to choose i of
    /// the degree. Those of a cubic are below 2^25.
    pub fn power_basis(&self) -> [[i32; CONTROLS]; 2] {
        [self.x, self.y].map(power_basis)
    }

    /// The control points of both coordinates, columns, then rows, with [`GUARD_BITS`] fractional bits.
    pub(crate) fn guarded_controls(&self) -> [[i64; CONTROLS]; 2] {
        [self.x, self.y].map(|axis| axis.map(|control| i64::from(control) << GUARD_BITS))
    }
}

fn power_basis<const CONTROLS: usize>(controls: [i32; CONTROLS]) -> [i32; CONTROLS] {
    let mut differences = controls;
    let mut ways = 1u32;
    let mut next_order = NonZeroU32::MIN;
    controls.map(|_| {
        let coefficient = differences.first().map_or(0, |first| first * ways as i32);
        let mut later = differences.iter_mut();
        if let Some(mut current) = later.next() {
            for next in later {
                *current = *next - *current;
                current = next;
            }
        }
        // C(n, i) = C(n, i - 1) * (n + 1 - i) / i, where i is at most n + 1, the number of control points.
        ways = ways * (CONTROLS as u32 - next_order.get()) / next_order;
        next_order = next_order.saturating_add(1);
        coefficient
    })
}

/// The greatest size of the second derivative of a coordinate, as [`compared`] gives it.
///
/// The second derivative is a Bézier curve too: its control points are the second differences, `n (n - 1)` times. So it
/// goes no further than these, and up to degree three they are its values at its ends.
pub(crate) fn bend<const CONTROLS: usize>(controls: &[i64; CONTROLS]) -> u32 {
    let degree = CONTROLS.saturating_sub(1) as i64;
    let ways = degree * (degree - 1);
    let sizes = controls.windows(3).map(|three| match three {
        // Below 6 * 2^23 units in the domain, and 36 guard bits.
        &[before, here, after] => {
            let second_difference = before - here + (after - here);
            compared(second_difference * ways)
        }
        _ => 0,
    });
    sizes.max().unwrap_or(0)
}

/// Converts a point to 1/256 pixel, rounded down.
pub(crate) fn to_sub8<S: SubPixel>(point: &SubPoint<S>) -> Result<SubPoint<Sub8>, InputError> {
    let units = |units: i32| {
        let units = (i64::from(units) << Sub8::FRACTION_BITS) >> S::FRACTION_BITS;
        i32::try_from(units).map_err(|_| InputError::out_of_domain::<Sub8>())
    };
    SubPoint::from_units(units(point.x_units())?, units(point.y_units())?)
}

/// The point of a curve with these coordinates in 1/256 pixel: as it lies between control points, it is in the domain.
pub(crate) fn point_of_curve(x: i64, y: i64) -> SubPoint<Sub8> {
    SubPoint {
        x: I24F8::from_bits(x as i32),
        y: I24F8::from_bits(y as i32),
    }
}
