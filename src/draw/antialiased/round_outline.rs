//! Outlines of elliptical arcs and straight lines, kept as parameters: any corner is computed by its index.
//!
//! A contour is a ring of arcs, each joined to the next one by a straight line; a corner without a curve is an arc with
//! radii of 0:
//!
//! ```text
//!     arc 0      arc 1            circle            1 arc of a whole turn
//!     .-------------.             sector            1 arc, and the point at its tip
//!    /               \            band of an arc    1 arc, and a shorter one backwards
//!   |                 |           rounded corners   4 arcs
//!    \               /            ring              2 contours, the inner one backwards
//!     '-------------'
//!     arc 3      arc 2
//! ```
//!
//! Guarantees: corners lie on the curve, rounded to 1/256 pixel, and no chord between two of them is further than 1/64
//! pixel from it. Cost: a sine and a cosine for each corner.

use core::num::NonZeroU32;

use fixed::types::U0F16;

use crate::{
    geometry::{InputError, Sub8, SubPixel, quotient_down},
    view::{cosine, sine},
};

/// Units of an angle in a whole turn, measured clockwise on the screen from the x axis.
pub(crate) const TURN: i32 = 1 << TURN_BITS;

/// Bits of an angle.
pub(crate) const TURN_BITS: u32 = 24;

/// Bits of an angle below 1/65,536 of a turn, the angles that have a sine.
const MORE_BITS: u32 = 8;

/// A corner of an outline: x and y in 1/256 pixel.
type Corner = [i32; 2];

/// A position in 1/256 pixel, as far from the origin as a shape of embedded-graphics can be.
pub(crate) type WidePosition = [i64; 2];

/// An arc of an ellipse, as its corners.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutlineArc {
    /// The centre of the ellipse, in 1/256 pixel.
    center: Corner,
    /// The horizontal and the vertical radius, in 1/256 pixel.
    radii: [u32; 2],
    /// The angle of the first corner, in [`TURN`]ths of a turn.
    start: i32,
    /// The angle from the first corner to the last one, in [`TURN`]ths of a turn; negative where it runs the other way.
    sweep: i32,
    /// The number of chords.
    chords: u32,
}

impl OutlineArc {
    /// An arc about a centre with two radii, in 1/256 pixel. `start` and `sweep` are in [`TURN`]ths of a turn.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the box around the whole ellipse leaves the domain of [`Sub8`].
    pub(crate) fn new(center: WidePosition, radii: [i64; 2], (start, sweep): (i32, i32)) -> Result<Self, InputError> {
        let [across, down] = radii.map(|radius| radius.max(0));
        let fits = |center: i64, radius: i64| {
            let farthest = center.unsigned_abs().saturating_add(radius.unsigned_abs());
            farthest <= Sub8::MAX_UNITS as u64
        };
        if !fits(center[0], across) || !fits(center[1], down) {
            return Err(InputError::out_of_domain::<Sub8>());
        }
        // Both fit: the domain is below 2^21 units.
        let radii = [across as u32, down as u32];
        let [x, y] = center.map(|coordinate| coordinate as i32);
        let longest = across.max(down) as u32;
        let sweep = sweep.clamp(-TURN, TURN);
        let chords = if longest == 0 {
            0
        } else {
            // At most 1,612 edges times 2^24.
            let part = u64::from(edges_of_turn(longest).get()) * u64::from(sweep.unsigned_abs());
            (((part + TURN as u64 - 1) >> TURN_BITS) as u32).max(1)
        };
        Ok(Self {
            center: [x, y],
            radii,
            start: start & (TURN - 1),
            sweep,
            chords,
        })
    }

    /// A corner without a curve.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where it is outside the domain of [`Sub8`].
    pub(crate) fn point(at: WidePosition) -> Result<Self, InputError> {
        Self::new(at, [0, 0], (0, 0))
    }

    /// The arc from its last corner to its first one.
    #[must_use]
    fn reversed(self) -> Self {
        Self {
            start: self.start + self.sweep,
            sweep: -self.sweep,
            ..self
        }
    }

    /// The number of corners: those of a whole turn are without the first one repeated.
    fn corners(&self) -> u32 {
        if self.sweep.abs() == TURN && self.chords > 0 {
            self.chords
        } else {
            self.chords + 1
        }
    }

