//! Midpoint subdivision (Sproull and Sutherland 1968, "A Clipping Divider", AFIPS Fall Joint Computer Conference):
//! halves the segment until what is left of it is one point, and asks the outcode of each midpoint which half to keep.
//!
//! Only additions, halvings and comparisons: it was made for hardware without a multiplier.
//!
//! Guarantees: accepts exactly the segments that share a point with the closed window, touching a corner included; each
//! end is the exact point rounded once to the nearest unit (ties to the larger coordinate), so at most half a unit off,
//! and never outside the window. Exchanging the end points exchanges the result and changes nothing else; clipping the
//! result again changes nothing. [`Segments::liang_barsky`](crate::clip::Segments::liang_barsky) gives the same integers.
//!
//! Why it is exact: after n halvings midpoints have n fractional bits, and all of them are kept. A crossing is a
//! fraction over the width or the height of the segment, and two crossings differ by one over their product at least.
//! What is left after as many halvings as both have bits, and one more, is too short for two crossings, or for a
//! crossing and a rounding boundary, unless they are the same.
//!
//! Cost: as many halvings for each end that is cut as the segment's length has bits in units, and seldom more than two
//! others: mostly 10 to 20. A tie takes all, 33 at most with [`Sub4`](crate::geometry::Sub4) and 65 with
//! [`Sub8`](crate::geometry::Sub8). In 64 bits, and where those do not hold the fractions (segments over some 2,000 pixels
//! with `Sub8`) in 128. Take it where nothing multiplies, or to see that nothing has to.

use core::ops::{Add, BitXor, Shl, Shr};

use crate::{
    clip::{
        Outcode,
        segment::{crossing::products_fit_32_bits, segments::Segments},
    },
    geometry::{FixedPointWindow, SubPixel, SubPoint},
};

impl Segments {
    /// The part of a segment inside a closed window, by bisection: nothing multiplies or divides; `None` where no point of it is.
    ///
    /// Each end is the exact point rounded once to the nearest unit, ties to the larger coordinate.
    ///
    /// Takes any numbers the coordinates can hold, also outside the domain of `S`.
    /// Source: Sproull and Sutherland 1968.
    ///
    /// ```
    /// use zrow::clip::Segments;
    /// use zrow::geometry::{Sub4, SubPoint, FixedPointWindow};
    ///
    /// let at = SubPoint::<Sub4>::from_units;
    /// let window = FixedPointWindow::new(at(0, 0)?, at(100, 60)?)?;
    /// assert_eq!(
    ///     Segments::midpoint_subdivision(at(-20, 30)?, at(80, -20)?, &window),
    ///     Some((at(0, 20)?, at(40, 0)?))
    /// );
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn midpoint_subdivision<S: SubPixel>(
        from: SubPoint<S>,
        to: SubPoint<S>,
        window: &FixedPointWindow<S>,
    ) -> Option<(SubPoint<S>, SubPoint<S>)> {
        if window.is_empty() {
            return None;
        }
        let (from_code, to_code) = (Outcode::of_sub_point(from, window), Outcode::of_sub_point(to, window));
        if from_code.either(to_code).is_inside() {
            return Some((from, to));
        }
        if !from_code.shared(to_code).is_inside() {
            return None;
        }
        subdivide((from, from_code), (to, to_code), window)
    }
}

/// Clips a segment whose outcodes neither accept nor reject it. Not inlined, because most segments do not come here.
#[inline(never)]
fn subdivide<S: SubPixel>(
    (from, from_code): (SubPoint<S>, Outcode),
    (to, to_code): (SubPoint<S>, Outcode),
    window: &FixedPointWindow<S>,
) -> Option<(SubPoint<S>, SubPoint<S>)> {
    let fraction_bits = fraction_bits(from, to);
    if fits_64_bits(from, to, window, fraction_bits) {
        Halving::<i64>::of(from, to, window, fraction_bits).clip(from_code, to_code)
    } else {
        // 65 fractional bits, 32 before them, and one more for the sum of two.
        Halving::<i128>::of(from, to, window, fraction_bits).clip(from_code, to_code)
    }
}

/// How many fractional bits of a unit the halving of a segment keeps: as many as its width and its height have bits
/// together, and one.
fn fraction_bits<S: SubPixel>(from: SubPoint<S>, to: SubPoint<S>) -> u32 {
    let bits = |from: i32, to: i32| 32u32 - from.abs_diff(to).leading_zeros();
    bits(from.x_units(), to.x_units()) + bits(from.y_units(), to.y_units()) + 1
}

