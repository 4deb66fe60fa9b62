//! The plane of a face's depth: its value and its gradients in 32-bit arithmetic modulo 2^32.
//!
//! A pixel centre inside a face has a depth between those of its corners, which fits. So sums may wrap on the way: what
//! arrives at a covered pixel is right, however steep the gradient of a sliver is, and nothing is clamped.

use core::num::Wrapping;

use crate::{
    geometry::{HAS_DIVIDER, ScreenPlane, Window, divide_long, leading_zeros, multiply_shift, reciprocal_32},
    view::{DepthWidth, Position, ScreenPrecision, ScreenVertex},
    visible::{edge::PixelAfter, sides::Sides},
};

/// The plane of a face's depth, with `D::FRACTION_BITS` fractional bits.
pub(super) type DepthPlane = ScreenPlane;

impl ScreenPlane {
    /// The plane through three corners that run clockwise on the screen (their area is positive), of a small
    /// face; `None` for any other.
    ///
    /// The gradients are rounded once, and then only whole pixels are multiplied, from an anchor that depends on the face
    /// and the viewport alone. With `u16` a pixel's depth is within 1/4 unit of the exact plane before it is rounded,
    /// with `u32` within half as many 1/256 units as the viewport has columns and rows.
    #[inline]
    pub(super) fn small<S: ScreenPrecision, D: DepthWidth>(
        corners: [&ScreenVertex<S, D>; 3],
        sides: &Sides,
        is_short: bool,
    ) -> Option<Self> {
        let is_small = S::FRACTION_BITS <= 4 && D::FRACTION_BITS == 16;
        if !is_small {
            return None;
        }
        let face = SmallFace::new(sides, is_short)?;
        Self::of_small_face(corners, sides, face, || face.reciprocal(is_short))
    }

    /// The plane through three corners of a small face; `None` where it is steep.
    #[inline]
    pub(super) fn of_small_face<S: ScreenPrecision, D: DepthWidth>(
        [a, b, c]: [&ScreenVertex<S, D>; 3],
        sides: &Sides,
        face: SmallFace,
        reciprocal: impl FnOnce() -> Option<AreaReciprocal>,
    ) -> Option<Self> {
        let small = face.gradients([a.z.units(), b.z.units(), c.z.units()], reciprocal)?;
        let origin_to_corner = small.origin_to(sides.top);
        Some(Self {
            origin: rounded::<D>(a.z) - origin_to_corner,
            per_column: Wrapping(small.per_column as u32),
            per_row: Wrapping(small.per_row as u32),
        })
    }

    /// The plane of a face of any size and slope, by long divisions.
    pub(super) fn wide<S: ScreenPrecision, D: DepthWidth>(
        corners: [&ScreenVertex<S, D>; 3],
        viewport: &Window,
        first_column: i32,
    ) -> Self {
        Self::wide_at(corners, &Sides::of(corners, 0), viewport, first_column)
    }

    /// The plane of a face of any size and slope, as the sides are seen that begin at column 0, by long divisions.
    pub(super) fn wide_at<S: ScreenPrecision, D: DepthWidth>(
        corners: [&ScreenVertex<S, D>; 3],
        sides: &Sides,
        viewport: &Window,
        first_column: i32,
    ) -> Self {
        let depths = corners.map(|corner| corner.z.units());
        let mut plane = wide_plane::<S, D>(sides, depths, viewport).with_corner(corners[0].z);
        plane.origin = plane.at(first_column, 0);
        plane
    }
}

/// A plane by its depth at an anchor pixel, relative to that of the first corner, and its gradients, modulo 2^32.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
struct AnchoredPlane {
    column: i32,
    row: i32,
    depth: Wrapping<u32>,
    per_column: Wrapping<u32>,
    per_row: Wrapping<u32>,
}

impl AnchoredPlane {
    /// The plane for the depth of the first corner.
    fn with_corner<D: DepthWidth>(self, corner: D) -> DepthPlane {
        self.with_value(rounded::<D>(corner).0)
    }

    /// The plane for a number of the first corner, with its fractional bits.
    fn with_value(self, value: u32) -> ScreenPlane {
        let origin = Wrapping(value) + self.depth
            - self.per_column * Wrapping(self.column as u32)
            - self.per_row * Wrapping(self.row as u32);
        ScreenPlane {
            origin,
            per_column: self.per_column,
            per_row: self.per_row,
        }
    }
}