    /// The corner with that index.
    fn corner(&self, index: u32) -> Corner {
        let Some(chords) = NonZeroU32::new(self.chords) else {
            return self.center;
        };
        // Rounded to the nearest, so that a circle is the same from all sides. 2^24 times 1,612 fits.
        let part = u64::from(self.sweep.unsigned_abs()) * u64::from(index) + u64::from(chords.get() >> 1);
        let part = quotient_down(part, chords);
        let angle = self.start + if self.sweep < 0 { -(part as i32) } else { part as i32 };
        let [cosine, sine] = direction(angle);
        let [across, down] = self.radii;
        let [x, y] = self.center;
        [x + scaled(across, cosine), y + scaled(down, sine)]
    }
}

/// The cosine and the sine of an angle in [`TURN`]ths of a turn, in 2.30 fixed point: straight lines between those that
/// are 1/65,536 of a turn apart, less than 2^-29 off.
pub(crate) fn direction(angle: i32) -> [i32; 2] {
    let low = angle & ((1 << MORE_BITS) - 1);
    // Angles are modulo a whole turn.
    let at = |steps: i32| {
        let angle = U0F16::from_bits(((angle >> MORE_BITS) + steps) as u16);
        [cosine(angle).to_bits(), sine(angle).to_bits()]
    };
    let first = at(0);
    if low == 0 {
        return first;
    }
    let [next_cosine, next_sine] = at(1);
    let between = |from: i32, to: i32| from + (((to - from) * low + (1 << (MORE_BITS - 1))) >> MORE_BITS);
    [between(first[0], next_cosine), between(first[1], next_sine)]
}

/// A length, in any unit below 2^31, times a number in 2.30 fixed point.
pub(crate) fn scaled(length: u32, factor: i32) -> i32 {
    // The factor is at most 1.
    ((i64::from(length) * i64::from(factor) + (1 << 29)) >> 30) as i32
}

/// A closed contour of up to four arcs.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RoundContour {
    arcs: [OutlineArc; 4],
    /// How many of the arcs there are.
    count: usize,
}

impl RoundContour {
    /// A contour of these arcs, each joined to the next one by a straight line; those after the fourth are left out.
    pub(crate) fn new(arcs: &[OutlineArc]) -> Self {
        let mut contour = Self::default();
        for (slot, arc) in contour.arcs.iter_mut().zip(arcs) {
            *slot = *arc;
            contour.count += 1;
        }
        contour
    }

    /// The ellipse in a box.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where it leaves the domain of [`Sub8`].
    pub(crate) fn ellipse(center: WidePosition, radii: [i64; 2]) -> Result<Self, InputError> {
        Ok(Self::new(&[OutlineArc::new(center, radii, (0, TURN))?]))
    }

    /// The contour in the opposite direction, for a hole.
    #[must_use]
    pub(crate) fn reversed(self) -> Self {
        let mut contour = Self {
            arcs: self.arcs.map(OutlineArc::reversed),
            ..self
        };
        contour.arcs.get_mut(..self.count).unwrap_or_default().reverse();
        contour
    }

    fn arcs(&self) -> &[OutlineArc] {
        self.arcs.get(..self.count).unwrap_or_default()
    }

    fn corners(&self) -> u32 {
        self.arcs().iter().map(OutlineArc::corners).sum()
    }

    fn corner(&self, index: u32) -> Corner {
        let mut rest = index;
        for arc in self.arcs() {
            let corners = arc.corners();
            if rest < corners {
                return arc.corner(rest);
            }
            rest -= corners;
        }
        Corner::default()
    }
}

/// One contour of arcs, or an outer one and an inner one in the opposite direction.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RoundOutline {
    outer: RoundContour,
    inner: Option<RoundContour>,
}

impl RoundOutline {
    /// The inside of a contour.
    pub(crate) const fn new(outer: RoundContour) -> Self {
        Self { outer, inner: None }
    }

    /// What lies between two contours, the inner one inside the outer one.
    pub(crate) fn ring(outer: RoundContour, inner: Option<RoundContour>) -> Self {
        Self {
            outer,
            inner: inner.map(RoundContour::reversed),
        }
    }

    /// The number of contours.
    pub(crate) const fn contours(&self) -> usize {
        if self.inner.is_some() { 2 } else { 1 }
    }

    /// The number of corners of a contour.
    pub(crate) fn corners(&self, contour: usize) -> u32 {
        self.contour(contour).map_or(0, RoundContour::corners)
    }

    /// A corner of a contour by its index, in 1/256 pixel. Those in the order of their indices are the contour.
    pub(crate) fn corner(&self, contour: usize, index: u32) -> Corner {
        self.contour(contour)
            .map_or(Corner::default(), |contour| contour.corner(index))
    }

