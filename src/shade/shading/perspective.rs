//! Attributes that vary evenly in space, and so not on the screen: they are divided by the depth.
//!
//! What varies evenly on the screen is an attribute times 1/w, and 1/w itself, which the stored depth is. So a face keeps the
//! planes of attribute times depth, and the attribute is the quotient of two planes:
//!
//! ```text
//!     u(x, y) = (u * d)(x, y) / d(x, y)         exact at the first and the last pixel of a span and where the column
//!                                               is a multiple of 16 (or of 1 to 8), and evenly in between
//! ```
//!
//! Where a face's depths and attributes differ so little that their own planes are within the tolerance everywhere, those are
//! kept, and nothing is divided. By how much they miss is the covariance of attribute and depth, divided by the depth. With the
//! barycentric coordinates a, b, c of a pixel as weights it is
//!
//! ```text
//!     a b (ua - ub)(da - db) + b c (ub - uc)(db - dc) + c a (uc - ua)(dc - da)
//! ```
//!
//! and at most a quarter of the greatest of the three products of differences. Where two of them have one sign, a b + b c =
//! b (1 - b) at most is a quarter. Where all three have, the corners come in one order, or in opposite ones, by attribute and
//! by depth, so that one product is that of both ranges, and no covariance is more than a quarter of that.
//!
//! Source: Heckbert and Moreton (1991), "Interpolation for polygon texture mapping and shading"; a division every 16 pixels as
//! in Abrash (1997), "Graphics programming black book", chapter 68.

use core::num::Wrapping;

use crate::{
    clip::convex::CutAttributes,
    geometry::{ScreenPlane, leading_zeros, multiply_shift, reciprocal_32},
    shade::{
        InstructionSet,
        shading::attributes::{AttributeInstructions, Attributes, PlaneSource, Planes, Run, clamp},
    },
};

/// Attributes that vary evenly in space: `N` 16-bit numbers a vertex, divided by the depth at every 16th pixel of a span at
/// least, or at every `STEP`th: 1, 2, 4, 8 or 16.
///
/// Between divisions numbers step evenly. Over a span of 128 pixels of which one end is twice as far away as the other they are
/// off by up to 1/150 of what they change by where `STEP` is 16, by 1/550 where it is 8, and by nothing where it is 1; over one
/// of 32 pixels by up to 1/14 and 1/42. On a Cortex-M4 a large face takes a quarter more cycles with 8 and 4.8 times as many
/// with 1.
///
/// At a pixel they are not rounded: the 16 fractional bits are those of the number. Where a face's depths differ by up to 100
/// times, numbers over a range of 4,096 are within one unit where they are divided. Numbers within 8 units of the ends of `i16`
/// may wrap.
///
/// Memory: 2 bytes a number for each vertex (none for the texture coordinates of the library's shadings, where no face is cut),
/// 14 a number and 2 for each active face.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Perspective<const N: usize, const STEP: i32 = 16>(pub [i16; N]);

// Not re-exported: what a face keeps of its attributes is the library's own.
/// What a face keeps of attributes in perspective.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PerspectivePlanes<const N: usize> {
    /// The planes of attributes, or of their differences from the base times the depth, divided by a power of two.
    planes: [ScreenPlane; N],
    /// The attributes of one corner.
    base: [i16; N],
    /// The exponent of that power of two; `None` where the planes are those of the attributes.
    exponent: Option<u8>,
}

impl<const N: usize, const STEP: i32> Attributes for Perspective<N, STEP> {
    const ZERO: Self = Self([0; N]);
}

impl<const N: usize, const STEP: i32> CutAttributes for Perspective<N, STEP> {
    const NEED_DEPTH: bool = true;

    fn between(from: &Self, to: &Self, [part, rest]: [u64; 2], [depth_from, depth_to]: [u64; 2]) -> Self {
        // On the screen each end has the weight of its depth.
        let ways = [part * depth_to, rest * depth_from];
        Self(CutAttributes::between(&from.0, &to.0, ways, [1; 2]))
    }
}

impl<const N: usize, const STEP: i32> Planes for Perspective<N, STEP> {
    type Values = [i32; N];
    type Planes = PerspectivePlanes<N>;
    type Dividends = [Wrapping<u32>; N];
    type Tolerance = u16;
    type Others = Self;
    const EXACT: u16 = 0;
    const VARY: bool = true;
    const STEP: i32 = {
        assert!(
            matches!(STEP, 1 | 2 | 4 | 8 | 16),
            "a division at every 1st, 2nd, 4th, 8th or 16th pixel"
        );
        STEP
    };
    const NO_PLANES: PerspectivePlanes<N> = PerspectivePlanes {
        planes: [ScreenPlane::ZERO; N],
        base: [0; N],
        exponent: None,
    };
    const NO_OTHERS: Self = Self::ZERO;

