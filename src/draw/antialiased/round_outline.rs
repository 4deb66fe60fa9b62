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

use core::num::{NonZeroU16, NonZeroU32};

use fixed::types::U0F16;

use crate::{
    geometry::{InputError, Sub8, SubPixel, Window},
    view::sine,
};

/// Units of an angle in a whole turn, measured clockwise on the screen from the x axis.
pub(crate) const TURN: i32 = 1 << TURN_BITS;

/// Bits of an angle.
pub(crate) const TURN_BITS: u32 = 24;

/// Bits of an angle below 1/65,536 of a turn, the angles that have a sine.
const MORE_BITS: u32 = 8;

/// Bits of the angles in a quarter of a turn that have a sine.
const QUARTER_BITS: u32 = TURN_BITS - MORE_BITS - 2;

/// A corner of an outline: x and y in 1/256 pixel.
type Corner = [i32; 2];

/// A position in 1/256 pixel, as far from the origin as a shape of embedded-graphics can be.
pub(crate) type WidePosition = [i64; 2];

/// An arc of an ellipse, as its corners.
///
/// The corners between the first and the last one lie at fixed angles from where the arc begins clockwise: an arc that grows
/// at its end keeps all of them.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutlineArc {
    /// The centre of the ellipse, in 1/256 pixel.
    center: Corner,
    /// The horizontal and the vertical radius, in 1/256 pixel.
    radii: [u32; 2],
    /// The angle at which the arc begins clockwise, in [`TURN`]ths of a turn.
    start: i32,
    /// The angle from there to its other end clockwise, in [`TURN`]ths of a turn.
    sweep: i32,
    /// Whether the corners run from that other end counterclockwise.
    is_reversed: bool,
    /// The number of chords that a quarter of a turn has.
    chords_of_quarter: u16,
    /// The number of chords.
    chords: u16,
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
        let mut arc = Self {
            center: [x, y],
            radii,
            start: (start + sweep.min(0)) & (TURN - 1),
            sweep: sweep.abs(),
            is_reversed: sweep < 0,
            chords_of_quarter: 0,
            chords: 0,
        };
        if longest != 0 {
            let edges = edges_of_turn(longest).get();
            // At most 1,612 edges times 2^24, of which the upper half is at most 1,612.
            let part = u64::from(edges) * u64::from(arc.sweep.unsigned_abs());
            arc.chords_of_quarter = (edges >> 2) as u16;
            arc.chords = ((part + TURN as u64 - 1) >> TURN_BITS).max(1) as u16;
            // Angles are rounded: the last corner but one may lie at the end or behind it.
            if arc.chords > 1 && arc.angle_of(arc.chords - 1) >= arc.start + arc.sweep {
                arc.chords -= 1;
            }
        }
        Ok(arc)
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
            is_reversed: !self.is_reversed,
            ..self
        }
    }

    /// The number of corners: those of a whole turn are without the first one repeated.
    pub(crate) fn corners(&self) -> u16 {
        if self.sweep == TURN && self.chords > 0 {
            self.chords
        } else {
            self.chords + 1
        }
    }

    /// The number of chords that a quarter of a turn has; 0 for a corner without a curve.
    pub(crate) const fn chords_of_quarter(&self) -> u16 {
        self.chords_of_quarter
    }

    /// The angle of a corner counted clockwise, in [`TURN`]ths of a turn: at least the start, growing with the number.
    fn angle_of(&self, number: u16) -> i32 {
        let chords = NonZeroU16::new(self.chords_of_quarter).unwrap_or(NonZeroU16::MIN);
        if number == 0 {
            return self.start;
        }
        if number >= self.chords {
            return self.start + self.sweep;
        }
        let (quarters, rest) = (i32::from(number / chords), u32::from(number % chords));
        // Rounded to the nearest, so that a circle is the same from all sides. Below 2^24.
        let part = ((rest << QUARTER_BITS) + u32::from(chords.get() >> 1)) / NonZeroU32::from(chords);
        let steps = (self.start + (1 << (MORE_BITS - 1))) >> MORE_BITS;
        (steps + (quarters << QUARTER_BITS) + part as i32) << MORE_BITS
    }

    /// The number, counted clockwise, of the corner with that index, or the index of the one with that number.
    fn number_of(&self, index: u16) -> u16 {
        if self.is_reversed { self.chords - index } else { index }
    }

    /// The y of the corner with that index. Cost: a sine.
    pub(crate) fn y_of(&self, index: u16) -> i32 {
        let ([_, y], [_, down]) = (self.center, self.radii);
        if self.chords == 0 {
            return y;
        }
        y + scaled(down, sine_of(self.angle_of(self.number_of(index))))
    }

    /// The corner with that index. Cost: a sine and a cosine.
    #[inline(always)]
    pub(crate) fn corner(&self, index: u16) -> Corner {
        if self.chords == 0 {
            return self.center;
        }
        let [cosine, sine] = direction(self.angle_of(self.number_of(index)));
        let [across, down] = self.radii;
        let [x, y] = self.center;
        [x + scaled(across, cosine), y + scaled(down, sine)]
    }
}