/// A corner's depth with fractional bits; u16 is rounded to the nearest unit when the fraction is cut off.
#[inline]
fn rounded<D: DepthWidth>(corner: D) -> Wrapping<u32> {
    Wrapping((corner.units() as u32) << D::FRACTION_BITS) + rounding::<D>()
}

/// What is added to a depth with fractional bits so that cutting them off rounds it to the nearest.
#[inline]
pub(super) const fn rounding<D: DepthWidth>() -> Wrapping<u32> {
    Wrapping(if D::FRACTION_BITS == 16 { 1 << 15 } else { 0 })
}

/// The gradients of a face in 12.4 positions and 16-bit depth, in 1/65,536 unit a pixel: below 2^30 in size.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) struct SmallPlane {
    per_column: i32,
    per_row: i32,
}

/// A face in 12.4 positions, of which no corner is 1,024 pixels or more beside the top one, or 2,048 below it.
#[derive(Debug, Copy, Clone)]
pub(super) struct SmallFace {
    right: Position,
    left: Position,
    area: i32,
}

/// The reciprocal of an area in 1/256 square pixel below 2^21, which is 4,096 square pixels: times 2^(shift + 11), 2^62 / area.
#[derive(Debug, Copy, Clone)]
pub(super) struct AreaReciprocal {
    reciprocal: i32,
    shift: u32,
}

impl SmallFace {
    /// `None` for a face that is not small: one whose edges are short is.
    #[inline]
    pub(super) fn new(sides: &Sides, is_short: bool) -> Option<Self> {
        const LIMIT: i32 = 1 << 14;
        let Sides { right, left, .. } = *sides;
        let from_least = |difference: i32| (difference + LIMIT) as u32;
        // No corner is above the top one.
        let is_small =
            || (from_least(right.x) | from_least(left.x) | right.y as u32 | left.y as u32) < 2 * LIMIT as u32;
        if !is_short && !is_small() {
            return None;
        }
        // Widths up to 2^14 and heights below 2^15.
        let area = right.x * left.y - left.x * right.y;
        Some(Self { right, left, area })
    }

    /// The reciprocal of the area, right to 2^-28: one 32-bit division. `None` for a greater area, which a face with short
    /// edges does not have.
    #[inline]
    pub(super) fn reciprocal(&self, is_short: bool) -> Option<AreaReciprocal> {
        let zeros = leading_zeros(self.area as u32);
        if !is_short && zeros < 11 {
            return None;
        }
        let shift = zeros - 11;
        Some(AreaReciprocal {
            reciprocal: reciprocal_32(((self.area as u32) << 11) << (shift & 31)),
            shift,
        })
    }

    /// The gradients of a number of the corners, from the top one on, below 2^16 in size and in their differences. `None` where
    /// one is steeper than 1,024 units a pixel.
    ///
    /// A gradient is wrong by 5/65,536 at most, and 1,024 columns and rows away the number by 1/6, 1,024 columns and 2,047 rows
    /// away by 1/4; in a face as large as a display's by far less.
    #[inline]
    pub(super) fn gradients(
        &self,
        [top, right_value, left_value]: [i32; 3],
        reciprocal: impl FnOnce() -> Option<AreaReciprocal>,
    ) -> Option<SmallPlane> {
        let Self { right, left, area } = *self;
        let (z1, z2) = (right_value - top, left_value - top);
        // Widths up to 2^14, heights below 2^15 and differences below 2^16, z1 - z2 too: products and their differences are
        // below 2^31.
        let difference = |a: i32, b: i32, c: i32, d: i32| a * b - c * d;
        let numerator_x = difference(z1, left.y, z2, right.y);
        let numerator_y = difference(right.x, z2, left.x, z1);
        // numerator / area must be below 2^10.
        let too_steep = |numerator: i32| ((numerator >> 10) + area) as u32 >= (area as u32) << 1;
        if too_steep(numerator_x) || too_steep(numerator_y) {
            return None;
        }
        let AreaReciprocal { reciprocal, shift } = reciprocal()?;
        // numerator * 2^20 / area = numerator * reciprocal * 2^(20 + shift + 11 - 62), where numerator * 2^shift fits.
        let gradient = |numerator: i32| multiply_shift(numerator << (shift & 31), reciprocal, 32) << 1;
        Some(SmallPlane {
            per_column: gradient(numerator_x),
            per_row: gradient(numerator_y),
        })
    }
}