    #[inline]
    fn others(self) -> Self {
        self
    }

    #[inline]
    fn with_others(others: Self, _: &impl Fn() -> Self) -> Self {
        others
    }

    #[inline]
    fn instructions(set: InstructionSet) -> AttributeInstructions {
        let (number, parts) = (N as u32, 16 / STEP.clamp(1, 16) as u32);
        AttributeInstructions {
            face: set.of([190, 96]) + number * set.of([233, 73]),
            span: number * set.of([3, 9]),
            pixel: number * set.of([4, 2]),
            divided: [
                set.of([900, 100]) + number * set.of([467, 50]),
                set.of([167, 126]) + number * set.of([100, 45]),
                parts * (set.of([2, 0]) + number * set.of([6, 1])),
            ],
        }
    }

    #[inline]
    fn are_nearly_even([a, b, c]: [&Self; 3], depths: [u32; 3], tolerance: u16) -> bool {
        is_nearly_even([&a.0, &b.0, &c.0], depths, tolerance)
    }

    fn set_up(set_up: &mut PerspectivePlanes<N>, [a, b, c]: [&Self; 3], face: &impl PlaneSource, tolerance: u16) {
        let corners = [&a.0, &b.0, &c.0];
        let depths = face.depths();
        let mut numbers = [[0; 3]; N];
        if is_nearly_even(corners, depths, tolerance) {
            set_up.exponent = None;
            for (numbers, values) in numbers.iter_mut().zip(by_attribute(corners)) {
                *numbers = values.map(i32::from);
            }
        } else {
            set_up.base = *odd_one_out(corners, depths);
            let exponent = multiply(&mut numbers, corners, &set_up.base, depths);
            set_up.exponent = Some(exponent as u8);
        }
        for (plane, numbers) in set_up.planes.iter_mut().zip(numbers) {
            *plane = face.plane(numbers);
        }
    }

    #[inline]
    fn are_even(planes: &PerspectivePlanes<N>) -> bool {
        planes.exponent.is_none()
    }

    #[inline(always)]
    fn even_run(planes: &PerspectivePlanes<N>, column: i32, end: i32, row: i32) -> Run<[i32; N]> {
        <[i16; N]>::even_run(&planes.planes, column, end, row)
    }

    #[inline(always)]
    fn dividends(planes: &PerspectivePlanes<N>, column: i32, row: i32) -> [Wrapping<u32>; N] {
        planes.planes.map(|plane| plane.at(column, row))
    }

    #[inline]
    fn divided(
        planes: &PerspectivePlanes<N>,
        dividends: &[Wrapping<u32>; N],
        depth: Wrapping<u32>,
        _: [i32; 2],
    ) -> [i32; N] {
        quotients(planes, dividends, depth)
    }

    #[inline]
    fn divided_run(
        planes: &PerspectivePlanes<N>,
        dividends: &mut [Wrapping<u32>; N],
        values: &[i32; N],
        columns: i32,
        depth: Wrapping<u32>,
    ) -> [[i32; N]; 2] {
        for (dividend, plane) in dividends.iter_mut().zip(&planes.planes) {
            *dividend += plane.per_column * Wrapping(columns as u32);
        }
        let there = quotients(planes, dividends, depth);
        let mut per_column = [0; N];
        for (gain, (from, to)) in per_column.iter_mut().zip(values.iter().zip(there)) {
            *gain = part_of((to >> 1) - (from >> 1), columns);
        }
        [per_column, there]
    }

    #[inline(always)]
    fn step(values: &mut [i32; N], per_column: &[i32; N]) {
        <[i16; N]>::step(values, per_column);
    }

    #[inline(always)]
    fn step_by(values: &mut [i32; N], per_column: &[i32; N], columns: i32) {
        <[i16; N]>::step_by(values, per_column, columns);
    }

    fn clamp(values: &mut [i32; N], [a, b, c]: [&Self; 3]) {
        clamp(values, [&a.0, &b.0, &c.0], 0);
    }
}

/// The values of each attribute at three corners.
fn by_attribute<const N: usize>([a, b, c]: [&[i16; N]; 3]) -> impl Iterator<Item = [i16; 3]> {
    a.iter().zip(b).zip(c).map(|((a, b), c)| [*a, *b, *c])
}

