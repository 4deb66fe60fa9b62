//! The state of the depth test, and how a depth that is compared follows from it.

use core::num::NonZeroU64;

use fixed::types::I16F16;

use crate::{
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{active_face::from_top, depth_test::comparison::Comparison, sides::Sides},
};

/// How pixels are tested against the depths of a row, for depths `D`: `u16`, or `u32` where a look is
/// [`Deep`](crate::scene::Deep).
///
/// The depth that is compared, and stored, is that of the pixel mapped to the [`range`](Self::range), plus the
/// [`offset`](Self::offset), at the end of the range where it would lie beyond. Where it is mapped or offset it is never 0, to
/// which rows are cleared. The [default](Self::NEARER) is what scenes are drawn with: what is nearer is drawn, of what is equally
/// near the first stays.
///
/// Source: `glDepthFunc`, `glDepthMask`, `glPolygonOffset` and `glDepthRange` of OpenGL 1.1 (Segal and Akeley 1997). There an
/// offset may lead out of the range; here what is drawn in one part of the depths never gets into another one.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DepthState<D> {
    /// When a pixel is drawn: what is nearer has the larger depth. `glDepthFunc`.
    pub comparison: Comparison,
    /// Whether the depths of drawn pixels are stored. `glDepthMask`.
    pub writes: bool,
    /// What is added to depths. `glPolygonOffset`.
    pub offset: PolygonOffset,
    /// The depths to which the smallest and the greatest depth are mapped, [`FARTHEST`](DepthWidth::FARTHEST) and
    /// [`NEAREST`](DepthWidth::NEAREST); those in between evenly, to the nearest one. Where the first is the larger one, what
    /// was near is far. `glDepthRange`.
    pub range: [D; 2],
}

/// What is added to the depth of a pixel: `factor * m + units * r`, rounded to the nearest depth that can be stored, halves
/// up.
///
/// `m` is the greatest slope of the depth, per column or per row, after the depth was mapped to its range: that of the face,
/// for an edge that of the steeper one of the faces beside it that are seen, for a
/// [`DepthLine`](crate::visible::DepthLine) of a program's own that along the line, and 0 for what has a constant depth, as a point or a text. It
/// counts as the whole range of depths a pixel at most. `r` is a unit of depth: 1 for depths of 16 bits, 256 for those of 32,
/// whose lowest 8 bits are a fraction.
///
/// **Positive is nearer**, because what is nearer has the larger depth: the signs are those of OpenGL exchanged. With
/// [`WIREFRAME`](Self::WIREFRAME) an edge is seen over the faces beside it.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PolygonOffset {
    /// How many slopes are added.
    #[cfg_attr(feature = "defmt", defmt(Display2Format))]
    pub factor: I16F16,
    /// How many units are added.
    pub units: i32,
}

impl PolygonOffset {
    /// Nothing is added.
    pub const NONE: Self = Self {
        factor: I16F16::ZERO,
        units: 0,
    };

    /// Brings an edge in front of the faces beside it. A pixel of a line is at most half a pixel along the line and a pixel
    /// across it away from where the edge has the pixel's depth: 3/2 slopes. Two units cover what is rounded, in pictures with
    /// depths of 32 bits up to 500 columns and rows together; each 500 more need another one.
    pub const WIREFRAME: Self = Self {
        factor: I16F16::lit("1.5"),
        units: 2,
    };
}

impl<D: DepthWidth> DepthState<D> {
    /// What is nearer is drawn, and its depth stored as it is; of what is equally near the first stays.
    pub const NEARER: Self = Self {
        comparison: Comparison::Greater,
        writes: true,
        offset: PolygonOffset::NONE,
        range: [D::FARTHEST, D::NEAREST],
    };
}

impl<D: DepthWidth> Default for DepthState<D> {
    fn default() -> Self {
        Self::NEARER
    }
}

/// What decides whether a pixel is drawn at a depth, and whether that is stored.
pub(in crate::visible) trait Test<D>: Copy {
    /// Whether a pixel is drawn at a depth, where another one is stored.
    fn passes(&self, depth: D, stored: D) -> bool;
    /// Whether the depth of a pixel that is drawn is stored.
    fn writes(&self) -> bool;
}

/// What is nearer is drawn.
#[derive(Debug, Copy, Clone)]
pub(in crate::visible) struct Nearer;

impl<D: Ord> Test<D> for Nearer {
    #[inline(always)]
    fn passes(&self, depth: D, stored: D) -> bool {
        depth > stored
    }

    #[inline(always)]
    fn writes(&self) -> bool {
        true
    }
}

/// The state of the test for something of a certain slope.
#[derive(Debug, Copy, Clone)]
pub(in crate::visible) struct DepthTest {
    comparison: Comparison,
    writes: bool,
    /// Whether depths are compared as they are.
    is_identity: bool,
    /// What is added to a mapped depth, in steps of stored depths.
    offset: i64,
    /// The depth to which the smallest one is mapped, and what the greatest one gains.
    farthest: i64,
    gain: i64,
}

impl<D: DepthWidth> Test<D> for DepthTest {
    #[inline(always)]
    fn passes(&self, depth: D, stored: D) -> bool {
        self.comparison.passes(depth, stored)
    }

    #[inline(always)]
    fn writes(&self) -> bool {
        self.writes
    }
}

