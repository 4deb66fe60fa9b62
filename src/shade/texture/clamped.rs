//! Textures that do not repeat.

use core::marker::PhantomData;

use crate::shade::{
    InstructionSet,
    texture::{Texture, WordOf},
};

/// The [`Texture`] `T` that ends in the texels at its edges: beyond them, these go on for ever.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Clamped<T>(PhantomData<T>);

impl<T: Texture> Texture for Clamped<T> {
    type Color = T::Color;
    type Image<'a> = T::Image<'a>;
    const COLUMN_BITS: u32 = T::COLUMN_BITS;
    const ROW_BITS: u32 = T::ROW_BITS;
    const REPEATS: bool = false;
    const HAS_HOLES: bool = T::HAS_HOLES;

    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        T::instructions(set).saturating_add(set.of([10, 8]))
    }

    #[inline(always)]
    fn texel(image: &Self::Image<'_>, column: u32, row: u32) -> Option<WordOf<T>> {
        T::texel(image, column, row)
    }

    #[inline(always)]
    fn column(column: i32) -> u32 {
        column.clamp(0, (1 << T::COLUMN_BITS) - 1) as u32
    }

    #[inline(always)]
    fn row(row: i32) -> u32 {
        row.clamp(0, (1 << T::ROW_BITS) - 1) as u32
    }
}