/// Words of an arc in memory.
pub(crate) const ARC_WORDS: usize = 7;

/// Bits of a radius, which is in the domain of [`Sub8`].
const RADIUS_BITS: u32 = 22;

/// An arc in words, and the position of its first corner in the outline that it is a part of.
impl OutlineArc {
    pub(crate) fn to_words(self, position: u16) -> [u32; ARC_WORDS] {
        let ([x, y], [across, down]) = (self.center, self.radii);
        [
            x as u32,
            y as u32,
            across | u32::from(self.chords_of_quarter) << RADIUS_BITS,
            down,
            self.start as u32 | u32::from(self.is_reversed) << 31,
            self.sweep as u32,
            u32::from(self.chords) | u32::from(position) << 16,
        ]
    }

    #[inline(always)]
    pub(crate) fn of_words(words: &[u32; ARC_WORDS]) -> (Self, u16) {
        let [x, y, across, down, start, sweep, chords] = *words;
        let arc = Self {
            center: [x as i32, y as i32],
            radii: [across & ((1 << RADIUS_BITS) - 1), down],
            start: (start & (TURN as u32 - 1)) as i32,
            sweep: sweep as i32,
            is_reversed: start >> 31 != 0,
            chords_of_quarter: (across >> RADIUS_BITS) as u16,
            chords: chords as u16,
        };
        (arc, (chords >> 16) as u16)
    }
}

/// An axis of the picture.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) enum Axis {
    X = 0,
    Y = 1,
}

/// Corners at which an arc turns back along the x or the y axis, and how many edges lie between them in a row.
impl OutlineArc {
    /// Calls `call` with the indices of corners, in ascending order, between which all others lie in monotone order along an
    /// axis: the first one, the last one, and the outermost ones between them.
    pub(crate) fn turns(&self, axis: Axis, call: &mut dyn FnMut(u16)) {
        let last = self.corners() - 1;
        call(0);
        // The ellipse's ends along x are at even quarters of a turn, those along y at odd ones. A start is below a turn.
        for step in 0..4 {
            let step = if self.is_reversed { 3 - step } else { step };
            let number = self.outermost(2 * step + axis as i32, axis);
            let index = number.map(|number| self.number_of(number));
            if let Some(index) = index.filter(|&index| 0 < index && index < last) {
                call(index);
            }
        }
        if last > 0 {
            call(last);
        }
    }

    /// Whether the arcs have one centre and opposite directions.
    pub(crate) fn is_opposite(&self, other: &Self) -> bool {
        self.center == other.center && self.is_reversed != other.is_reversed
    }

    /// Whether a window lies inside the circle of the smaller radius, more than a pixel from it.
    pub(crate) fn is_around(&self, window: &Window) -> bool {
        let ([x, y], [across, down]) = (self.center, self.radii);
        // Sides of a window that are far away are further than any radius.
        let farthest = |start: i32, end: i32, center: i32| {
            let units = |pixel: i32| i64::from(pixel) * 256 - 128 - i64::from(center);
            units(start).unsigned_abs().max(units(end).unsigned_abs()).min(1 << 31)
        };
        let (right, below) = (
            farthest(window.left, window.right, x),
            farthest(window.top, window.bottom, y),
        );
        let radius = u64::from(across.min(down).saturating_sub(256));
        right * right + below * below < radius * radius
    }

    /// Counts the corners that this arc and another one have in common: from the first corner of both on, or with `from_end`
    /// from the last one backwards.
    pub(crate) fn common_corners(&self, other: &Self, from_end: bool) -> u16 {
        let is_extended = self.is_reversed == from_end
            && Self {
                sweep: other.sweep,
                chords: other.chords,
                ..*self
            } == *other;
        if self == other {
            self.corners()
        } else if is_extended {
            // All but the last ones, which lie at the ends of the arcs.
            self.chords.min(other.chords)
        } else {
            0
        }
    }