impl DepthTest {
    /// The test for something with a greatest slope, which has the fractional bits of interpolated depths.
    pub(in crate::visible) fn new<D: DepthWidth>(state: &DepthState<D>, slope: u32) -> Self {
        let [farthest, nearest] = state.range.map(|depth| i64::from(depth.into()));
        let gain = nearest - farthest;
        let slope = scaled::<D>(slope, gain.unsigned_abs());
        let offset = steps_of::<D>(state.offset, slope);
        Self {
            comparison: state.comparison,
            writes: state.writes,
            is_identity: offset == 0 && state.range == [D::FARTHEST, D::NEAREST],
            offset,
            farthest,
            gain,
        }
    }

    /// The depth that is compared, for the depth of a pixel.
    #[inline(always)]
    pub(in crate::visible) fn depth<D: DepthWidth>(&self, depth: D) -> D {
        if self.is_identity { depth } else { self.mapped(depth) }
    }

    #[inline(never)]
    fn mapped<D: DepthWidth>(&self, depth: D) -> D {
        let gained = i64::from(evenly::<D>(depth.into(), self.gain.unsigned_abs() as u32));
        let mapped = self.farthest + if self.gain < 0 { -gained } else { gained };
        let nearest = self.farthest + self.gain;
        let (least, greatest) = (self.farthest.min(nearest).max(1), self.farthest.max(nearest).max(1));
        // Depths are below 2^32 and the offset below 2^33.
        let depth = (mapped + self.offset).max(least).min(greatest);
        D::from_interpolated((depth as u32) << (32 - bits::<D>()))
    }
}

/// The bits of a stored depth.
const fn bits<D>() -> u32 {
    8 * size_of::<D>() as u32
}

/// The product of two stored depths, divided by the greatest depth, to the nearest: no halves, because that is odd. In 32 bits
/// where depths have 16.
fn evenly<D: DepthWidth>(one: u32, other: u32) -> u32 {
    // For k * (2^b - 1) + r with k < 2^b the sum is k * 2^b + something below 2^b (Blinn 1994, "Three Wrongs Make a Right").
    // At most 2^2b - 2^(b + 1) + 1 before, and less than 2^(b + 1) are added.
    let half = D::NEAREST.into() >> 1;
    if bits::<D>() == 16 {
        let product = one * other + half;
        (product + 1 + (product >> 16)) >> 16
    } else {
        let product = u64::from(one) * u64::from(other) + u64::from(half);
        ((product + 1 + (product >> 32)) >> 32) as u32
    }
}

/// A slope in a range of depths that has another width than all depths.
fn scaled<D: DepthWidth>(slope: u32, width: u64) -> u32 {
    let whole = D::NEAREST.into();
    if width == u64::from(whole) {
        return slope;
    }
    let all = NonZeroU64::new(whole.into()).unwrap_or(NonZeroU64::MIN);
    // At most (2^32 - 1)^2 + 2^31.
    ((u64::from(slope) * width + u64::from(whole >> 1)) / all) as u32
}

/// An offset in steps of stored depths, to the nearest, halves up; below 2^33 in size.
fn steps_of<D: DepthWidth>(offset: PolygonOffset, slope: u32) -> i64 {
    // The 16 fractional bits of the factor, and those of interpolated depths that are not stored: 16 of 16, and none of 8.
    let fraction = 16 + 32 - bits::<D>();
    // At most 2^63 in size for depths of 16 bits, and less than that for those of 32.
    let units = i64::from(offset.units) << (D::FRACTION_BITS + 16);
    let sum = (i64::from(offset.factor.to_bits()) * i64::from(slope)).saturating_add(units);
    let steps = (sum >> (fraction - 1)).saturating_add(1) >> 1;
    let most = 1 << 32;
    steps.max(-most).min(most)
}

/// The greatest slope of a face, per column or per row, with the fractional bits of interpolated depths, to the nearest; at
/// most that of the whole range of depths a pixel.
pub(crate) fn slope_of_face<S: ScreenPrecision, D: DepthWidth>(corners: [&ScreenVertex<S, D>; 3]) -> u32 {
    let corners = from_top(corners);
    let Sides { right, left, .. } = Sides::of(corners, 0);
    let [top, at_right, at_left] = corners.map(|corner| corner.z.units());
    let (z1, z2) = (at_right - top, at_left - top);
    // Positions below 2^23 and depths below 2^24: a difference of products is below 2^48.
    let difference =
        |a: i32, b: i32, c: i32, d: i32| (i64::from(a) * i64::from(b) - i64::from(c) * i64::from(d)).unsigned_abs();
    let area = difference(right.x, left.y, left.x, right.y);
    let steepest = difference(z1, left.y, z2, right.y).max(difference(right.x, z2, left.x, z1));
    slope::<D>(steepest << S::FRACTION_BITS, area)
}

/// The quotient of a gain of depth and a distance below 2^47, with the fractional bits of interpolated depths, to the nearest; at
/// most that of the whole range of depths a pixel.
fn slope<D: DepthWidth>(gain: u64, distance: u64) -> u32 {
    let distance = NonZeroU64::new(distance).unwrap_or(NonZeroU64::MIN);
    let whole = gain / distance;
    if whole >> (32 - D::FRACTION_BITS) != 0 {
        return u32::MAX;
    }
    let rest = gain % distance;
    let fraction = ((rest << D::FRACTION_BITS) + (distance.get() >> 1)) / distance;
    u32::try_from((whole << D::FRACTION_BITS) + fraction).unwrap_or(u32::MAX)
}
