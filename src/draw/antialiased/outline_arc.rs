//! Elliptical arcs, kept as parameters: any corner is computed by its index.
//!
//! Guarantees: corners lie on the curve, rounded to 1/256 pixel, and no chord between two of them is further than 1/64
//! pixel from it. Cost: a sine and a cosine for each corner.

use core::num::{NonZeroU16, NonZeroU32};

use crate::{
    draw::antialiased::turn::{MORE_BITS, QUARTER_BITS, TURN, TURN_BITS, direction, edges_of_turn, scaled, sine_of},
    geometry::{InputError, Sub8, SubPixel, Window},
};

/// A corner of an outline: x and y in 1/256 pixel.
pub(crate) type Corner = [i32; 2];

/// A position in 1/256 pixel, as far from the origin as a shape of embedded-graphics can be.
pub(crate) type WidePosition = [i64; 2];

/// The angle of the top of an ellipse, in [`TURN`]ths of a turn.
pub(super) const TOP: i32 = 3 * (TURN / 4);

/// The most chords of a quarter of an ellipse that are mirrored: those of a radius of 207 pixels, whose corners are nearer than
/// 2^16 to the centre, in 1/256 pixel.
const MOST_MIRRORED: usize = 64;

/// An arc of an ellipse, as its corners.
///
/// The corners between the first and the last one lie at fixed angles from where the arc begins clockwise: an arc that grows
/// at its end keeps all of them.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutlineArc {
    /// The centre of the ellipse, in 1/256 pixel.
    pub(super) center: Corner,
    /// The horizontal and the vertical radius, in 1/256 pixel.
    pub(super) radii: [u32; 2],
    /// The angle at which the arc begins clockwise, in [`TURN`]ths of a turn.
    pub(super) start: i32,
    /// The angle from there to its other end clockwise, in [`TURN`]ths of a turn.
    pub(super) sweep: i32,
    /// Whether the corners run from that other end counterclockwise.
    pub(super) is_reversed: bool,
    /// The number of chords that a quarter of a turn has.
    pub(super) chords_of_quarter: u16,
    /// The number of chords.
    pub(super) chords: u16,
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
    pub(super) fn reversed(self) -> Self {
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
    pub(super) fn angle_of(&self, number: u16) -> i32 {
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
    pub(super) fn number_of(&self, index: u16) -> u16 {
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

    /// The sum of a column and its mirror image about the vertical axis of a whole ellipse from its top on, where the axis lies
    /// in the middle or at a side of pixels.
    pub(super) fn mirror(&self) -> Option<i32> {
        /// Bits of the distance from the middle of a pixel to its side.
        const HALF_BITS: u32 = Sub8::FRACTION_BITS - 1;
        let [x, _] = self.center;
        let is_whole = self.sweep == TURN && self.start == TOP && self.chords_of_quarter != 0;
        (is_whole && x & ((1 << HALF_BITS) - 1) == 0).then_some(x >> HALF_BITS)
    }

    /// Calls `edge` with the edges of a whole ellipse from its top on, between corners of which those of a quarter are computed
    /// and the others mirrored. Returns `false`, and does nothing, for any other arc, and where a quarter has more than
    /// [`MOST_MIRRORED`] chords. With `left_half` only those left of the centre of an ellipse that runs clockwise.
    pub(super) fn mirrored_edges(&self, left_half: bool, edge: &mut dyn FnMut(Corner, Corner)) -> bool {
        let chords = usize::from(self.chords_of_quarter);
        let is_whole = self.sweep == TURN && self.start == TOP;
        if !is_whole || chords == 0 || chords > MOST_MIRRORED {
            return false;
        }
        // How far right of the centre and above it the corners lie, from the top to the right.
        let mut quarter = [[0u16; 2]; MOST_MIRRORED + 1];
        let ([x, y], [across, down]) = (self.center, self.radii);
        for (number, corner) in quarter.iter_mut().take(chords + 1).enumerate() {
            // The sine and the cosine of the angle from the top are the cosine and, upwards, the sine of the angle.
            let [cosine, sine] = direction(self.angle_of(number as u16));
            *corner = [scaled(across, cosine) as u16, scaled(down, -sine) as u16];
        }
        let forward = if self.is_reversed { -1 } else { 1 };
        let (mut from, skipped) = if left_half {
            ([x, y + down as i32], 2)
        } else {
            ([x, y - down as i32], 0)
        };
        for [to_right, downwards] in [[1, -1], [1, 1], [-1, 1], [-1, -1]].into_iter().skip(skipped) {
            for step in 1..=chords {
                let number = if to_right == downwards { chords - step } else { step };
                let [across, along] = quarter.get(number).map_or([0; 2], |corner| corner.map(i32::from));
                let to = [x + forward * to_right * across, y + downwards * along];
                edge(from, to);
                from = to;
            }
        }
        true
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
        (arc, Self::position_in(chords))
    }

    /// The position of the first corner, from the last word of an arc.
    pub(crate) const fn position_in(word: u32) -> u16 {
        (word >> 16) as u16
    }
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

    /// The edges of circles and ellipses, and of those that run counterclockwise, as holes do.
    #[test]
    fn mirrored_edges_are_those_between_corners_computed_one_by_one() {
        let mut mirrored_ellipses = 0;
        for longest in (0..=60_000).step_by(37) {
            for radii in [[longest; 2], [longest, longest / 3], [longest / 7, longest]] {
                let ellipse = OutlineArc::new(CENTER, radii, (TOP, TURN)).unwrap();
                for ellipse in [ellipse, ellipse.reversed()] {
                    let mut mirrored = Vec::new();
                    if ellipse.mirrored_edges(false, &mut |from, to| mirrored.push([from, to])) {
                        let corner = |index: u16| ellipse.corner(index % ellipse.corners());
                        let edges = (0..ellipse.corners()).map(|index| [corner(index), corner(index + 1)]);
                        assert!(edges.eq(mirrored), "{radii:?}");
                        mirrored_ellipses += 1;
                    }
                }
            }
        }
        assert!(mirrored_ellipses > 8_000, "{mirrored_ellipses}");
        // Neither is a turn that begins elsewhere, nor a part of one.
        for angles in [(0, TURN), (TOP, TURN - 1)] {
            let arc = OutlineArc::new(CENTER, [900; 2], angles).unwrap();
            assert!(!arc.mirrored_edges(false, &mut |_, _| ()));
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

    #[test]
    fn what_leaves_the_domain_is_an_error() {
        let end = i64::from(Sub8::MAX_UNITS);
        assert!(OutlineArc::new([end - 256, 0], [256, 9], (0, TURN)).is_ok());
        assert!(OutlineArc::new([end - 256, 0], [257, 9], (0, TURN)).is_err());
        assert!(OutlineArc::new([0, i64::MIN], [9, 9], (0, TURN)).is_err());
    }
}
