//! Textures of texels that are words of the display's colour: the fastest, and the largest.

use core::marker::PhantomData;

use crate::{
    shade::texture::{Texture, bits_of},
    surface::{BandColor, PixelWord},
};

/// A [`Texture`] of `WIDTH` x `HEIGHT` texels, powers of two, each a word of the colour `C` ([`BandColor::to_word`]). A picture
/// is the texels row by row; it takes 2 bytes a texel for colours of 16 bits.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Texels<C, const WIDTH: usize, const HEIGHT: usize>(PhantomData<C>);

impl<C: BandColor, const WIDTH: usize, const HEIGHT: usize> Texture for Texels<C, WIDTH, HEIGHT> {
    type Color = C;
    type Image<'a> = &'a [[C::Word; WIDTH]; HEIGHT];
    const COLUMN_BITS: u32 = bits_of(WIDTH);
    const ROW_BITS: u32 = bits_of(HEIGHT);
    const HAS_HOLES: bool = false;

    #[inline(always)]
    fn texel(image: &Self::Image<'_>, column: u32, row: u32) -> Option<C::Word> {
        // Powers of two: the index is inside.
        let row = image.get(row as usize & (HEIGHT - 1))?;
        Some(row.get(column as usize & (WIDTH - 1)).copied().unwrap_or(C::Word::ZERO))
    }
}
