//! No row is drawn in passes.

use core::marker::PhantomData;

use crate::scene::Look;

/// The [`Look`] `L` without passes: where more faces cross a row than there are slots, preparing the frame is an error that
/// says how many would do ([`Look::DRAWS_IN_PASSES`]). Saves about 2 KB of flash.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OnePass<L>(PhantomData<L>);

impl<L: Look> Look for OnePass<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = L::Silhouettes;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = false;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
