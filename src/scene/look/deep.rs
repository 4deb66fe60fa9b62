//! Depths of 32 bits.

use core::marker::PhantomData;

use crate::scene::Look;

/// The [`Look`] `L` with depths of 32 bits instead of 16: 256 times finer, for scenes that reach far. A vertex takes 8 bytes
/// (12 where it is [`Fine`](crate::scene::Fine)), a column of the depth row 4.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Deep<L>(PhantomData<L>);

impl<L: Look> Look for Deep<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = u32;
    type Counting = L::Counting;
    type Silhouettes = L::Silhouettes;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