    /// The number, counted clockwise, of the corner that is outermost around an angle in quarters of a turn; `None` where
    /// the arc does not pass it.
    fn outermost(&self, quarters: i32, axis: Axis) -> Option<u16> {
        let angle = quarters << (TURN_BITS - 2);
        if angle <= self.start || self.start + self.sweep <= angle {
            return None;
        }
        let part = u64::from((angle - self.start).unsigned_abs()) * u64::from(self.chords_of_quarter);
        let mut before = ((part >> (TURN_BITS - 2)) as u16).min(self.chords);
        while before > 0 && self.angle_of(before) > angle {
            before -= 1;
        }
        while before < self.chords && self.angle_of(before + 1) <= angle {
            before += 1;
        }
        let distance = |number: u16| {
            let [cosine, sine] = direction(self.angle_of(number));
            let [across, down] = self.radii;
            match axis {
                Axis::X => scaled(across, cosine),
                Axis::Y => scaled(down, sine),
            }
            .abs()
        };
        let behind = (before + 1).min(self.chords);
        Some(if distance(behind) > distance(before) {
            behind
        } else {
            before
        })
    }

    /// Top and bottom of the whole ellipse, in 1/256 pixel.
    pub(crate) fn ends_in_y(&self) -> [i32; 2] {
        let ([_, y], [_, down]) = (self.center, self.radii);
        [y - down as i32, y + down as i32]
    }

    /// The most edges in a row of pixels of a part of the arc that is monotone in y and has so many edges: less than two
    /// pixels from an end of the ellipse in y, and elsewhere. Upper bounds.
    pub(crate) fn most_edges_in_a_row(&self, edges: u16) -> [u16; 2] {
        let [_, down] = self.radii;
        let quarter = u64::from(self.chords_of_quarter);
        // x edges below the top the ellipse is r (1 - cos(x pi / 2q)) down, at least 0.916 r (x pi / 2q)^2 / 2 as long as
        // that angle is below 1: a distance h is passed after at most q sqrt(0.885 h / r) edges. More than two pixels from
        // the end, the number in a row is at most 1.16 times its derivative there. The factors leave room for the rounding
        // of angles. The further from the end, the fewer edges a row has: none has more than the one at the end.
        let edges_to = |height: u64, factor: u64| {
            let square = quarter * quarter * height * factor / 1_024;
            square.checked_div(down.into()).map_or(u64::MAX, u64::isqrt)
        };
        let at_most = |bound: u64| bound.min(edges.into()) as u16;
        let near = if down < 600 { u64::MAX } else { edges_to(256, 980) + 2 };
        let elsewhere = if down < 1_100 {
            near
        } else {
            edges_to(512, 1_130) / 4 + 2
        };
        [at_most(near), at_most(elsewhere)]
    }
}

/// The cosine and the sine of an angle in [`TURN`]ths of a turn, in 2.30 fixed point: straight lines between those that
/// are 1/65,536 of a turn apart, less than 2^-29 off.
pub(crate) fn direction(angle: i32) -> [i32; 2] {
    // Angles are modulo a whole turn.
    [sine_of(angle + TURN / 4), sine_of(angle)]
}

/// The sine of an angle, as [`direction`] gives it.
fn sine_of(angle: i32) -> i32 {
    let low = angle & ((1 << MORE_BITS) - 1);
    let at = |steps: i32| sine(U0F16::from_bits(((angle >> MORE_BITS) + steps) as u16)).to_bits();
    let first = at(0);
    if low == 0 {
        return first;
    }
    first + (((at(1) - first) * low + (1 << (MORE_BITS - 1))) >> MORE_BITS)
}

/// A length, in any unit below 2^31, times a number in 2.30 fixed point.
pub(crate) fn scaled(length: u32, factor: i32) -> i32 {
    // The factor is at most 1.
    round_products(i64::from(length) * i64::from(factor)) as i32
}