impl SmallPlane {
    /// The plane with this value at a corner.
    #[inline]
    pub(super) fn through(self, position: Position, value: i32) -> ScreenPlane {
        ScreenPlane {
            origin: Wrapping((value << 16) as u32) - self.origin_to(position),
            per_column: Wrapping(self.per_column as u32),
            per_row: Wrapping(self.per_row as u32),
        }
    }

    /// The depth at a position in 12.4 less that at column 0 of row 0, modulo 2^32, rounded down.
    #[inline]
    fn origin_to(self, position: Position) -> Wrapping<u32> {
        if HAS_DIVIDER {
            self.origin_to_by_long_products(position)
        } else {
            self.origin_to_by_parts(position)
        }
    }

    #[inline]
    fn origin_to_by_long_products(self, Position { x, y }: Position) -> Wrapping<u32> {
        // Twelve bits more cost nothing, where 16-bit positions would be widened once more. Below 2^30 * 2^28 each.
        let sum = i64::from(self.per_column) * i64::from(x << 12) + i64::from(self.per_row) * i64::from(y << 12);
        Wrapping((sum >> 16) as u32)
    }

    /// What the plane gains from the origin to a position, the same integer as by long products, in products of 32 bits.
    #[inline]
    fn origin_to_by_parts(self, Position { x, y }: Position) -> Wrapping<u32> {
        let product = |gradient: i32, units: i32| {
            let (whole, part) = (units >> 4, units & 15);
            let pixels = Wrapping(gradient) * Wrapping(whole) + Wrapping((gradient >> 4) * part);
            (pixels, (gradient & 15) * part)
        };
        let ((columns, rest_x), (rows, rest_y)) = (product(self.per_column, x), product(self.per_row, y));
        let sum = columns + rows + Wrapping((rest_x + rest_y) >> 4);
        Wrapping(sum.0 as u32)
    }
}

/// The plane of any face at any precision, by 64-bit divisions. The anchor is the pixel of the viewport that is nearest
/// to `after`.
fn wide_plane<S: ScreenPrecision, D: DepthWidth>(sides: &Sides, values: [i32; 3], viewport: &Window) -> AnchoredPlane {
    let Sides { top, right, left } = *sides;
    let after = PixelAfter::of::<S>(top);
    let [z0, z1, z2] = values;
    let (z1, z2) = (z1 - z0, z2 - z0);
    // Positions below 2^23 and depths below 2^24: a difference of products is below 2^48.
    let difference = |a: i32, b: i32, c: i32, d: i32| i64::from(a) * i64::from(b) - i64::from(c) * i64::from(d);
    let area = difference(right.x, left.y, left.x, right.y).max(1);
    let numerator_x = difference(z1, left.y, z2, right.y);
    let numerator_y = difference(right.x, z2, left.x, z1);
    let per_column = Quotient::new::<S, D>(numerator_x << S::FRACTION_BITS, area);
    let per_row = Quotient::new::<S, D>(numerator_y << S::FRACTION_BITS, area);
    let column = after.column.max(viewport.left).min(viewport.right);
    let row = after.row.max(viewport.top).min(viewport.bottom);
    let (right, down) = (column - after.column, row - after.row);
    // Rests are below 2^46 and pixels below 2^14, so that three terms below 2^61 are added.
    let rest = numerator_x * i64::from(after.right)
        + numerator_y * i64::from(after.down)
        + per_column.rest * i64::from(right)
        + per_row.rest * i64::from(down);
    let mut to_pixel = Quotient::new::<S, D>(rest, area);
    to_pixel.whole += per_column.whole * Wrapping(right as u32) + per_row.whole * Wrapping(down as u32);
    AnchoredPlane {
        column,
        row,
        depth: to_pixel.rounded::<S, D>(area),
        per_column: per_column.rounded::<S, D>(area),
        per_row: per_row.rounded::<S, D>(area),
    }
}

