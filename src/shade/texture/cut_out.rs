//! Textures with holes, for leaves, fences and letters on two triangles.

use core::marker::PhantomData;

use crate::{
    shade::{
        InstructionSet,
        texture::{Indexed, IndexedImage, Texture},
    },
    surface::BandColor,
};

/// The [`Indexed`] texture `T` where colour 0 of the palette is a hole: what is behind is seen there, and neither colour nor
/// depth is stored.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CutOut<T>(PhantomData<T>);

impl<C: BandColor, const BYTES: usize, const HEIGHT: usize, const COLORS: usize> Texture
    for CutOut<Indexed<C, BYTES, HEIGHT, COLORS>>
{
    type Color = C;
    type Image<'a> = IndexedImage<'a, C, BYTES, HEIGHT, COLORS>;
    const COLUMN_BITS: u32 = Indexed::<C, BYTES, HEIGHT, COLORS>::COLUMN_BITS;
    const ROW_BITS: u32 = Indexed::<C, BYTES, HEIGHT, COLORS>::ROW_BITS;

    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        set.of([22, 11])
    }

    #[inline(always)]
    fn texel(image: &Self::Image<'_>, column: u32, row: u32) -> Option<C::Word> {
        match Indexed::index(image, column, row) {
            0 => None,
            index => image.palette.get(index).copied(),
        }
    }
}
