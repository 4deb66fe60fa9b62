//! Textures of few colours: a texel is the number of a colour in a palette, so that it takes 1, 2, 4 or 8 bits.
//!
//! Source: colour look-up tables of frame buffers (Kajiya, Sutherland, Cheadle 1975, "A random-access video frame buffer").

use core::marker::PhantomData;

use crate::{
    shade::{
        InstructionSet,
        texture::{Texture, bits_of},
    },
    surface::BandColor,
};

/// A [`Texture`] whose texels are numbers of `COLORS` colours of a palette: 2, 4, 16 or 256, which take 1, 2, 4 or 8 bits a
/// texel.
///
/// A row has `BYTES` bytes, a power of two, and 1, 2, 4 or 8 times as many texels; `HEIGHT` is a power of two. Of a byte, the
/// highest bits are the leftmost texel, as in embedded-graphics' `ImageRaw`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Indexed<C, const BYTES: usize, const HEIGHT: usize, const COLORS: usize>(PhantomData<C>);

/// A picture for [`Indexed`] textures.
#[derive(Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct IndexedImage<'a, C: BandColor, const BYTES: usize, const HEIGHT: usize, const COLORS: usize> {
    /// The numbers of the texels' colours, row by row; of a byte, the highest bits are the leftmost texel.
    pub indices: &'a [[u8; BYTES]; HEIGHT],
    /// The colours, as words ([`BandColor::to_word`]).
    pub palette: &'a [C::Word; COLORS],
}

impl<C: BandColor, const BYTES: usize, const HEIGHT: usize, const COLORS: usize> Copy
    for IndexedImage<'_, C, BYTES, HEIGHT, COLORS>
{
}

impl<C: BandColor, const BYTES: usize, const HEIGHT: usize, const COLORS: usize> Clone
    for IndexedImage<'_, C, BYTES, HEIGHT, COLORS>
{
    fn clone(&self) -> Self {
        *self
    }
}

impl<C: BandColor, const BYTES: usize, const HEIGHT: usize, const COLORS: usize> Indexed<C, BYTES, HEIGHT, COLORS> {
    /// Bits of a texel, and the exponent of that power of two.
    const BITS: u32 = {
        assert!(
            COLORS == 2 || COLORS == 4 || COLORS == 16 || COLORS == 256,
            "a palette has 2, 4, 16 or 256 colours"
        );
        COLORS.ilog2()
    };

    /// Exponent of the number of texels in a byte.
    const TEXELS_IN_BYTE: u32 = 3 - Self::BITS.ilog2();

    /// The number of the colour of a texel.
    #[inline(always)]
    pub(super) fn index(image: &IndexedImage<'_, C, BYTES, HEIGHT, COLORS>, column: u32, row: u32) -> usize {
        let byte = image
            .indices
            // Powers of two: the index is inside.
            .get(row as usize & (HEIGHT - 1))
            .and_then(|row| row.get((column >> Self::TEXELS_IN_BYTE) as usize & (BYTES - 1)))
            .copied()
            .unwrap_or(0);
        let from_left = column & ((1 << Self::TEXELS_IN_BYTE) - 1);
        let shift = 8 - Self::BITS - from_left * Self::BITS;
        usize::from(byte) >> shift & (COLORS - 1)
    }
}

impl<C: BandColor, const BYTES: usize, const HEIGHT: usize, const COLORS: usize> Texture
    for Indexed<C, BYTES, HEIGHT, COLORS>
{
    type Color = C;
    type Image<'a> = IndexedImage<'a, C, BYTES, HEIGHT, COLORS>;
    const COLUMN_BITS: u32 = bits_of(BYTES) + Self::TEXELS_IN_BYTE;
    const ROW_BITS: u32 = bits_of(HEIGHT);
    const HAS_HOLES: bool = false;

    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        set.of([18, 11])
    }

    #[inline(always)]
    fn texel(image: &Self::Image<'_>, column: u32, row: u32) -> Option<C::Word> {
        image.palette.get(Self::index(image, column, row)).copied()
    }
}