/// The plane of an attribute of any face, with 16 fractional bits, by long divisions. The sides are those of rows that begin at
/// column 0.
#[cold]
#[inline(never)]
pub(super) fn wide_attribute_plane<S: ScreenPrecision>(
    sides: &Sides,
    values: [i32; 3],
    viewport: &Window,
    first_column: i32,
) -> ScreenPlane {
    let anchored = wide_plane::<S, u16>(sides, values, viewport);
    let mut plane = anchored.with_value((values[0] << 16) as u32);
    plane.origin = plane.at(first_column, 0);
    plane
}

/// An exact quotient: a whole part modulo 2^32, and a rest below the denominator.
#[derive(Debug, Copy, Clone)]
struct Quotient {
    whole: Wrapping<u32>,
    rest: i64,
}

impl Quotient {
    #[inline]
    fn new<S: ScreenPrecision, D: DepthWidth>(numerator: i64, denominator: i64) -> Self {
        if S::FRACTION_BITS <= 4 && D::FRACTION_BITS == 16 {
            // Few faces come here. Differences of positions are at most 32,752, so an area is below 2^30.
            let (whole, rest) = divide_long(numerator, denominator as i32);
            return Self {
                whole: Wrapping(whole as u32),
                rest: rest.into(),
            };
        }
        let whole = numerator.div_euclid(denominator);
        Self {
            whole: Wrapping(whole as u32),
            rest: numerator - whole * denominator,
        }
    }

    /// The quotient with `D::FRACTION_BITS` fractional bits, rounded to the nearest, modulo 2^32.
    #[inline(never)]
    fn rounded<S: ScreenPrecision, D: DepthWidth>(self, denominator: i64) -> Wrapping<u32> {
        // A rest below 2^46 has room for 16 more bits.
        let rounded = (self.rest << D::FRACTION_BITS) + (denominator >> 1);
        let fraction = Self::new::<S, D>(rounded, denominator).whole;
        Wrapping(self.whole.0 << D::FRACTION_BITS) + fraction
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{geometry::Sub4, visible::active_face::from_top};

    /// xorshift32 (Marsaglia 2003).
    fn numbers() -> impl FnMut() -> i32 {
        let mut state = 0x0123_4567u32;
        move || {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            state as i32
        }
    }

    #[test]
    fn long_products_and_parts_give_the_same() {
        let mut next = numbers();
        for _ in 0..200_000 {
            let plane = SmallPlane {
                per_column: next() >> 1,
                per_row: next() >> 1,
            };
            let position = Position {
                x: next() >> 15,
                y: next() >> 16,
            };
            let long = plane.origin_to_by_long_products(position);
            assert_eq!(long, plane.origin_to_by_parts(position), "{plane:?} {position:?}");
        }
    }

    #[test]
    fn small_planes_are_the_wide_ones_within_five_steps() {
        let mut next = numbers();
        let viewport = Window {
            left: -1024,
            top: -1024,
            right: 1023,
            bottom: 1023,
        };
        let mut compared = 0;
        for round in 0..100_000 {
            let size = 1 << (round % 9 + 5);
            let mut corner = || ScreenVertex::<Sub4, u16> {
                x: (next() % size) as i16,
                y: (next() % size) as i16,
                z: next() as u16,
            };
            let (a, b, c) = (corner(), corner(), corner());
            let [a, b, c] = from_top([&a, &b, &c]);
            let sides = Sides::of([a, b, c], 0);
            let Sides { right, left, .. } = sides;
            if right.x * left.y - left.x * right.y <= 0 {
                continue;
            }
            if let Some(small) = DepthPlane::small([a, b, c], &sides, false) {
                let wide = DepthPlane::wide([a, b, c], &viewport, 0);
                let close =
                    |small: Wrapping<u32>, wide: Wrapping<u32>, most: i32| ((small - wide).0 as i32).abs() <= most;
                assert!(close(small.per_column, wide.per_column, 5), "{a:?} {b:?} {c:?}");
                assert!(close(small.per_row, wide.per_row, 5), "{a:?} {b:?} {c:?}");
                // At the corner, where both begin.
                let (column, row) = (sides.top.x >> 4, sides.top.y >> 4);
                assert!(
                    close(small.at(column, row), wide.at(column, row), 8),
                    "{a:?} {b:?} {c:?}"
                );
                compared += 1;
            }
        }
        assert!(compared > 10_000, "{compared}");
    }
}