/// Whether the sum of two coordinates fits with all their fractional bits.
fn fits_64_bits<S: SubPixel>(
    from: SubPoint<S>,
    to: SubPoint<S>,
    window: &FixedPointWindow<S>,
    fraction_bits: u32,
) -> bool {
    // 33 fractional bits, 16 before them, and one.
    if products_fit_32_bits::<S>() {
        return true;
    }
    // A one for each bit that is not the sign's.
    let bits = [from, to, window.top_left(), window.bottom_right()]
        .into_iter()
        .flat_map(|point| [point.x_units(), point.y_units()])
        .fold(0, |bits, units| bits | (units ^ (units >> 31)));
    bits.leading_zeros() >= fraction_bits.saturating_sub(30)
}

/// A number with the fractional bits of all midpoints.
trait Fine:
    Copy + Ord + From<i32> + Add<Output = Self> + BitXor<Output = Self> + Shl<u32, Output = Self> + Shr<u32, Output = Self>
{
    /// A whole number that is known to fit.
    fn whole(self) -> i32;
}

impl Fine for i64 {
    fn whole(self) -> i32 {
        self as i32
    }
}

impl Fine for i128 {
    fn whole(self) -> i32 {
        self as i32
    }
}

/// An end or a midpoint of what is left of the segment; half a unit is added, so that rounding is rounding down.
#[derive(Copy, Clone)]
struct GuardedPoint<N> {
    x: N,
    y: N,
}

/// The segment and the window, with room for every midpoint.
struct Halving<N> {
    from: GuardedPoint<N>,
    to: GuardedPoint<N>,
    first: GuardedPoint<N>,
    last: GuardedPoint<N>,
    fraction_bits: u32,
    /// What the fractional bits are below.
    unit: N,
}

impl<N: Fine> Halving<N> {
    fn of<S: SubPixel>(from: SubPoint<S>, to: SubPoint<S>, window: &FixedPointWindow<S>, fraction_bits: u32) -> Self {
        let half = N::from(1) << (fraction_bits - 1);
        let guarded = |point: SubPoint<S>| GuardedPoint {
            x: (N::from(point.x_units()) << fraction_bits) + half,
            y: (N::from(point.y_units()) << fraction_bits) + half,
        };
        Self {
            from: guarded(from),
            to: guarded(to),
            first: guarded(window.top_left()),
            last: guarded(window.bottom_right()),
            fraction_bits,
            unit: half + half,
        }
    }

    fn clip<S: SubPixel>(&self, from_code: Outcode, to_code: Outcode) -> Option<(SubPoint<S>, SubPoint<S>)> {
        let start = self.first_visible((self.from, from_code), (self.to, to_code))?;
        let end = self.first_visible((self.to, to_code), (self.from, from_code))?;
        Some((start, end))
    }

    /// The visible point nearest to `near`. Outcodes do not reject the segment.
    fn first_visible<S: SubPixel>(
        &self,
        (mut near, mut near_code): (GuardedPoint<N>, Outcode),
        (mut far, mut far_code): (GuardedPoint<N>, Outcode),
    ) -> Option<SubPoint<S>> {
        if near_code.is_inside() {
            return self.rounded(near);
        }
        for _ in 0..self.fraction_bits {
            if far_code.is_inside() && self.round_to_the_same(near, far) {
                break;
            }
            let middle = GuardedPoint {
                x: (near.x + far.x) >> 1,
                y: (near.y + far.y) >> 1,
            };
            let code = self.outcode(middle);
            // A midpoint is beyond no side that neither end is beyond: outside, it shares a side with one of them.
            if code.meets(near_code) {
                if code.meets(far_code) {
                    return None;
                }
                (near, near_code) = (middle, code);
            } else {
                (far, far_code) = (middle, code);
            }
        }
        // The exact point lies between the two. Where a rounding boundary does too, it is that: a tie, to the larger.
        self.rounded(GuardedPoint {
            x: near.x.max(far.x),
            y: near.y.max(far.y),
        })
    }

    fn outcode(&self, GuardedPoint { x, y }: GuardedPoint<N>) -> Outcode {
        let beyond = |is_beyond, side| if is_beyond { side } else { Outcode::INSIDE };
        beyond(x < self.first.x, Outcode::LEFT)
            .either(beyond(x > self.last.x, Outcode::RIGHT))
            .either(beyond(y < self.first.y, Outcode::ABOVE))
            .either(beyond(y > self.last.y, Outcode::BELOW))
    }

    /// Whether two positions differ in fractional bits alone.
    fn round_to_the_same(&self, one: GuardedPoint<N>, other: GuardedPoint<N>) -> bool {
        let fraction = N::from(0)..self.unit;
        fraction.contains(&(one.x ^ other.x)) && fraction.contains(&(one.y ^ other.y))
    }

    /// Never `None` for a point in the window: all of that lies in the domain.
    fn rounded<S: SubPixel>(&self, GuardedPoint { x, y }: GuardedPoint<N>) -> Option<SubPoint<S>> {
        let nearest = |value: N| (value >> self.fraction_bits).whole();
        SubPoint::from_units(nearest(x), nearest(y)).ok()
    }
}
