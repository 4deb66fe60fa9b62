//! No shortcuts.

use core::marker::PhantomData;

use crate::scene::Look;

/// The [`Look`] `L` without the shortcuts that a frame may allow ([`Look::HURRIES`]): the picture is the same, bit for bit, and
/// takes longer. To see what the shortcuts save, and in tests.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Unhurried<L>(PhantomData<L>);

impl<L: Look> Look for Unhurried<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = L::Silhouettes;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = false;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