/// A product with a number in 2.30 fixed point, or a sum of such products, rounded to the nearest whole number; ties upwards.
pub(crate) const fn round_products(sum: i64) -> i64 {
    (sum + (1 << 29)) >> 30
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
        // From the top on, so that the contour has two chains in y.
        Ok(Self::new(&[OutlineArc::new(center, radii, (3 * (TURN / 4), TURN))?]))
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

    pub(crate) fn arcs(&self) -> &[OutlineArc] {
        self.arcs.get(..self.count).unwrap_or_default()
    }

    pub(crate) fn corners(&self) -> u16 {
        self.arcs().iter().map(OutlineArc::corners).sum()
    }

    fn corner(&self, index: u16) -> Corner {
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
    pub(crate) fn corners(&self, contour: usize) -> u16 {
        self.contour(contour).map_or(0, RoundContour::corners)
    }

    /// A corner of a contour by its index, in 1/256 pixel. Those in the order of their indices are the contour.
    pub(crate) fn corner(&self, contour: usize, index: u16) -> Corner {
        self.contour(contour)
            .map_or(Corner::default(), |contour| contour.corner(index))
    }

    pub(crate) fn contour(&self, contour: usize) -> Option<&RoundContour> {
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

    /// Neither its start nor its other corners move where an arc grows at its end.
    #[test]
    fn an_arc_that_grows_keeps_its_corners() {
        for start in [0, 7_654_321, TURN - 1] {
            let arc = |sweep| OutlineArc::new(CENTER, [20_000, 15_000], (start, sweep)).unwrap();
            let all = |arc: &OutlineArc| {
                (0..arc.corners())
                    .map(|index| arc.corner(index))
                    .collect::<Vec<Corner>>()
            };
            let long = all(&arc(TURN - 1));
            for sweep in (1..TURN).step_by(300_007) {
                let short = all(&arc(sweep));
                let common = short.len() - 1;
                assert_eq!(short[..common], long[..common]);
                let mut backwards = all(&OutlineArc::new(CENTER, [20_000, 15_000], (start + sweep, -sweep)).unwrap());
                backwards.reverse();
                assert_eq!(short, backwards);
            }
        }
    }

    /// All corners between two turns are in monotone order, and no more of them are in a row of pixels than is promised.
    #[test]
    fn turns_are_all_turns_and_rows_have_no_more_edges_than_promised() {
        for radii in [
            [0, 90],
            [90, 0],
            [40, 40],
            [600, 600],
            [700, 700],
            [900, 1_024],
            [30_000, 1_099],
            [20_000, 30],
            [20_000, 1_200],
            [300, 30_000],
            [90_000, 90_000],
        ] {
            for (start, sweep) in [
                (3 * TURN / 4, TURN),
                (0, TURN),
                (5_000_000, TURN / 2),
                (9, 77),
                (TURN - 5, -TURN + 99),
            ] {
                let arc = OutlineArc::new(CENTER, radii, (start, sweep)).unwrap();
                for axis in [Axis::X, Axis::Y] {
                    let mut turns = Vec::new();
                    arc.turns(axis, &mut |index| turns.push(index));
                    assert!(turns.is_sorted() && turns.len() <= 4, "{turns:?}");
                    assert_eq!((turns[0], *turns.last().unwrap()), (0, arc.corners() - 1));
                    for part in turns.windows(2) {
                        let along: Vec<i32> = (part[0]..=part[1])
                            .map(|index| arc.corner(index)[axis as usize])
                            .collect();
                        assert!(
                            along.is_sorted() || along.iter().rev().is_sorted(),
                            "{radii:?}, {start}: {along:?}"
                        );
                        if axis == Axis::Y {
                            rows_keep_the_promise(&arc, &along);
                        }
                    }
                }
            }
        }
    }

    /// Counts the edges in each row of a part that is monotone in y.
    fn rows_keep_the_promise(arc: &OutlineArc, ys: &[i32]) {
        let edges = ys.len() as u16 - 1;
        let ([near, elsewhere], [top, bottom]) = (arc.most_edges_in_a_row(edges), arc.ends_in_y());
        let (first, last) = (ys.iter().min().unwrap() >> 8, ys.iter().max().unwrap() >> 8);
        for row in first..=last {
            let (row_top, row_bottom) = (row << 8, (row + 1) << 8);
            let lies_in_row = |pair: &&[i32]| {
                let (upper, lower) = (pair[0].min(pair[1]), pair[0].max(pair[1]));
                upper < lower && upper < row_bottom && row_top < lower
            };
            let count = ys.windows(2).filter(lies_in_row).count();
            let is_near = row_top - top < 512 || bottom - row_bottom < 512;
            let most = if is_near { near } else { elsewhere };
            assert!(
                count <= usize::from(most),
                "{arc:?}, row {row}: {count} edges, {most} promised"
            );
        }
    }

    #[test]
    fn what_leaves_the_domain_is_an_error() {
        let end = i64::from(Sub8::MAX_UNITS);
        assert!(OutlineArc::new([end - 256, 0], [256, 9], (0, TURN)).is_ok());
        assert!(OutlineArc::new([end - 256, 0], [257, 9], (0, TURN)).is_err());
        assert!(OutlineArc::new([0, i64::MIN], [9, 9], (0, TURN)).is_err());
    }
}