    fn contour(&self, contour: usize) -> Option<&RoundContour> {
        match contour {
            0 => Some(&self.outer),
            1 => self.inner.as_ref(),
            _ => None,
        }
    }
}

/// The number of edges of a whole turn, so that no edge is further than 1/64 pixel from a circle of that radius in
/// 1/256 pixel: a multiple of four, from 8 to 1,612.
pub(crate) fn edges_of_turn(radius: u32) -> NonZeroU32 {
    const LEAST: NonZeroU32 = NonZeroU32::new(8).unwrap();
    // A chord over 1/n of a turn is r (1 - cos(pi / n)) off, or about r pi^2 / (2 n^2): n^2 must be 316 times the
    // radius in pixels.
    let least = u64::from(radius) * 316 / 256;
    let edges = (least.isqrt() as u32 + 4) & !3;
    NonZeroU32::new(edges).map_or(LEAST, |edges| edges.max(LEAST))
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;

    const CENTER: WidePosition = [1_000, -2_000];

    /// The distance of a position from a circle about [`CENTER`], in 1/256 pixel.
    fn distance_from_circle(x: f64, y: f64, radius: f64) -> f64 {
        (x - CENTER[0] as f64).hypot(y - CENTER[1] as f64) - radius
    }

    /// Every corner is as near to the circle as rounding lets it be, and the middle of every chord within 1/64 pixel and
    /// that rounding.
    #[test]
    fn chords_lie_within_a_64th_of_a_pixel_of_the_circle() {
        for radius in [1, 77, 128, 1_000, 30_001, 400_000, 2_000_000] {
            for sweep in [TURN, -TURN, TURN / 3, 1 << 20, -77, 0] {
                let arc = OutlineArc::new(CENTER, [radius; 2], (12_345_678, sweep)).unwrap();
                let corners: Vec<Corner> = (0..arc.corners()).map(|index| arc.corner(index)).collect();
                for &[x, y] in &corners {
                    let distance = distance_from_circle(x.into(), y.into(), radius as f64);
                    assert!(distance.abs() < 0.72, "{radius}, {sweep}: {distance}");
                }
                for pair in corners.windows(2) {
                    let middle = |axis: usize| f64::from(pair[0][axis] + pair[1][axis]) / 2.0;
                    let distance = distance_from_circle(middle(0), middle(1), radius as f64);
                    assert!(distance.abs() < 4.0 + 0.72, "{radius}, {sweep}: {distance}");
                }
            }
        }
    }

    #[test]
    fn a_circle_is_symmetric_about_both_axes() {
        for radius in [128, 700, 6_400, 81_000] {
            let circle = OutlineArc::new([0, 0], [radius; 2], (0, TURN)).unwrap();
            let corners: Vec<Corner> = (0..circle.corners()).map(|index| circle.corner(index)).collect();
            for [x, y] in &corners {
                assert!(
                    corners.contains(&[-x, *y]) && corners.contains(&[*x, -y]),
                    "{radius}: {x}, {y}"
                );
            }
        }
    }

    #[test]
    fn a_hole_has_the_corners_of_its_contour_in_the_opposite_order() {
        let arc = |center: WidePosition, start: i32| OutlineArc::new(center, [900, 500], (start, TURN / 4)).unwrap();
        let contour = RoundContour::new(&[arc([0, 0], 0), arc([-70, 0], TURN / 4), arc([5, -900], TURN / 2)]);
        let outline = RoundOutline::ring(contour, Some(contour));
        let corners = |number: usize| (0..outline.corners(number)).map(move |index| (number, index));
        let [outer, inner] =
            [0, 1].map(|number| corners(number).map(|(c, i)| outline.corner(c, i)).collect::<Vec<_>>());
        assert!(
            outer.iter().eq(inner.iter().rev()) && outer.len() == 30,
            "{outer:?}, {inner:?}"
        );
    }

    #[test]
    fn what_leaves_the_domain_is_an_error() {
        let end = i64::from(Sub8::MAX_UNITS);
        assert!(OutlineArc::new([end - 256, 0], [256, 9], (0, TURN)).is_ok());
        assert!(OutlineArc::new([end - 256, 0], [257, 9], (0, TURN)).is_err());
        assert!(OutlineArc::new([0, i64::MIN], [9, 9], (0, TURN)).is_err());
    }
}
