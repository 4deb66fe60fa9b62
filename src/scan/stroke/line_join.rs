//! The corners of a stroke.
//!
//! Guarantees: what lies between the rectangles along two segments, at the outer side of the corner. Tips are rounded to
//! 1/65,536 pixel; those further than four half widths from the corner lie within 2^-22 of their distance. A tip further
//! than 8,192 pixels from its corner is beyond any limit. Source: the joins of PostScript (Adobe 1985); the tip by Cramer's
//! rule from both segments, well conditioned where the corner is sharp. Cost: four divisions a tip.

use core::num::NonZeroU64;

use fixed::types::U8F8;

use crate::geometry::quotient_nearest;
use crate::scan::stroke::wide_stroke::{Direction, Position, Segment, UNIT, cross, is_between, miter_tip};

/// The furthest that a tip lies from its corner, along either axis.
const FURTHEST_TIP: i64 = 8_192 * UNIT;
/// The greatest distance of a tip from a corner that is not sharp, in half widths.
const BLUNT: i64 = 4;

/// How a stroke turns a corner.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*, primitives::Polyline};
/// use zrow::draw::{LineJoin, StrokeStyle};
///
/// // A corner at (2, 2), five pixels wide: joins differ in its first two rows.
/// let corner = [Point::new(2, 5), Point::new(2, 2), Point::new(5, 2)];
/// for (join, [first, second]) in [
///     (LineJoin::MITER, ["######", "######"]),
///     (LineJoin::Bevel, ["  ####", " #####"]),
///     (LineJoin::Round, [" #####", "######"]),
/// ] {
///     let mut display = MockDisplay::new();
///     Polyline::new(&corner).into_styled(StrokeStyle::new(BinaryColor::On, 5).join(join)).draw(&mut display)?;
///     display.assert_pattern(&[first, second, "######", "######", "######", "##### "]);
/// }
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
pub enum LineJoin {
    /// The outer sides go on until they meet in a tip. A corner whose tip is further away from it than `limit` half widths
    /// is bevelled: the limit is the ratio of PostScript and SVG, 1 / sin of half the angle between the segments. Below 1
    /// it bevels every corner.
    Miter {
        /// The largest ratio that has a tip.
        limit: U8F8,
    },
    /// A straight line between the outer corners.
    Bevel,
    /// A disc about the corner, as wide as the stroke.
    Round,
}

impl LineJoin {
    /// The miter join of this library's wide strokes, and of embedded-graphics: limit 4, corners sharper than 29 degrees
    /// are bevelled.
    pub const MITER: Self = Self::Miter {
        limit: U8F8::from_bits(4 << 8),
    };

    /// The largest distance from a corner at which this join has a pixel, from the stroke's half width, in its units.
    pub(crate) fn reach(self, half_width: i64) -> i64 {
        match self {
            Self::Miter { limit } => longest_tip(limit, half_width).max(half_width),
            Self::Bevel | Self::Round => half_width,
        }
    }

    /// Whether this join bevels a right angle, whose tip is the square root of 2 half widths away from the corner.
    pub(crate) fn bevels_right_angles(self, half_width: i64) -> bool {
        match self {
            Self::Miter { limit } => longest_tip(limit, half_width).pow(2) < 2 * half_width.pow(2),
            Self::Bevel => true,
            Self::Round => false,
        }
    }

    /// The tip in which two segments' outer sides meet, relative to their corner; `None` where the corner is not mitered.
    /// `one` and `other` are the outer corners of the segments' rectangles, relative to that corner too.
    pub(crate) fn tip(
        self,
        (before, after): (&Segment, &Segment),
        (one, other): (Position, Position),
        half_width: i64,
    ) -> Option<Position> {
        let Self::Miter { limit } = self else { return None };
        let blunt = miter_tip(one, other, half_width);
        let longest = longest_tip(limit, half_width);
        if longest >= BLUNT * half_width && blunt.is_some() {
            return blunt;
        }
        let is_sharp = one.0 * other.0 + one.1 * other.1 < 0;
        let tip = match blunt {
            Some(tip) => tip,
            None if longest > BLUNT * half_width && is_sharp => {
                sharp_tip(before.direction(), after.direction(), half_width)?
            }
            None => return None,
        };
        let is_near = tip.0.abs() <= FURTHEST_TIP && tip.1.abs() <= FURTHEST_TIP;
        let is_within_limit = is_near && tip.0 * tip.0 + tip.1 * tip.1 <= longest * longest;
        (is_within_limit && is_between(tip, one, other)).then_some(tip)
    }
}

impl Default for LineJoin {
    fn default() -> Self {
        Self::MITER
    }
}

/// The largest distance from a corner to its tip under a miter limit, in the unit of the half width.
fn longest_tip(limit: U8F8, half_width: i64) -> i64 {
    ((i64::from(limit.to_bits()) * half_width) >> 8).min(FURTHEST_TIP)
}

/// The point in which the outer sides of a sharp corner meet, relative to the corner; `None` where both run along one line.
///
/// With the unit vectors u and v along the segments: half_width * (u - v) / |u x v|.
pub(crate) fn sharp_tip(before: Direction, after: Direction, half_width: i64) -> Option<Position> {
    const UNIT_BITS: u32 = 30;
    let unit = |component: i64, length: NonZeroU64| quotient_nearest(component << UNIT_BITS, length);
    // Components have 30 bits, lengths 31: the products fit.
    let sine = cross((before.x, before.y), (after.x, after.y)).abs();
    // Both lengths are 2^29 or more.
    let product = NonZeroU64::new((before.length.get() * after.length.get()) >> UNIT_BITS)?;
    let sine = NonZeroU64::new(quotient_nearest(sine, product) as u64)?;
    let component = |before_part: i64, after_part: i64| {
        let difference = unit(before_part, before.length) - unit(after_part, after.length);
        quotient_nearest(half_width * difference, sine)
    };
    Some((component(before.x, after.x), component(before.y, after.y)))
}

#[cfg(feature = "defmt")]
impl defmt::Format for LineJoin {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        match self {
            Self::Miter { limit } => defmt::write!(formatter, "Miter up to {}/256", limit.to_bits()),
            Self::Bevel => defmt::write!(formatter, "Bevel"),
            Self::Round => defmt::write!(formatter, "Round"),
        }
    }
}
