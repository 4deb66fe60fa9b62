//! Bilinear filtering: a pixel is the mean of the four texels around it, weighed by how near their centres are.
//!
//! ```text
//!     A-----B     weights of A, B, C, D, with fractions f and g to the right and down:
//!     |  +  |     (1 - f)(1 - g), f(1 - g), (1 - f)g, fg
//!     C-----D
//! ```
//!
//! Guarantees: fractions have 5 bits; at the centre of a texel it is the texel itself, and between two texels of one colour it
//! is that colour. Levels are rounded down twice, so that they are less than 2 too low for those fractions, whose own rounding
//! moves a level by up to 1/16 of the range of the four.
//!
//! Cost of a pixel: four texels and three mixed words.
//!
//! Source: Catmull and Smith (1980), "3-D transformations of images in scanline order"; Heckbert (1989), "Fundamentals of
//! texture mapping and image warping".

use core::{marker::PhantomData, num::Wrapping};

use crate::{
    shade::{
        ChannelColor, InstructionSet,
        layout::Layout,
        texture::{COORDINATE_BITS, Sampler, Texture, WordOf},
    },
    surface::BandColor,
};

/// The texture `T` whose pixels are mixed of the four texels around them, so that large texels have soft edges. Where one of
/// them is a hole, the pixel is the nearest texel.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bilinear<T>(PhantomData<T>);

/// Bits of the fractions of a texel.
const FRACTION_BITS: u32 = 5;

impl<T: Texture<Color: ChannelColor>> Sampler for Bilinear<T> {
    type Texture = T;
    const HAS_HOLES: bool = T::HAS_HOLES;

    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        T::instructions(set).saturating_mul(4).saturating_add(set.of([57, 28]))
    }

    #[inline(always)]
    fn sample(image: &T::Image<'_>, coordinates: [i32; 2]) -> Option<WordOf<T>> {
        let [u, v] = coordinates;
        let (column, from_left) = texel_and_fraction::<T>(u, T::COLUMN_BITS);
        let (row, from_top) = texel_and_fraction::<T>(v, T::ROW_BITS);
        let (left, right) = (T::column(column), T::column(column.wrapping_add(1)));
        let (top, bottom) = (T::row(row), T::row(row.wrapping_add(1)));
        let texels = (
            T::texel(image, left, top),
            T::texel(image, right, top),
            T::texel(image, left, bottom),
            T::texel(image, right, bottom),
        );
        match texels {
            (Some(a), Some(b), Some(c), Some(d)) => {
                let mixed = mixed::<T::Color>;
                Some(mixed(mixed(a, b, from_left), mixed(c, d, from_left), from_top))
            }
            _ => <T as Sampler>::sample(image, coordinates),
        }
    }
}

/// A word between two.
#[inline(always)]
fn mixed<C: ChannelColor>(
    one: <C as BandColor>::Word,
    other: <C as BandColor>::Word,
    factor: u32,
) -> <C as BandColor>::Word {
    C::Layout::mixed(one, other, factor)
}

/// The texel of a texture whose centre is the last one before a coordinate, and how far the coordinate is beyond it, in parts of
/// a texel.
#[inline(always)]
fn texel_and_fraction<T: Texture>(coordinate: i32, texel_bits: u32) -> (i32, u32) {
    let shift = COORDINATE_BITS - texel_bits - FRACTION_BITS;
    const HALF: i32 = 1 << (FRACTION_BITS - 1);
    let from_centre = if T::REPEATS {
        // Wraps left of the least coordinates to texels of the same number, modulo the texture.
        (Wrapping(coordinate) - Wrapping(HALF << shift)).0 >> shift
    } else {
        // Counted from the centre of a texel only where there is room for it, which takes two instructions more.
        (coordinate >> shift) - HALF
    };
    (
        from_centre >> FRACTION_BITS,
        from_centre as u32 & ((1 << FRACTION_BITS) - 1),
    )
}

#[cfg(test)]
mod tests {
    use embedded_graphics::pixelcolor::Gray8;

    use super::*;
    use crate::shade::{Clamped, Texels};

    /// Half a texel before the least coordinate is still beyond the left edge.
    #[test]
    fn the_least_coordinates_are_beyond_the_upper_left_edges() {
        let image = &[[1, 2], [3, 4]];
        let sample = Bilinear::<Clamped<Texels<Gray8, 2, 2>>>::sample;
        assert_eq!(sample(&image, [i32::MIN; 2]), Some(1));
        assert_eq!(sample(&image, [i32::MAX; 2]), Some(4));
    }

    /// Also where half a texel to the left or above there are no coordinates any more.
    #[test]
    fn a_texture_further_all_texels_repeat() {
        const TEXTURE: i32 = 1 << COORDINATE_BITS;
        let image = &[[10, 200, 90, 30], [240, 60, 0, 120]];
        let sample = |u, v| Bilinear::<Texels<Gray8, 4, 2>>::sample(&image, [u, v]);
        for down in (0..TEXTURE).step_by(TEXTURE as usize / 64) {
            for right in (0..TEXTURE).step_by(TEXTURE as usize / 128) {
                let expected = sample(right, down);
                for [u, v] in [
                    [i32::MIN, 0],
                    [0, i32::MIN],
                    [i32::MIN; 2],
                    [-TEXTURE; 2],
                    [TEXTURE, i32::MIN],
                ] {
                    assert_eq!(sample(u + right, v + down), expected, "{u} + {right}, {v} + {down}");
                }
            }
        }
    }
}
