//! From font units to pixels, by one factor in fixed point.
//!
//! ```text
//!   font units * 2 * factor / 2^16 = 1/256 pixel        factor = size * 2^16 / (2 * units per em)
//! ```
//!
//! Half a unit is what the point has that is implied between two control points. The factor is rounded down once, so that a
//! length is the exact one, rounded to the nearest 1/256 pixel, within 1/65,536 of 1/256 pixel for each half unit.

use core::num::NonZeroU32;

use fixed::types::U24F8;

use crate::geometry::divide_floor_wide;

/// Fractional bits of the factor.
const FACTOR_BITS: u32 = 16;

/// The largest size, 16,384 pixels in 1/256 pixel: no glyph of a larger one would be in the domain of antialiasing.
const LARGEST: u32 = 1 << 22;

/// The farthest that the pen goes, in half units. No visible text is so long.
const FARTHEST: i64 = 1 << 30;

/// How long half a font unit is.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(in crate::draw) struct Scale {
    /// In 1/65,536 of 1/256 pixel; 0 where nothing can be drawn.
    factor: u32,
}

impl Scale {
    /// The scale of a size, in pixels of the em square. Cost: a division.
    pub(super) fn new(size: U24F8, units_per_em: u16) -> Self {
        let half_units = NonZeroU32::new(2 * u32::from(units_per_em));
        let numerator = i64::from(size.to_bits().min(LARGEST)) << FACTOR_BITS;
        let factor = half_units.map_or(0, |half_units| divide_floor_wide(numerator, half_units).0);
        Self {
            // An em square of less than 64 units in a size of thousands of pixels.
            factor: u32::try_from(factor).unwrap_or(u32::MAX),
        }
    }

    /// The word that a picture keeps.
    pub(in crate::draw) const fn to_word(self) -> u32 {
        self.factor
    }

    /// The scale of a word.
    pub(in crate::draw) const fn of_word(factor: u32) -> Self {
        Self { factor }
    }

    /// A length in half units, in 1/256 pixel, rounded to the nearest, halves up. Longer half units never give a shorter length.
    #[inline(always)]
    pub(super) fn length(self, half_units: i64) -> i64 {
        let half_units = half_units.clamp(-FARTHEST, FARTHEST);
        (half_units * i64::from(self.factor) + (1 << (FACTOR_BITS - 1))) >> FACTOR_BITS
    }

    /// A coordinate of a point in half units, in 1/256 pixel, rounded to the nearest, halves up.
    #[inline(always)]
    pub(super) fn coordinate(self, half_units: i32) -> i64 {
        (i64::from(half_units) * i64::from(self.factor) + (1 << (FACTOR_BITS - 1))) >> FACTOR_BITS
    }

    /// The first and the last half units whose lengths lie between the lower and the upper side of the row so many rows above the
    /// baseline, or are near these; the first is larger where nothing can be drawn. Cost: a division.
    pub(in crate::draw) fn half_units_in_row(self, above_baseline: i32) -> [i32; 2] {
        let Some(factor) = NonZeroU32::new(self.factor) else {
            return [0, -1];
        };
        // Half units of 1/256 pixel, with as many fractional bits; too many by less than one of them.
        let inverse = i64::from(u32::MAX / factor) + 1;
        let at = |units: i64| units.saturating_mul(inverse) >> FACTOR_BITS;
        let (bottom, top) = (i64::from(above_baseline) * 256, (i64::from(above_baseline) + 1) * 256);
        // What the inverse has too many, the unit that rounding may move a point by, and what shifting cut off.
        let more = |units: i64| (units.abs() >> FACTOR_BITS) + at(1) + 2;
        let side = |side: i64| side.min(i32::MAX.into()).max(i32::MIN.into()) as i32;
        [side(at(bottom) - more(bottom)), side(at(top) + more(top))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_em_square_is_as_large_as_the_size() {
        for units in [1, 16, 100, 1_000, 2_048, 65_535] {
            for size in [0.0, 0.25, 1.0, 7.3, 24.0, 333.3] {
                let size = U24F8::from_num(size);
                let scale = Scale::new(size, units);
                let em = scale.length(2 * i64::from(units));
                let bits = i64::from(size.to_bits());
                // Rounded down by less than 1/65,536 for each half unit.
                assert!((bits - 2..=bits).contains(&em), "{units} units at {size}: {em}");
            }
        }
        assert_eq!(Scale::new(U24F8::ONE, 0).length(1_000), 0);
        assert_eq!(Scale::new(U24F8::MAX, 1).factor, u32::MAX);
    }

    /// What does not lie in the units of a row has no length between its sides.
    #[test]
    fn the_units_of_a_row_are_all_of_them() {
        for factor in [1, 2, 77, 40_000, 65_536, 99_999, 1 << 21, u32::MAX] {
            let scale = Scale { factor };
            for row in [-31, -8, -1, 0, 1, 5, 90] {
                let units = scale.half_units_in_row(row);
                let is_in_row = |units: i32| {
                    let length = scale.coordinate(units);
                    (256 * i64::from(row)..=256 * (i64::from(row) + 1)).contains(&length)
                };
                for near in units {
                    for units_near in near.saturating_sub(2_000)..=near.saturating_add(2_000) {
                        let is_possible = units_near.unsigned_abs() <= 1 << 17;
                        assert!(
                            !is_possible || !is_in_row(units_near) || (units[0]..=units[1]).contains(&units_near),
                            "{units_near} not in {units:?} at {factor} in row {row}"
                        );
                    }
                }
            }
        }
    }
}