/// Sets the differences of attributes from the base times the depth, divided by a power of two so that they have 15 bits.
/// Returns the exponent of that power.
#[inline(always)]
fn multiply<const N: usize>(
    numbers: &mut [[i32; 3]; N],
    corners: [&[i16; N]; 3],
    base: &[i16; N],
    depths: [u32; 3],
) -> u32 {
    let mut products = [[0; 3]; N];
    // Has as many leading zeros as the greatest product.
    let mut bits = 0;
    for (products, (values, base)) in products.iter_mut().zip(by_attribute(corners).zip(base)) {
        for (product, (value, depth)) in products.iter_mut().zip(values.iter().zip(&depths)) {
            *product = (i64::from(*value) - i64::from(*base)) * i64::from(*depth);
            bits |= product.unsigned_abs();
        }
    }
    let exponent = 49u32.saturating_sub(bits.leading_zeros());
    for (number, product) in numbers.as_flattened_mut().iter_mut().zip(products.as_flattened()) {
        let rounded = (product + ((1 << exponent) >> 1)) >> exponent;
        // Not -2^15, past which the error of a gradient would wrap.
        *number = rounded.clamp(-0x7fff, 0x7fff) as i32;
    }
    exponent
}

/// The attributes of the corner from which the others are counted: the farthest or the nearest one, whose depth is farther from
/// that of the corner in the middle, as a ratio. So the products with the depths of the two others have about as many digits.
fn odd_one_out<const N: usize>([a, b, c]: [&[i16; N]; 3], [depth_a, depth_b, depth_c]: [u32; 3]) -> &[i16; N] {
    let (least, most) = (depth_a.min(depth_b).min(depth_c), depth_a.max(depth_b).max(depth_c));
    let middle = u64::from(depth_a ^ depth_b ^ depth_c ^ least ^ most);
    let is_farthest = middle * middle > u64::from(least) * u64::from(most);
    match if is_farthest { least } else { most } {
        depth if depth == depth_a => a,
        depth if depth == depth_b => b,
        _ => c,
    }
}

/// Whether attributes are within a tolerance of being even on the screen: whether for each two corners the product of the
/// differences of attribute and depth is.
fn is_nearly_even<const N: usize>([a, b, c]: [&[i16; N]; 3], [d1, d2, d3]: [u32; 3], tolerance: u16) -> bool {
    let least = d1.min(d2).min(d3);
    // Below 2^50.
    let most = 4 * u64::from(tolerance) * u64::from(least);
    // Most faces are far from the limit. The bits of a negative difference are those of one less, and between the two other
    // corners a difference may be twice as great.
    let size = |from: i16, to: i16| {
        let difference = i32::from(to) - i32::from(from);
        (difference ^ (difference >> 31)) as u32
    };
    let corners = a.iter().zip(b).zip(c);
    let bits = corners.fold(0, |bits, ((a, b), c)| bits | size(*a, *b) | size(*a, *c));
    // Below 2^18 and 2^32.
    if u64::from(2 * (bits + 1)) * u64::from(d1.max(d2).max(d3) - least) <= most {
        return true;
    }
    let corners = [(a, d1), (b, d2), (c, d3)];
    let before = [(c, d3), (a, d1), (b, d2)];
    corners.iter().zip(&before).all(|((one, depth), (other, other_depth))| {
        let greatest = one
            .iter()
            .zip(other.iter())
            .fold(0, |greatest, (one, other)| one.abs_diff(*other).max(greatest));
        // Below 2^16 and 2^32.
        u64::from(greatest) * u64::from(depth.abs_diff(*other_depth)) <= most
    })
}

/// The attributes of a pixel from their dividends and its depth, with 16 fractional bits.
fn quotients<const N: usize>(
    planes: &PerspectivePlanes<N>,
    dividends: &[Wrapping<u32>; N],
    depth: Wrapping<u32>,
) -> [i32; N] {
    let exponent = planes.exponent.map_or(0, u32::from);
    // A face's depth is not 0 at its pixels, but so that the shift is no overflow.
    let depth = depth.0.max(1);
    let zeros = leading_zeros(depth);
    let reciprocal = reciprocal_32(depth << zeros);
    // product / 2^62, times 2^(exponent + zeros): of the product, the upper 32 bits.
    let shift = 30 - (exponent + zeros) as i32;
    let mut values = [0; N];
    for (value, (dividend, base)) in values.iter_mut().zip(dividends.iter().zip(planes.base)) {
        let product = multiply_shift(dividend.0 as i32, reciprocal, 32);
        let quotient = if shift >= 0 {
            product >> (shift & 31)
        } else {
            product << (-shift & 31)
        };
        *value = (Wrapping(i32::from(base) << 16) + Wrapping(quotient)).0;
    }
    values
}

/// A change divided by 1 to 16 pixels, from half of it, which fits.
#[inline]
fn part_of(half: i32, pixels: i32) -> i32 {
    if pixels == 16 {
        return half >> 3;
    }
    match PARTS.get(pixels as usize) {
        Some(part) => multiply_shift(half, *part, 15),
        None => half << 1,
    }
}

/// 65,536 divided by the index, rounded; for 0 whatever.
const PARTS: [i32; 16] = [
    65_536, 65_536, 32_768, 21_845, 16_384, 13_107, 10_923, 9_362, 8_192, 7_282, 6_554, 5_958, 5_461, 5_041, 4_681,
    4_369,
];
